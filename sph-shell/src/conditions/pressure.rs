//! Pressure on the shell or on some of its cells: dead (reference normal and area) or follower (present normal and area).

use std::ops::Range;

use sph_core::{Cell, Vec3};

use crate::conditions::body::{Block, Body, place_block};
use crate::conditions::loads::{AddLoad, Load, LoadOnShare};
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
    /// What multiplies it at each particle of the shell \[–\]; one everywhere where there is none.
    pub factors: Vec<f64>,
}

impl Pressure {
    /// Adds the load of some cells, times a factor at each corner.
    fn add_of<'a>(
        &self,
        cells: impl IntoIterator<Item = &'a Cell>,
        scale: f64,
        body: &Body<'_>,
        forces: &mut [[f64; 6]],
        factor: impl Fn(u32) -> f64,
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
                let own = part * factor(corner);
                for i in 0..3 {
                    forces[corner as usize][i] += own[i];
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
        factor: impl Fn(u32) -> f64,
    ) {
        if !self.follower {
            return;
        }
        for cell in cells {
            let [p, q, r, s] = cell.corners.map(|a| position(&body.state[a as usize]));
            let each = 0.5 * scale * self.value / f64::from(cell.count);
            let [across_u, across_v] = [r - p, s - q].map(|diagonal| diagonal.cross_matrix() * each);
            let by_corner = [across_v, -across_u, -across_v, across_u];
            for (&moved, change) in cell.corners.iter().zip(&by_corner) {
                for &pushed in &cell.corners[..cell.count as usize] {
                    put(pushed, moved, &place_block(0, 0, &(change * factor(pushed))));
                }
            }
        }
    }
}

impl Load for Pressure {
    fn add(&self, scale: f64, body: &Body<'_>, forces: &mut [[f64; 6]]) {
        self.add_of(&body.reference.cloud.cells, scale, body, forces, |_| 1.0);
    }

    fn on_share(&self, own: &Range<usize>, reference: &Reference) -> Option<LoadOnShare> {
        let cells = (0..reference.cloud.cells.len() as u32).collect();
        PressurePatch { pressure: *self, cells, factors: Vec::new() }.on_share(own, reference)
    }

    fn stiffness(&self, scale: f64, body: &Body<'_>, put: &mut dyn FnMut(u32, u32, &Block)) {
        self.stiffness_of(&body.reference.cloud.cells, scale, body, put, |_| 1.0);
    }

    fn check(&self, _: &Reference) -> Result<(), ShellError> {
        Ok(())
    }
}

impl PressurePatch {
    fn factor(&self, particle: u32) -> f64 {
        self.factors.get(particle as usize).copied().unwrap_or(1.0)
    }

    fn own<'a>(&'a self, body: &'a Body<'_>) -> impl Iterator<Item = &'a Cell> {
        self.cells.iter().map(|&cell| &body.reference.cloud.cells[cell as usize])
    }
}

impl Load for PressurePatch {
    fn add(&self, scale: f64, body: &Body<'_>, forces: &mut [[f64; 6]]) {
        self.pressure.add_of(self.own(body), scale, body, forces, |particle| self.factor(particle));
    }

    fn on_share(&self, own: &Range<usize>, reference: &Reference) -> Option<LoadOnShare> {
        let corners = |cell: u32| reference.cloud.cells[cell as usize].particles();
        let touch = |cell: &u32| corners(*cell).iter().any(|&a| own.contains(&(a as usize)));
        let cells: Vec<u32> = self.cells.iter().copied().filter(touch).collect();
        let reads = cells.iter().flat_map(|&cell| corners(cell)).copied().collect();
        let patch = Self { cells, ..self.clone() };
        let add: AddLoad = Box::new(move |scale, body, forces| patch.add(scale, body, forces));
        Some(LoadOnShare { add, reads })
    }

    fn stiffness(&self, scale: f64, body: &Body<'_>, put: &mut dyn FnMut(u32, u32, &Block)) {
        self.pressure.stiffness_of(self.own(body), scale, body, put, |particle| self.factor(particle));
    }

    fn check(&self, reference: &Reference) -> Result<(), ShellError> {
        let count = reference.cloud.len();
        if !self.factors.is_empty() && self.factors.len() != count {
            let particle = self.factors.len() as u32;
            return Err(ShellError::NoSuchParticle { what: "a factor of a pressure", particle, count });
        }
        check_cells("a pressure", &self.cells, &reference.cloud)
    }
}

fn position(row: &[f64; 6]) -> Vec3 {
    Vec3::new(row[0], row[1], row[2])
}
