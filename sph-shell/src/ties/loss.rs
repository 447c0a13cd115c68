//! What one point a cell does not see of the couples that an edge hands over inside cells of its host.

use sph_core::Vec3;

use crate::Shell;
use crate::ties::hanging::{Hanging, Vectors};

/// Energy that the hosts of ties leave out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TieLoss {
    /// Part of the stored energy \[–\]; displacements under loads are too small by as much.
    pub share: f64,
    /// The particle at which most of it is lost.
    pub particle: u32,
}

impl Shell {
    /// Energy of the couples that hang inside cells, of which those do not know, over the energy stored, for the forces last evaluated;
    /// none without ties or at rest.
    ///
    /// A couple c by length at the part s of a cell of length h across the edge makes the moment `M₀ + c` on one side and `M₀` on the other.
    /// The cell's one point sees their mean, and `∫ M²/2D` loses the variance `c² s (1 − s) h/2D` by length of the edge.
    pub fn tie_loss(&self) -> Option<TieLoss> {
        let scales = self.material.scales();
        let lost = |(hanging, row): (&Hanging, &[f64; 6])| {
            let on = |&(cell, weight): &(u32, f64)| {
                weight * self.lost_in(cell as usize, hanging, row) / scales.at(cell as usize).bending
            };
            (hanging.cells.iter().map(on).sum(), hanging.particle)
        };
        let all = self.dependents.ties.hanging.iter().zip(&self.dependents.ties.internal).map(lost);
        let (most, sum) = all
            .fold(((0.0, 0), 0.0), |(most, sum), one| (if one.0 > most.0 { one } else { most }, sum + one.0));
        let share = sum / self.stored_energy();
        share.is_finite().then_some(TieLoss { share, particle: most.1 })
    }

    /// Energy that one cell below a particle does not see, times its stiffness against bending \[F² L²\]; none on its edges.
    fn lost_in(&self, cell: usize, hanging: &Hanging, row: &[f64; 6]) -> f64 {
        let t = hanging.particle as usize;
        let positions = &self.reference.cloud.positions;
        let [l1, l2] = hanging.line;
        // Edges on both sides of the particle are counted in full in the line.
        let width = 0.5 * libm::hypot(l1, l2);
        let direction = |v: &Vectors| (v[1] * l1 + v[2] * l2).normalize();
        let along = direction(&hanging.vectors(&self.reference.rest()));
        let across = self.reference.operator.points[cell].frame.n.cross(&along);
        let along_edge = |b: usize| positions[b].dot(&across);
        let ends = self.reference.cloud.cells[cell].particles().iter().map(|&b| along_edge(b as usize));
        let (low, high) =
            ends.fold((f64::INFINITY, -f64::INFINITY), |(low, high), x| (low.min(x), high.max(x)));
        let before = ((along_edge(t) - low) / (high - low)).clamp(0.0, 1.0);
        let vectors = hanging.vectors(&self.motion.state);
        let (force, on_director) = (Vec3::new(row[0], row[1], row[2]), Vec3::new(row[3], row[4], row[5]));
        let lever = vectors[0] + vectors[3] * hanging.rise(&vectors) - hanging.foot(&self.motion.state);
        let torque = self.director(t).cross(&on_director) + lever.cross(&force);
        let couple = torque.dot(&direction(&vectors));
        couple * couple * before * (1.0 - before) * (high - low) / (2.0 * width)
    }
}
