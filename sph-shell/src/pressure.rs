//! Pressure on the shell: dead (reference normal and area) or follower (present normal and area).

use sph_core::Vec3;

use crate::{Body, Load, Reference, ShellError};

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

impl Load for Pressure {
    fn add(&self, scale: f64, body: &Body<'_>, forces: &mut [[f64; 6]]) {
        let cloud = &body.reference.cloud;
        let place = |a: u32| -> Vec3 {
            if self.follower {
                let row = &body.state[a as usize];
                Vec3::new(row[0], row[1], row[2])
            } else {
                cloud.positions[a as usize]
            }
        };
        for cell in &cloud.cells {
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

    fn check(&self, _: &Reference) -> Result<(), ShellError> {
        Ok(())
    }
}
