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
        self.shell.case = case;
    }

    /// Whether anything belongs to the preload.
    pub fn has_preload(&self) -> bool {
        let shell = &*self.shell;
        let moves = |a: &u32| shell.constraint(*a as usize).is_some_and(|held| held.has_preload());
        shell.loads.iter().any(|applied| applied.load.case() == LoadCase::Preload)
            || self.moved.iter().any(moves)
    }

    /// Puts prescribed values where a level has them.
    pub(super) fn put(&mut self, level: f64) {
        let shell = &mut *self.shell;
        shell.put_stress(level);
        for &a in &self.moved {
            let number = shell.constraint_of[a as usize] as usize - 1;
            if shell.body_of(a as usize).is_some() {
                shell.put_body(a as usize, level);
            } else if let Some(prescribed) = shell.constraints[number].prescribed() {
                prescribed.put(level, shell.case, &mut shell.state[a as usize]);
            }
            if let Some(basis) = self.carried.get_mut(a as usize) {
                *basis = shell.basis(a as usize, self.dofs.arc);
            }
        }
    }

    /// Rates of `[x, d]` of all particles per unit of level at fixed unknowns, at a level.
    pub(super) fn prescribed_rates(&self, level: f64) -> Vec<Row> {
        let mut rates = vec![[0.0; 6]; self.shell.len()];
        for &a in &self.moved {
            if self.shell.body_of(a as usize).is_some() {
                self.shell.rates_of_body(a as usize, level, &mut rates);
            } else if let Some(prescribed) = self.shell.constraint(a as usize).and_then(|c| c.prescribed()) {
                rates[a as usize] = prescribed.rate(level, &self.shell.director(a as usize), self.shell.case);
            }
        }
        self.shell.ties.follow(&self.shell.state, &mut rates);
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
        shell.ties.condense(&shell.state, &mut rows, |_, _| ());
        shell.second_derivatives(&self.pattern, None, &mut self.blocks);
        shell.ties.reduce(&shell.state, &self.pattern, &mut self.blocks, 1.0, |_| None);
        for a in 0..rows.len() {
            for number in self.pattern.of_row(a) {
                let (b, block) = (self.pattern.columns[number] as usize, &self.blocks[number]);
                for i in 0..6 {
                    rows[a][i] -= product(&block[i], &rates[b]);
                    if a != b {
                        rows[b][i] -= (0..6).map(|j| block[j][i] * rates[a][j]).sum::<f64>();
                    }
                }
            }
        }
        rows
    }

    /// Takes what a unit of level adds to the forces of the initial stress along the unknowns.
    pub(super) fn subtract_stress_rate(&mut self, level: f64, out: &mut [f64]) {
        if self.shell.case != self.shell.stress_case || !self.shell.is_stressed() {
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
