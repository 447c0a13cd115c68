//! Pressure on the shell or on some of its cells: dead (reference normal and area) or follower (present normal and area).

use sph_core::{Cell, Vec3};

use crate::conditions::loads::{Block, Body, Load, place_block};
use crate::conditions::spread::check_cells;
use crate::error::ShellError;
use crate::reference::Reference;

/// Pressure along the normal of the cells; positive pushes along the normal.
///
/// Each cell hands the area vector of its (reference or present) polygon in equal parts to its
/// corners. For a follower load on a closed surface this is the derivative of the enclosed
/// polyhedral volume up to the warping of the cells.
#[derive(Clone, Copy, Debug)]
pub struct Pressure {
    /// Pressure \[F/L²\].
    pub value: f64,
    /// Whether normal and area follow the motion.
    pub follower: bool,
}

/// The same on some cells.
///
/// Follower pressure on a patch within a shell has no potential: its edge is free to the pressure, as that of a sheet is.
#[derive(Clone, Debug)]
pub struct PressurePatch {
    /// The pressure.
    pub pressure: Pressure,
    /// Cells on which it acts, each once.
    pub cells: Vec<u32>,
}

impl Pressure {
    /// Adds the load of some cells.
    fn add_of<'a>(
        &self,
        cells: impl IntoIterator<Item = &'a Cell>,
        scale: f64,
        body: &Body<'_>,
        forces: &mut [[f64; 6]],
    ) {
        let cloud = &body.reference.cloud;
        let place = |a: u32| -> Vec3 {
            if self.follower { position(&body.state[a as usize]) } else { cloud.positions[a as usize] }
        };
        for cell in cells {
            // Half the product of the diagonals; a triangle repeats its last corner.
            let [p, q, r, s] = cell.corners.map(place);
            let area = (r - p).cross(&(s - q)) * 0.5;
            let part = area * (scale * self.value / f64::from(cell.count));
            for &corner in &cell.corners[..cell.count as usize] {
                for i in 0..3 {
                    forces[corner as usize][i] += part[i];
                }
            }
        }
    }

    /// With the diagonals u = x_r − x_p and v = x_s − x_q of a cell of n corners every corner bears `f = p (u × v)/2n`, so
    /// `∂f/∂x_r = −∂f/∂x_p = −(p/2n) [v]×` and `∂f/∂x_s = −∂f/∂x_q = (p/2n) [u]×`, `[u]× y = u × y`.
    fn stiffness_of<'a>(
        &self,
        cells: impl IntoIterator<Item = &'a Cell>,
        scale: f64,
        body: &Body<'_>,
        put: &mut dyn FnMut(u32, u32, &Block),
    ) {
        if !self.follower {
            return;
        }
        for cell in cells {
            let [p, q, r, s] = cell.corners.map(|a| position(&body.state[a as usize]));
            let factor = 0.5 * scale * self.value / f64::from(cell.count);
            let [across_u, across_v] = [r - p, s - q].map(|diagonal| diagonal.cross_matrix() * factor);
            let by_corner = [across_v, -across_u, -across_v, across_u];
            for (&moved, change) in cell.corners.iter().zip(&by_corner) {
                let block = place_block(0, 0, change);
                for &pushed in &cell.corners[..cell.count as usize] {
                    put(pushed, moved, &block);
                }
            }
        }
    }
}

impl Load for Pressure {
    fn add(&self, scale: f64, body: &Body<'_>, forces: &mut [[f64; 6]]) {
        self.add_of(&body.reference.cloud.cells, scale, body, forces);
    }

    fn stiffness(&self, scale: f64, body: &Body<'_>, put: &mut dyn FnMut(u32, u32, &Block)) {
        self.stiffness_of(&body.reference.cloud.cells, scale, body, put);
    }

    fn check(&self, _: &Reference) -> Result<(), ShellError> {
        Ok(())
    }
}

impl PressurePatch {
    fn own<'a>(&'a self, body: &'a Body<'_>) -> impl Iterator<Item = &'a Cell> {
        self.cells.iter().map(|&cell| &body.reference.cloud.cells[cell as usize])
    }
}

impl Load for PressurePatch {
    fn add(&self, scale: f64, body: &Body<'_>, forces: &mut [[f64; 6]]) {
        self.pressure.add_of(self.own(body), scale, body, forces);
    }

    fn stiffness(&self, scale: f64, body: &Body<'_>, put: &mut dyn FnMut(u32, u32, &Block)) {
        self.pressure.stiffness_of(self.own(body), scale, body, put);
    }

    fn check(&self, reference: &Reference) -> Result<(), ShellError> {
        check_cells("a pressure", &self.cells, &reference.cloud)
    }
}

fn position(row: &[f64; 6]) -> Vec3 {
    Vec3::new(row[0], row[1], row[2])
}
