//! The shell without time: numbered degrees of freedom, the blocks of its tangent, what is read along the unknowns;
//! what a level does: which load case it counts, where it puts held values.

use std::ops::DerefMut;

use explicit_dynamics::Instant;
use sph_core::Vec3;

use crate::Shell;
use crate::conditions::body::Block;
use crate::conditions::case::LoadCase;
use crate::packs::Row;
use crate::statics::blocks::ShellPattern;
use crate::statics::dofs::{Basis, DofMap};
use crate::statics::projection::{Projection, entries};

/// A shell with what Newton's method needs: numbered degrees of freedom and the blocks of its tangent.
///
/// Built only when a static analysis asks for it. Its shell is its own, or lent (`&mut Shell`) for a look at the tangent
/// of a state.
pub struct StaticShell<S = Box<Shell>> {
    pub(crate) shell: S,
    pub(crate) dofs: DofMap,
    pub(crate) pattern: ShellPattern,
    pub(crate) blocks: Vec<Block>,
    /// First entry of the rows of each particle in the pattern of the unknowns, and the end.
    entries: Vec<usize>,
    /// Lists of what is near itself that the shell had made when the pattern was read.
    lists: u64,
    /// Particles with a prescribed displacement or rotation.
    pub(crate) moved: Vec<u32>,
    /// Directions of the unknowns of all particles in the present state, after it was carried or turned there; else none.
    pub(crate) carried: Vec<Basis>,
}

impl StaticShell {
    /// Numbers the free degrees of freedom of a shell. What its supports move goes with the level.
    pub fn new(shell: Shell) -> Self {
        // The first particle of a rigid body stands for all of it.
        let own = |a: usize| shell.dependents.junctions.body_of(a).is_none_or(|group| group.first() == a);
        let prescribed = |a: usize| shell.constraint(a).is_some_and(|c| c.prescribed().is_some());
        let moved = (0..shell.len()).filter(|&a| prescribed(a) && own(a));
        let moved = moved.map(|a| a as u32).collect();
        Self { moved, ..Self::lent(Box::new(shell)) }
    }
}

impl<S: DerefMut<Target = Shell>> StaticShell<S> {
    /// The same of a shell that goes on afterwards: [`implicit_statics::Equilibrium::tangent`] and the forces leave its motion as it is, that
    /// of prescribed values too.
    pub fn lent(shell: S) -> Self {
        let (dofs, pattern) = (DofMap::new(&shell), ShellPattern::new(&shell));
        let blocks = vec![[[0.0; 6]; 6]; pattern.pairs.blocks()];
        let entries = entries(&dofs, &pattern.pairs);
        Self { shell, dofs, pattern, blocks, entries, lists: 0, moved: Vec::new(), carried: Vec::new() }
    }

    /// The shell in its present state; its forces are those last evaluated.
    pub fn shell(&self) -> &Shell {
        &self.shell
    }

    /// The same, to put it into another state; whatever is evaluated is that of the state before.
    pub fn shell_mut(&mut self) -> &mut Shell {
        self.forget_volumes();
        self.carried.clear();
        &mut self.shell
    }

    /// Evaluates internal forces and energy, and the loads at a level, so that probes can read them.
    pub fn evaluate(&mut self, level: f64) {
        self.put(level);
        self.internal_here(true);
        self.external_at(level);
    }

    /// Components of the displacement of particles along a direction, as weights of the unknowns: what displacement
    /// control prescribes. The mean over the particles.
    pub fn functional(&self, particles: &[u32], direction: Vec3) -> Vec<f64> {
        let share = direction.normalize() / particles.len() as f64;
        let mut rows = vec![[0.0; 6]; self.shell.len()];
        particles.iter().for_each(|&a| (0..3).for_each(|k| rows[a as usize][k] += share[k]));
        self.weights_of(rows)
    }

    /// Rows `[f, n]` at all particles as weights of the unknowns.
    pub(super) fn weights_of(&self, mut rows: Vec<Row>) -> Vec<f64> {
        self.shell.dependents.ties.condense(&self.shell.motion.state, &mut rows, |_, _| ());
        let mut weights = vec![0.0; self.dofs.count()];
        self.project(|a| rows[a], &mut weights);
        weights
    }

    /// Reads the pattern anew where the shell has made another list of what is near itself; whether it did.
    pub(super) fn follow_contact(&mut self) -> bool {
        let Shell { loading, motion, .. } = &mut *self.shell;
        if loading.frozen.is_some() {
            return false;
        }
        let Some(lists) = loading.own_contact.as_mut().map(|own| own.lists(&motion.state)) else {
            return false;
        };
        let changed = lists != self.lists;
        if changed {
            self.lists = lists;
            self.pattern = ShellPattern::new(&self.shell);
            self.blocks = vec![[[0.0; 6]; 6]; self.pattern.pairs.blocks()];
            self.entries = entries(&self.dofs, &self.pattern.pairs);
        }
        changed
    }

    /// Number of entries of the pattern of the unknowns.
    pub(crate) fn entries(&self) -> usize {
        self.entries[self.shell.len()]
    }

    pub(crate) fn basis(&self, particle: usize) -> Basis {
        self.shell.basis(particle, self.dofs.arc)
    }

    /// Turns rows `[f, τ]` of all particles into components along the unknowns.
    pub(crate) fn project(&self, row: impl Fn(usize) -> [f64; 6], out: &mut [f64]) {
        for a in 0..self.shell.len() {
            self.project_one(a, &row, &mut out[self.dofs.of(a)]);
        }
    }

    /// The components along the unknowns of one particle, or of the group that it stands for.
    pub(crate) fn project_one(&self, a: usize, row: impl Fn(usize) -> [f64; 6], out: &mut [f64]) {
        let mut row = self.shell.gathered(a, row);
        if let Some(group) = self.shell.dependents.junctions.body_of(a).filter(|group| group.first() == a) {
            row = group.along_unknowns(&self.shell.motion.state, row);
        }
        match self.carried.get(a) {
            Some(basis) => basis.project(&row, out),
            None => self.basis(a).project(&row, out),
        }
    }

    /// Entries between the unknowns from the lower triangle of blocks, in the order of the pattern; `radial` is taken from the
    /// turns of a particle on the diagonal: a director that turns keeps its length, so its force along itself stiffens or
    /// softens every turn.
    pub(crate) fn project_blocks(
        &self,
        blocks: &[Block],
        radial: impl Fn(usize) -> f64 + Sync,
        values: &mut [f64],
    ) {
        let present: Vec<Basis>;
        let bases = if self.carried.is_empty() {
            present = (0..self.shell.len()).map(|a| self.basis(a)).collect();
            &present
        } else {
            &self.carried
        };
        let projection =
            Projection { bases, pattern: &self.pattern.pairs, entries: &self.entries, blocks, radial };
        projection.run(0..self.shell.len(), values, self.shell.evaluation.threads.next_power_of_two());
    }

    /// Makes a load case the one that is under way: levels count its loads and motions from here on.
    pub fn set_case(&mut self, case: LoadCase) {
        self.shell.loading.case = case;
    }

    /// Whether anything belongs to the preload.
    pub fn has_preload(&self) -> bool {
        let shell = &*self.shell;
        let moves = |a: &u32| shell.constraint(*a as usize).is_some_and(|held| held.has_preload());
        shell.loading.loads.iter().any(|applied| applied.load.case() == LoadCase::Preload)
            || shell.loading.tools.move_in(LoadCase::Preload)
            || shell.material.heat.as_ref().is_some_and(|heat| heat.preloads())
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
        self.shell.evaluate_load_rate(level);
        let rates = self.prescribed_rates(level);
        let mut rows: Vec<Row> = (0..self.shell.len()).map(|a| self.shell.external_force(a)).collect();
        self.shell.load_stiffness(level, &mut |a, b, block| {
            for (value, row) in rows[a as usize].iter_mut().zip(block) {
                *value += product(row, &rates[b as usize]);
            }
        });
        self.subtract_enclosed_rates(level, &rates, &mut rows);
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

    /// Evaluates internal forces where the shell stands, and the energies of points where they are wanted.
    pub(super) fn internal_here(&mut self, energy: bool) {
        self.shell.evaluate_internal(energy);
        self.shell.bring_internal();
    }

    pub(super) fn external_at(&mut self, level: f64) {
        self.shell.evaluate_external(Instant { time: 0.0, level });
        self.shell.bring_external();
    }
}

fn product(a: &Row, b: &Row) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
