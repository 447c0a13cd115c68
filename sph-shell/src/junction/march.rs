//! Groups in the march: their kick and their drift, beside the sweep over the particles.
//!
//! The sweep finds the particles of a group without rates and leaves them where they are (`Constraint::tied`); what they do is
//! prescribed here, before and after it.

use explicit_dynamics::{Step, Work};
use sph_core::Vec3;

use crate::conditions::constraints::Constraints;
use crate::conditions::supports::DirectorHold;
use crate::junction::group::{Junctions, director};
use crate::junction::kick::Kick;
use crate::motion::Moving;
use crate::packs::Row;

impl Junctions {
    /// Kicks all groups with the forces last evaluated, internal and external by particle, and takes their rates out of the sweep; their
    /// work. Where a drift follows at once, the motion is the one that it would find in the rates: the same bits as in two parts.
    pub fn kick(
        &mut self,
        moving: &mut Moving,
        constraints: &Constraints,
        internal: impl Fn(usize) -> Row,
        external: impl Fn(usize) -> Row,
        step: &Step,
        drifts: bool,
    ) -> Work {
        let Moving { state, rates, .. } = moving;
        let mut work = Work::default();
        for (group, motion) in self.groups.iter().zip(&mut self.motions) {
            let old = group.motion(state, rates);
            let internal = group.gather(state, &internal);
            let mut external = group.gather(state, &external);
            if let Some(body) = &group.body {
                external.iter_mut().zip(body.external).for_each(|(sum, load)| *sum += load);
            }
            let f = std::array::from_fn(|k| external[k] - internal[k]);
            let kick = Kick { group, state, f, external, old, step };
            *motion = kick.new_motion(constraints.of(group.first()), &mut work);
            if drifts {
                group.set_rates(state, rates, motion);
                *motion = group.motion(state, rates);
            }
            group.particles.iter().for_each(|&a| rates[a as usize] = [0.0; 6]);
        }
        work
    }

    /// Gives the particles of groups the rates that the kick found, after a way of `dt` along them \[T\].
    pub fn drift(&mut self, moving: &mut Moving, constraints: &Constraints, dt: f64) {
        let Moving { state, rates, .. } = moving;
        for (group, motion) in self.groups.iter().zip(&mut self.motions) {
            if dt != 0.0 {
                let u = Vec3::new(motion[0], motion[1], motion[2]) * dt;
                let free =
                    constraints.of(group.first()).is_none_or(|held| held.director == DirectorHold::Free);
                let mut theta = director(motion) * dt;
                if let Some(body) = group.body.as_ref().filter(|_| free) {
                    let spin;
                    (theta, spin) = body.free_turn(&group.triad(state), &director(motion), dt);
                    motion[3..].copy_from_slice(spin.as_slice());
                }
                group.turn(state, &u, &theta);
            }
            group.set_rates(state, rates, motion);
        }
    }

    /// Takes the rates of groups out of a drift over the particles.
    pub fn set_aside(&mut self, moving: &mut Moving) {
        let Moving { state, rates, .. } = moving;
        for (group, motion) in self.groups.iter().zip(&mut self.motions) {
            *motion = group.motion(state, rates);
            group.particles.iter().for_each(|&a| rates[a as usize] = [0.0; 6]);
        }
    }
}
