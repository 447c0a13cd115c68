//! The forces of a linear answer, as a row of numbers and back.

use sph_core::Vec3;
use sph_shell::{PointResult, Shell};

use crate::bodies::point_numbers::POINT_NUMBERS;

/// The forces of a linear answer: all of them grow with the load, none is that of the moved shell.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct LinearForces {
    /// Strains and resultants of every sampling point.
    pub points: Vec<PointResult>,
    /// Reactions of all particles \[F\].
    pub reactions: Vec<Vec3>,
}

impl LinearForces {
    /// Those of the present state.
    pub fn of(shell: &Shell) -> Self {
        let mut points = vec![PointResult::default(); shell.reference().operator.points.len()];
        shell.point_results(&mut points);
        Self { points, reactions: (0..shell.len()).map(|a| shell.reaction(a)).collect() }
    }

    /// All of them in one row.
    pub fn numbers(&self) -> Vec<f64> {
        let mut row: Vec<f64> = self.reactions.iter().flat_map(|force| <[f64; 3]>::from(*force)).collect();
        let mut points = self.points.clone();
        for slot in points.iter_mut().flat_map(slots) {
            row.push(*slot);
        }
        row
    }

    /// Those of a row, in the directions at the points that stand here; none if the row has another length.
    pub fn with_numbers(mut self, row: &[f64]) -> Option<Self> {
        let (reactions, numbers) = row.split_at_checked(3 * self.reactions.len())?;
        if numbers.len() != POINT_NUMBERS * self.points.len() {
            return None;
        }
        for (slot, number) in self.points.iter_mut().flat_map(slots).zip(numbers) {
            *slot = *number;
        }
        self.reactions = reactions.chunks_exact(3).map(Vec3::from_column_slice).collect();
        Some(self)
    }
}

/// The same as numbers.
pub(crate) fn numbers(point: &mut PointResult) -> [f64; POINT_NUMBERS] {
    slots(point).map(|slot| *slot)
}

/// Every number of a point that grows with the load, in one order for writing and reading.
fn slots(point: &mut PointResult) -> [&mut f64; POINT_NUMBERS] {
    let PointResult { membrane, curvature, shear, force, moment, shear_force, t1: _ } = point;
    let ([a, b, c], [d, e, f], [g, h], [i, j, k], [l, m, n], [o, p]) =
        (membrane, curvature, shear, force, moment, shear_force);
    [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p]
}
