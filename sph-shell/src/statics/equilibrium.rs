//! The shell as a system of `implicit-statics`: forces, tangent, update, states that are kept and taken back.

use std::ops::DerefMut;

use explicit_dynamics::Instant;
use implicit_statics::{Equilibrium, Front, OutOfBounds, RankOne, row_sums};
use sph_core::Vec3;

use crate::Shell;
use crate::packs::Row;
use crate::points::bounds::BoundViolation;
use crate::statics::dofs::great_circle;
use crate::statics::load_stiffness::subtract_load_stiffness;
use crate::statics::static_shell::StaticShell;

impl<S: DerefMut<Target = Shell>> Equilibrium for StaticShell<S> {
    fn unknowns(&self) -> usize {
        self.dofs.count()
    }

    fn pattern(&self) -> Vec<(usize, usize)> {
        let mut out = Vec::with_capacity(self.entries());
        out.extend(self.pattern.pairs.entries(|a| self.dofs.of(a)).map(|(_, row, column)| (row, column)));
        out
    }

    fn pattern_changed(&mut self, level: f64) -> bool {
        self.put(level);
        self.follow_contact()
    }

    /// Those of the particles at rest.
    fn coordinates(&self) -> Option<Vec<[f64; 3]>> {
        let rest = &self.shell.reference.cloud.positions;
        let of = |a: usize| self.dofs.of(a).map(move |_| rest[a].into());
        Some((0..self.shell.len()).flat_map(of).collect())
    }

    fn rigid_motions(&self) -> Option<Vec<[f64; 6]>> {
        let state = &self.shell.motion.state;
        let of = |a: usize| {
            let (basis, group) = (self.basis(a), self.shell.dependents.junctions.of(a));
            let [x, d] = [0, 3].map(|first| Vec3::from_fn(|k, _| state[a][first + k]));
            let x = group.and_then(|group| group.far_pole(state)).unwrap_or(x);
            (0..basis.count).map(move |i| {
                let e = basis.directions[i];
                let (move_by, turn_by) = match (i < basis.translations, group) {
                    (true, _) => (e, x.cross(&e)),
                    (false, None) => (Vec3::zeros(), d.cross(&e) / basis.rates[i]),
                    (false, Some(_)) => (Vec3::zeros(), e / basis.rates[i]),
                };
                std::array::from_fn(|k| if k < 3 { move_by[k] } else { turn_by[k - 3] })
            })
        };
        Some((0..self.shell.len()).flat_map(of).collect())
    }

    fn beside_pattern(&mut self, level: f64) -> Vec<RankOne> {
        self.beside(level)
    }

    fn keeps_factor(&self) -> bool {
        true
    }

    fn internal(&mut self, level: f64, out: &mut [f64]) {
        self.put(level);
        self.internal_here(false);
        self.project(|a| self.shell.internal_force(a), out);
    }

    fn external(&mut self, level: f64, out: &mut [f64]) {
        self.put(level);
        self.external_at(level);
        self.project(|a| self.shell.external_force(a), out);
        self.add_body_loads(out);
    }

    fn load_rate(&mut self, level: f64, out: &mut [f64]) {
        // Loads of the case that is under way are proportional to the level.
        if self.moved.is_empty() {
            self.shell.evaluate_load_rate(level);
            self.project(|a| self.shell.external_force(a), out);
        } else {
            let rows = self.level_rates(level);
            self.project(|a| rows[a], out);
        }
        self.add_body_loads(out);
        self.subtract_stress_rate(level, out);
    }

    fn has_moving_supports(&self) -> bool {
        !self.moved.is_empty()
    }

    fn stress_forces(&self, level: f64) -> f64 {
        self.stress_forces_at(level)
    }

    fn driving_force(&self) -> f64 {
        let prescribed = |&a: &u32| {
            let a = a as usize;
            let prescribed = self.shell.constraint(a)?.prescribed()?;
            let internal = |a| self.shell.internal_force(a);
            if let Some(group) = self.shell.dependents.junctions.body_of(a) {
                return Some(group.driving_force(
                    &prescribed,
                    &self.shell.motion.state,
                    internal,
                    self.dofs.arc,
                ));
            }
            Some(prescribed.force(&self.shell.internal_force(a), &self.shell.director(a), self.dofs.arc))
        };
        self.moved.iter().filter_map(prescribed).sum::<f64>().sqrt()
    }

    fn tangent(&mut self, level: f64, values: &mut [f64]) {
        self.put(level);
        self.tangent_here(level, values);
    }

    fn stressed_tangent(&mut self, level: f64, motion: &[f64], values: &mut [f64]) -> bool {
        let rest = self.save();
        self.update(motion);
        self.put(level);
        self.internal_here(false);
        let stressed = self.shell.motion.state.to_vec();
        let internal: Vec<_> = (0..self.shell.len()).map(|a| self.shell.internal_force(a)).collect();
        self.restore(&rest);
        self.external_at(level);
        self.shell.second_derivatives(&self.pattern, Some(&stressed), &mut self.blocks);
        subtract_load_stiffness(&self.shell, level, &self.pattern.pairs, &mut self.blocks);
        // Without stress here, the force along the director is that of the stresses alone up to their square.
        self.assemble(Some(&internal), values);
        true
    }

    fn turned_tangent(&mut self, levels: [f64; 2], motion: &[f64], values: &mut [f64]) {
        let rest = self.save();
        self.turn_along(levels, motion);
        self.tangent_here(levels[1], values);
        self.restore(&rest);
    }

    /// One sum for the translations of a particle and one for its turns: the stiff directions turn with the shell. What may touch counts as if it
    /// did.
    fn row_sums(&mut self, level: f64, out: &mut [f64]) {
        self.pattern_changed(level);
        let pattern = self.pattern();
        let mut values = vec![0.0; pattern.len()];
        self.tangent(level, &mut values);
        row_sums(&pattern, &values, out);
        let ones = vec![1.0; out.len()];
        self.beside(level).iter().for_each(|term| term.add_magnitudes(&ones, out));
        for a in 0..self.shell.len() {
            let (own, split) = (self.dofs.of(a), self.basis(a).translations);
            let (moves, turns) = out[own].split_at_mut(split);
            for alike in [moves, turns] {
                let largest = alike.iter().copied().fold(0.0, f64::max);
                alike.fill(largest);
            }
        }
        self.add_contact_bounds(out);
    }

    fn reach(&mut self, increment: &[f64]) -> f64 {
        if self.shell.loading.own_contact.is_none() {
            return 1.0;
        }
        let saved = self.save();
        self.update(increment);
        let there = self.shell.motion.state.clone();
        self.restore(&saved);
        let Shell { loading, motion, .. } = &*self.shell;
        loading.own_contact.as_ref().map_or(1.0, |own| own.reach(&motion.state, &there))
    }

    fn has_moving_tools(&self) -> bool {
        self.shell.loading.tools.move_in(self.shell.loading.case)
    }

    fn external_without_contact(&mut self, level: f64, out: &mut [f64]) {
        if !self.shell.may_touch() {
            return self.external(level, out);
        }
        self.put(level);
        let Shell { reference, dependents, motion, loading, .. } = &mut *self.shell;
        loading.evaluate_loads(Instant { time: 0.0, level }, reference, dependents, motion);
        self.project(|a| self.shell.external_force(a), out);
        self.add_body_loads(out);
    }

    fn contact_energy(&self) -> f64 {
        self.shell.loading.contact_energy()
    }

    fn stages_of_contact(&self) -> Vec<f64> {
        self.shell.loading.tools.stages()
    }

    fn soften_contact(&mut self, length: Option<f64>) {
        self.shell.loading.tools.soften(length);
    }

    fn front(&mut self, level: f64) -> Front {
        let mut front = Front::default();
        let Shell { loading, motion, .. } = &*self.shell;
        loading.tools.see(Instant { time: 0.0, level }, loading.case, &motion.state, &mut front);
        front
    }

    fn update(&mut self, increment: &[f64]) {
        self.predict_volumes(increment);
        self.carried.clear();
        for a in 0..self.shell.len() {
            let (u, v) = self.basis(a).expand(&increment[self.dofs.of(a)]);
            self.shell.move_particle(a, u, v);
        }
        let Shell { dependents, motion, .. } = &mut *self.shell;
        dependents.ties.put(&mut motion.state);
    }

    fn transport(&mut self, motion: &mut [f64]) {
        self.forget_volumes();
        if self.carried.is_empty() {
            self.carried = (0..self.shell.len()).map(|a| self.basis(a)).collect();
        }
        for a in 0..self.shell.len() {
            let own = &mut motion[self.dofs.of(a)];
            let (u, v) = self.carried[a].expand(own);
            let turn = self.shell.move_particle(a, u, v);
            self.carried[a] = self.basis(a);
            self.carried[a].turns(&turn, own);
        }
        let Shell { dependents, motion, .. } = &mut *self.shell;
        dependents.ties.put(&mut motion.state);
    }

    fn motion_to(&self, saved: &[f64], out: &mut [f64]) -> bool {
        let rows = &saved.as_chunks::<6>().0[..self.shell.len()];
        for (a, row) in rows.iter().enumerate() {
            let here = &self.shell.motion.state[a];
            let turn = match self.shell.dependents.junctions.of(a) {
                Some(group) => group.rotation_to(&self.shell.motion.state, rows),
                None => great_circle(here, row),
            };
            let pole =
                self.shell.dependents.junctions.of(a).and_then(|group| {
                    Some(group.far_pole(rows)? - group.far_pole(&self.shell.motion.state)?)
                });
            let moved = pole.unwrap_or_else(|| Vec3::from_fn(|k, _| row[k] - here[k]));
            let basis = self.basis(a);
            let own = &mut out[self.dofs.of(a)];
            for (value, direction) in own.iter_mut().zip(&basis.directions) {
                *value = (0..3).map(|k| direction[k] * moved[k]).sum();
            }
            basis.turns(&turn, own);
        }
        true
    }

    fn save(&self) -> Vec<f64> {
        let state = self.shell.motion.state.as_flattened();
        state.iter().copied().chain(self.shell.history()).collect()
    }

    fn restore(&mut self, saved: &[f64]) {
        self.forget_volumes();
        self.carried.clear();
        let state = self.shell.motion.state.as_flattened_mut();
        let (rows, history) = saved.split_at(state.len());
        state.copy_from_slice(rows);
        self.shell.take_up_history(history);
    }

    fn commit(&mut self) {
        self.forget_volumes();
        self.shell.commit();
        self.shell.hover();
    }

    fn tangent_is_of_the_step(&self) -> bool {
        self.shell.remembers()
    }

    fn energy(&mut self) -> f64 {
        self.internal_here(true);
        self.shell.stored_energy()
    }

    /// Turning directors carry the rotary inertia `ρ t A_a t²/12` of the shell itself: the one scaled up in
    /// [`crate::Reference`] serves the stable step, which nothing here has. It would take up to 1.2 % off the lowest
    /// six frequencies of thin square plates of 21×21 particles, by an amount that is the lattice's, not the plate's.
    fn masses(&self) -> Vec<f64> {
        let thickness = self.shell.thickness();
        let turning = thickness.powi(2) / 12.0 / self.dofs.arc.powi(2);
        (0..self.unknowns())
            .map(|unknown| {
                let (particle, place, moves) = self.dofs.find(unknown);
                if moves {
                    return self.shell.dependents.moving_mass(&self.shell.reference, particle);
                }
                let Shell { dependents, reference, stiffeners, motion, .. } = &*self.shell;
                let axis = || self.basis(particle).directions[place];
                let d = self.shell.director(particle);
                dependents.turning_mass(reference, thickness, &motion.state, particle, axis) * turning
                    + stiffeners.turning(particle, &d, axis) / self.dofs.arc.powi(2)
            })
            .collect()
    }

    fn vibrating_masses(&self) -> Vec<f64> {
        self.with_moved_masses(self.masses())
    }

    fn name_unknown(&self, unknown: usize) -> String {
        let (particle, place, moves) = self.dofs.find(unknown);
        let direction = self.basis(particle).directions[place];
        let x = self.shell.rest_position(particle);
        let what = match (moves, self.shell.dependents.junctions.of(particle)) {
            (true, _) => "moving",
            (false, None) => "its director turning",
            (false, Some(group)) if group.body.is_some() => "its rigid body turning",
            (false, Some(_)) => "its junction turning",
        };
        format!(
            "particle {particle} at ({:.4}, {:.4}, {:.4}), {what} along ({:.2}, {:.2}, {:.2})",
            x.x, x.y, x.z, direction.x, direction.y, direction.z
        )
    }

    fn within_bounds(&self) -> Result<(), OutOfBounds> {
        let found = |BoundViolation { place, what, value, bound }| OutOfBounds { place, what, value, bound };
        self.shell.bound_violation().map_or(Ok(()), |violation| Err(found(violation)))
    }
}

impl<S: DerefMut<Target = Shell>> StaticShell<S> {
    /// The tangent where the shell stands, its prescribed values at the level already.
    fn tangent_here(&mut self, level: f64, values: &mut [f64]) {
        self.internal_here(false);
        self.external_at(level);
        self.shell.second_derivatives(&self.pattern, None, &mut self.blocks);
        subtract_load_stiffness(&self.shell, level, &self.pattern.pairs, &mut self.blocks);
        self.assemble(None, values);
    }

    /// Entries between the unknowns from the blocks; with internal forces other than those last evaluated, if they are given.
    fn assemble(&mut self, internal: Option<&[Row]>, values: &mut [f64]) {
        let shell = &*self.shell;
        let lack = |a: usize| -> Row {
            let (f, e) =
                (internal.map_or_else(|| shell.internal_force(a), |rows| rows[a]), shell.external_force(a));
            std::array::from_fn(|k| f[k] - e[k])
        };
        let on_hanging = |i: usize| Some(shell.dependents.ties.lack(i));
        shell.dependents.ties.reduce(&shell.motion.state, &self.pattern, &mut self.blocks, 1.0, on_hanging);
        shell.dependents.junctions.tie(&shell.motion.state, &self.pattern.pairs, &mut self.blocks, 1.0);
        shell.dependents.junctions.add_rotation_blocks(
            &shell.motion.state,
            &self.pattern.pairs,
            &mut self.blocks,
            lack,
        );
        shell.body_springs().add_blocks(&self.pattern.pairs, &mut self.blocks);
        // A director that turns keeps its length: its force along itself stiffens or softens every turn.
        let radial = |a: usize| match shell.dependents.junctions.of(a) {
            Some(_) => 0.0,
            None => lack(a).iter().zip(&shell.motion.state[a]).skip(3).map(|(lack, d)| lack * d).sum(),
        };
        self.project_blocks(&self.blocks, radial, values);
    }
}
