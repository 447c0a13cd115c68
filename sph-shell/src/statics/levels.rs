//! What a level does to a shell without time: which load case it counts, where it puts held values, what it changes.

use std::ops::DerefMut;

use explicit_dynamics::Instant;

use crate::Shell;
use crate::conditions::case::LoadCase;
use crate::packs::Row;
use crate::statics::static_shell::StaticShell;

impl<S: DerefMut<Target = Shell>> StaticShell<S> {
    /// Makes a load case the one that is under way: levels count its loads and motions from here on.
    pub fn set_case(&mut self, case: LoadCase) {
        self.shell.loading.case = case;
    }

    /// Whether anything belongs to the preload.
    pub fn has_preload(&self) -> bool {
        let shell = &*self.shell;
        let moves = |a: &u32| shell.constraint(*a as usize).is_some_and(|held| held.has_preload());
        shell.loading.loads.iter().any(|applied| applied.load.case() == LoadCase::Preload)
            || self.moved.iter().any(moves)
    }

    /// Puts prescribed values where a level has them.
    pub(super) fn put(&mut self, level: f64) {
        let shell = &mut *self.shell;
        shell.put_stress(level);
        for &a in &self.moved {
            let a = a as usize;
            let Shell { dependents, constraints, loading, motion, .. } = &mut *shell;
            if let Some(constraint) = constraints.of(a) {
                match (dependents.junctions.body_of(a), constraint.prescribed()) {
                    (Some(group), _) => group.put(constraint, level, loading.case, &mut motion.state),
                    (None, Some(prescribed)) => prescribed.put(level, loading.case, &mut motion.state[a]),
                    (None, None) => {}
                }
            }
            if let Some(basis) = self.carried.get_mut(a) {
                *basis = shell.basis(a, self.dofs.arc);
            }
        }
    }

    /// Rates of `[x, d]` of all particles per unit of level at fixed unknowns, at a level.
    pub(super) fn prescribed_rates(&self, level: f64) -> Vec<Row> {
        let mut rates = vec![[0.0; 6]; self.shell.len()];
        let Shell { dependents, constraints, loading, motion, .. } = &*self.shell;
        for &a in &self.moved {
            let a = a as usize;
            let Some(prescribed) = constraints.of(a).and_then(|constraint| constraint.prescribed()) else {
                continue;
            };
            match dependents.junctions.body_of(a) {
                Some(group) => {
                    group.prescribed_rates(&prescribed, level, loading.case, &motion.state, &mut rates);
                }
                None => rates[a] = prescribed.rate(level, &motion.director(a), loading.case),
            }
        }
        dependents.ties.follow(&motion.state, &mut rates);
        rates
    }

    /// Rows of `∂(external − internal)/∂λ`: the loads, and `−K_fc ċ` of the prescribed values c.
    pub(super) fn level_rates(&mut self, level: f64) -> Vec<Row> {
        self.put(level);
        self.shell.evaluate_load_rate();
        let rates = self.prescribed_rates(level);
        let mut rows: Vec<Row> = (0..self.shell.len()).map(|a| self.shell.external_force(a)).collect();
        self.shell.load_stiffness(level, &mut |a, b, block| {
            for (value, row) in rows[a as usize].iter_mut().zip(block) {
                *value += product(row, &rates[b as usize]);
            }
        });
        let shell = &*self.shell;
        shell.dependents.ties.condense(&shell.motion.state, &mut rows, |_, _| ());
        shell.second_derivatives(&self.pattern, None, &mut self.blocks);
        shell.dependents.ties.reduce(&shell.motion.state, &self.pattern, &mut self.blocks, 1.0, |_| None);
        for (a, b, number) in self.pattern.pairs.pairs() {
            let block = &self.blocks[number];
            for i in 0..6 {
                rows[a][i] -= product(&block[i], &rates[b]);
                if a != b {
                    rows[b][i] -= (0..6).map(|j| block[j][i] * rates[a][j]).sum::<f64>();
                }
            }
        }
        rows
    }

    /// Takes what a unit of level adds to the forces of the initial stress along the unknowns.
    pub(super) fn subtract_stress_rate(&mut self, level: f64, out: &mut [f64]) {
        if self.shell.loading.case != self.shell.material.stress_case || !self.shell.is_stressed() {
            return;
        }
        let rows = self.shell.forces_of_stress(level);
        let mut rate = vec![0.0; out.len()];
        self.project(|a| rows[a], &mut rate);
        out.iter_mut().zip(&rate).for_each(|(sum, part)| *sum -= part);
    }

    pub(super) fn external_at(&mut self, level: f64) {
        self.shell.evaluate_external(Instant { time: 0.0, level });
    }
}

fn product(a: &Row, b: &Row) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
