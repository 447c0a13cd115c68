//! Unknowns that turn with the shell along a motion: what buckling differentiates the tangent in.
//!
//! A tangent K(λ) along a path may be taken in unknowns that turn, `R(λ)ᵀ K(λ) R(λ)` with R of rotations at each particle:
//! it is singular where K is. To the first order in λ the two are different eigenproblems. In fixed directions a part that
//! turns by θ before it buckles shows its membrane and its transverse shear, t² times as stiff as bending, under another
//! angle; the terms in θ² that would put this right are not there, and levels come out false as soon as θ reaches t over
//! a length. Directions that turn by θ leave nothing to put right but the bend of the path.

use std::ops::DerefMut;

use implicit_statics::Equilibrium;
use sph_core::{Vec3, fitted_spins, follow_turn};

use crate::Shell;
use crate::statics::dofs::Basis;
use crate::statics::static_shell::StaticShell;

impl<S: DerefMut<Target = Shell>> StaticShell<S> {
    /// Moves the shell, what is prescribed from one level to another, and turns the directions of its unknowns along.
    pub(crate) fn turn_along(&mut self, levels: [f64; 2], motion: &[f64]) {
        let mut bases: Vec<Basis> = (0..self.shell.len()).map(|a| self.basis(a)).collect();
        let spins = self.spins(&bases, levels, motion);
        self.update(motion);
        self.put(levels[1]);
        for (a, (basis, spin)) in bases.iter_mut().zip(&spins).enumerate() {
            basis.follow(spin, self.basis(a));
        }
        self.carried = bases;
    }

    /// How far the material turns at each particle: as the director does, about it as the neighbours do; a group as a whole.
    fn spins(&self, bases: &[Basis], [from, to]: [f64; 2], motion: &[f64]) -> Vec<Vec3> {
        let shell = &*self.shell;
        let mut rates = vec![[0.0; 6]; bases.len()];
        let mut whole = vec![None; bases.len()];
        for (a, basis) in bases.iter().enumerate() {
            let (u, v) = basis.expand(&motion[self.dofs.of(a)]);
            let row = [u.x, u.y, u.z, v.x, v.y, v.z];
            match shell.dependents.junctions.of(a) {
                None => rates[a] = row,
                Some(group) if group.first() == a => {
                    group.set_rates(
                        &shell.motion.state,
                        &mut rates,
                        &group.of_pole(&shell.motion.state, row),
                    );
                    whole[a] = Some(v);
                }
                Some(_) => {}
            }
        }
        for &a in &self.moved {
            let prescribed = shell.constraint(a as usize).and_then(|constraint| constraint.prescribed());
            if let (Some(prescribed), Some(turn)) = (prescribed, &mut whole[a as usize]) {
                let [_, spin] = prescribed.motion_rate(from, shell.loading.case);
                *turn += spin * (to - from);
            }
        }
        if !self.moved.is_empty() {
            for (row, prescribed) in rates.iter_mut().zip(self.prescribed_rates(from)) {
                row.iter_mut().zip(prescribed).for_each(|(sum, rate)| *sum += rate * (to - from));
            }
        }
        shell.dependents.ties.follow(&shell.motion.state, &mut rates);
        let positions: Vec<Vec3> = (0..rates.len()).map(|a| shell.motion.place(a)).collect();
        let velocities: Vec<Vec3> = rates.iter().map(|row| Vec3::from_column_slice(&row[..3])).collect();
        let pairs = self.pattern.pairs.pairs().map(|(a, b, _)| (a, b));
        let fitted = fitted_spins(&positions, &velocities, pairs);
        let spin = |a: usize| {
            let d = shell.director(a);
            let rate = Vec3::from_column_slice(&rates[a][3..]);
            whole[a].unwrap_or_else(|| d.cross(&rate) + d * d.dot(&fitted[a]))
        };
        (0..bases.len()).map(spin).collect()
    }
}

impl Basis {
    /// Becomes the directions of `there`, turned among themselves to lie nearest to its own after a rotation.
    fn follow(&mut self, turn: &Vec3, mut there: Self) {
        let (moves, turns) = there.directions[..there.count].split_at_mut(there.translations);
        let (moved, turned) = self.directions[..self.count].split_at(self.translations);
        follow_turn(moves, moved, turn);
        follow_turn(turns, turned, turn);
        *self = there;
    }
}
