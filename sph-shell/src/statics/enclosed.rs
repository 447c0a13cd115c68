//! What is enclosed in the unknowns of statics: the part of its stiffness beside the pattern, and the volume that a correction leads to.

use std::ops::DerefMut;

use implicit_statics::RankOne;

use crate::Shell;
use crate::packs::Row;
use crate::statics::static_shell::StaticShell;

impl<S: DerefMut<Target = Shell>> StaticShell<S> {
    /// The terms `−p′ g gᵀ` of all that is enclosed, at a level.
    pub(super) fn beside(&self, level: f64) -> Vec<RankOne> {
        let body = self.shell.loaded();
        let of = |(factor, rows)| RankOne { factor, along: self.along_unknowns(rows) };
        let enclosed = self.shell.loading.enclosed(level);
        enclosed.map(|(enclosed, share)| of(enclosed.beside_pattern(share, &body))).collect()
    }

    /// Adds what these terms take of the forces while prescribed values go at given rates of all particles.
    pub(super) fn subtract_enclosed_rates(&self, level: f64, rates: &[Row], rows: &mut [Row]) {
        let body = self.shell.loaded();
        for (enclosed, share) in self.shell.loading.enclosed(level) {
            let (factor, gradient) = enclosed.beside_pattern(share, &body);
            let along = factor * volume_rate(&gradient, rates);
            for (sum, part) in rows.iter_mut().zip(&gradient) {
                (0..3).for_each(|k| sum[k] -= along * part[k]);
            }
        }
    }

    /// Keeps the volumes to which a correction leads to the first order; the stiffness goes by them.
    pub(super) fn predict_volumes(&self, increment: &[f64]) {
        let body = self.shell.loaded();
        for (enclosed, _) in self.shell.loading.enclosed(1.0) {
            let mut rows = vec![[0.0; 6]; self.shell.len()];
            enclosed.press(1.0, &body, &mut rows);
            let change: f64 = self.along_unknowns(rows).iter().zip(increment).map(|(g, q)| g * q).sum();
            enclosed.predict(Some(enclosed.volumes(&body).now + change));
        }
    }

    /// Goes by the volumes that there are.
    pub(super) fn forget_volumes(&self) {
        self.shell.loading.enclosed(1.0).for_each(|(enclosed, _)| enclosed.predict(None));
    }

    /// Forces on particles as forces on the unknowns.
    fn along_unknowns(&self, mut rows: Vec<Row>) -> Vec<f64> {
        self.shell.dependents.ties.condense(&self.shell.motion.state, &mut rows, |_, _| ());
        let mut along = vec![0.0; self.dofs.count()];
        self.project(|a| rows[a], &mut along);
        along
    }
}

/// How fast a volume grows, by its gradient and the rates of all particles.
fn volume_rate(gradient: &[Row], rates: &[Row]) -> f64 {
    gradient.iter().zip(rates).map(|(g, rate)| g[0] * rate[0] + g[1] * rate[1] + g[2] * rate[2]).sum()
}
