//! Contact that stays as it is: what modes and linearised buckling of a touched shell are found with, and how far that holds.

use std::ops::DerefMut;

use contact::FrontChange;
use implicit_statics::Equilibrium;

use crate::Shell;
use crate::packs::Row;
use crate::statics::static_shell::StaticShell;

/// Greatest way of a particle over the thickness in the motion by which rates are found: far above rounding, and all is linear within.
const SMALL: f64 = 1e-6;

impl<S: DerefMut<Target = Shell>> StaticShell<S> {
    /// Freezes contact as it stands in the present state at a level: what touches is a spring from here on, what sticks goes on sticking, and
    /// what is apart stays apart.
    pub fn freeze_contact(&mut self, level: f64) {
        if !self.shell.may_touch() {
            return;
        }
        self.shell.loading.frozen = None;
        self.pattern_changed(level);
        self.evaluate(level);
        let Shell { loading, motion, .. } = &mut *self.shell;
        loading.freeze(level, &motion.state);
    }

    /// The first change of what touched when contact was frozen along a motion from the present state; none where nothing
    /// changes. Of a shell with itself the gaps of particles are seen, up to half of the thickness.
    pub fn first_change(&mut self, motion: &[f64]) -> Option<FrontChange> {
        let largest = motion.iter().fold(0.0_f64, |most, u| most.max(u.abs()));
        if largest == 0.0 || !self.shell.may_touch() {
            return None;
        }
        let part = SMALL * self.shell.thickness() / largest;
        let small: Vec<f64> = motion.iter().map(|u| part * u).collect();
        let (all, rest): (Vec<u32>, _) = ((0..self.shell.len() as u32).collect(), self.save());
        let (here, gaps) = (self.shell.motion.state.to_vec(), self.own_gaps(&all));
        self.update(&small);
        let (there, closer) = (self.shell.motion.state.to_vec(), self.own_gaps(&all));
        self.restore(&rest);
        let ways: Vec<Row> = there
            .iter()
            .zip(&here)
            .map(|(there, here)| std::array::from_fn(|k| (there[k] - here[k]) / part))
            .collect();
        let Shell { loading, reference, motion, .. } = &*self.shell;
        let of_itself = gaps.iter().zip(&closer).enumerate().filter_map(|(a, (gap, closer))| {
            let place = reference.from_zero(motion.place(a));
            FrontChange::of_gap(*gap, (closer - gap) / part, place)
        });
        let of_tools = loading.tools.first_change(&motion.state, &ways);
        of_tools.into_iter().chain(of_itself).reduce(FrontChange::sooner)
    }

    /// Adds to bounds of the sums over rows what contact adds to those of translations where all of the shell touches, at depths out of the barrier.
    pub(super) fn add_contact_bounds(&self, out: &mut [f64]) {
        if !self.shell.may_touch() {
            return;
        }
        let Shell { loading, motion, .. } = &*self.shell;
        let mut aside = motion.state.to_vec();
        aside.iter_mut().for_each(|row| row[0] += self.shell.thickness());
        let mut bounds = vec![[0.0; 6]; aside.len()];
        loading.add_contact_bounds(&aside, &motion.state, &mut bounds);
        for a in 0..self.shell.len() {
            let [force, ..] = self.shell.gathered(a, |a| bounds[a]);
            let bound = -force / self.shell.thickness();
            let own = self.dofs.of(a);
            out[own][..self.basis(a).translations].iter_mut().for_each(|sum| *sum += bound);
        }
    }

    /// Gaps of the shell to itself at particles; none where it may not touch itself.
    fn own_gaps(&self, particles: &[u32]) -> Vec<f64> {
        let own = self.shell.loading.own_contact.as_ref();
        own.map_or_else(Vec::new, |own| own.gaps(particles, &self.shell.motion.state))
    }
}
