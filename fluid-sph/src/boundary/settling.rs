//! Where structures are to be at the end of a step, kept until its drift by one who marches a fluid with others: all may be dealt out
//! anew before it, where everything stood when forces were found.

use explicit_dynamics::BoundaryState;
use sph_core::Vec3;

use crate::boundary::pending::Pending;
use crate::boundary::points::Boundary;

impl Boundary {
    /// Keeps where a structure is to be, for [`Boundary::settle`].
    pub fn put_off(&mut self, structure: usize, end: &BoundaryState, velocities: &[[f64; 3]]) {
        let Pending { due, end: own, velocities: kept } = &mut self.pending[structure];
        *due = true;
        own.points.clone_from(&end.points);
        own.middle.clone_from(&end.middle);
        own.normals.clone_from(&end.normals);
        kept.clear();
        kept.extend_from_slice(velocities);
    }

    /// Whether a structure is still to be put where it is to be.
    pub fn is_put_off(&self, structure: usize) -> bool {
        self.pending[structure].due
    }

    /// The greatest way of a point to where it is to be, or to where it comes from so long a time before \[T\], in \[L\]; no end
    /// of way for a place that is no number.
    pub fn way_put_off(&self, dimensions: usize, dt: f64) -> f64 {
        let mut farthest: f64 = 0.0;
        for (structure, Pending { end, velocities, .. }) in
            self.pending.iter().enumerate().filter(|(_, pending)| pending.due)
        {
            let points = &self.points[self.structure(structure)];
            for ((point, end), velocity) in points.iter().zip(&end.points).zip(velocities) {
                let (mut way, mut step) = (Vec3::from(*end) - point, Vec3::from(*velocity) * dt);
                if dimensions == 2 {
                    (way.z, step.z) = (0.0, 0.0);
                }
                for way in [way.norm(), (way - step).norm()] {
                    farthest = farthest.max(if way.is_nan() { f64::INFINITY } else { way });
                }
            }
        }
        farthest
    }

    /// Puts structures where they are to be.
    pub fn settle(&mut self, dimensions: usize) {
        let mut pending = std::mem::take(&mut self.pending);
        for (structure, Pending { due, end, velocities }) in pending.iter_mut().enumerate() {
            if std::mem::take(due) {
                self.set_structure(structure, dimensions, end, velocities);
            }
        }
        self.pending = pending;
    }

    /// Forgets where structures were to be.
    pub fn forget_put_off(&mut self) {
        self.pending.iter_mut().for_each(|pending| pending.due = false);
    }
}
