//! The tangent of what systems do to each other under the forces of a small motion, as buckling asks for it.

use super::interaction::Joinable;
use super::system::Several;
use crate::equilibrium::Equilibrium;

impl<S: Joinable + ?Sized> Several<S> {
    /// Lets them act on each other at the end of a motion between two levels, and takes it back; where all places were before it.
    pub(super) fn act_after(&mut self, levels: [f64; 2], motion: &[f64]) -> Vec<Vec<[f64; 3]>> {
        self.act(levels[0]);
        let Self { systems, acting, .. } = self;
        let here = acting.iter_mut().map(|acting| acting.seen(systems)).collect();
        let rest = self.save();
        self.update(motion);
        self.act(levels[1]);
        self.restore(&rest);
        here
    }

    /// Adds the stiffness at places here with the forces that act now, whose entries follow those of the systems.
    pub(super) fn add_stressed(&self, here: &[Vec<[f64; 3]>], values: &mut [f64]) {
        values[self.entries()[self.systems.len()]..].fill(0.0);
        for (acting, here) in self.acting.iter().zip(here) {
            acting.add_stressed(here, &self.systems, &self.first, values);
        }
    }
}
