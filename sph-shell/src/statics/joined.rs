//! The shell as one of several bodies whose equilibria are sought together.

use std::collections::BTreeSet;
use std::ops::DerefMut;

use implicit_statics::Joinable;

use crate::Shell;
use crate::motion::row_of;
use crate::packs::Row;
use crate::statics::static_shell::StaticShell;

impl<S: DerefMut<Target = Shell>> Joinable for StaticShell<S> {
    fn places(&self, particles: &[u32], out: &mut [[f64; 3]]) {
        out.iter_mut().zip(particles).for_each(|(out, &number)| *out = self.shell.place_numbered(number));
    }

    fn put(&mut self, level: f64) {
        StaticShell::put(self, level);
    }

    fn release(&mut self) {
        self.shell.loading.release();
    }

    fn exert(&mut self, particles: &[u32], forces: &[[f64; 3]]) {
        let shell = &mut *self.shell;
        let count = shell.len();
        shell.loading.exert(particles, forces, count);
    }

    /// Unknowns of the particle, of the group that it belongs to, or of all on which it may hang.
    fn motion_of(&self, number: u32) -> Vec<(usize, [f64; 3])> {
        let (a, place) = row_of(number, self.shell.len());
        let unit = |k: usize| {
            let mut row: Row = [0.0; 6];
            row[place + k] = 1.0;
            row
        };
        if self.shell.dependents.ties.of(a).is_some() {
            let along = [0, 1, 2].map(|k| {
                let mut rows = vec![[0.0; 6]; self.shell.len()];
                rows[a] = unit(k);
                self.weights_of(rows)
            });
            let mut hosts = BTreeSet::new();
            self.gather_hosts(a, &mut hosts);
            let unknowns = hosts.into_iter().flat_map(|host| self.dofs.of(host));
            return unknowns.map(|i| (i, [0, 1, 2].map(|k| along[k][i]))).collect();
        }
        let first = self.shell.dependents.junctions.of(a).map_or(a, |group| group.first());
        let own = self.dofs.of(first);
        let mut along = [[0.0; 6]; 3];
        for (k, out) in along.iter_mut().enumerate() {
            self.project_one(first, |b| if b == a { unit(k) } else { [0.0; 6] }, &mut out[..own.len()]);
        }
        own.enumerate().map(|(i, unknown)| (unknown, [0, 1, 2].map(|k| along[k][i]))).collect()
    }
}

impl<S: DerefMut<Target = Shell>> StaticShell<S> {
    /// Particles with unknowns on which a particle hangs, through whatever hangs itself; those that stand for groups in place of their members.
    fn gather_hosts(&self, a: usize, hosts: &mut BTreeSet<usize>) {
        let dependents = &self.shell.dependents;
        match dependents.ties.of(a) {
            Some(hanging) => {
                hanging.corners.iter().for_each(|&corner| self.gather_hosts(corner as usize, hosts));
            }
            None => {
                hosts.insert(dependents.junctions.of(a).map_or(a, |group| group.first()));
            }
        }
    }
}
