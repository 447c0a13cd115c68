//! Springs: to the ground along directions, against turning, between two sets; forces that grow with the motion, in every analysis.
//!
//! They stand among the external forces, since they are no strain. No level scales them. What they bear is a reaction.
//!
//! | spring | energy | |
//! |---|---|---|
//! | [`Spring`], particle to ground | `½ k (n·u)²` | here |
//! | [`TurnSpring`], director to ground | `½ k φ²` | `turning.rs` |
//! | [`SpringBetween`], particle to particle | `½ k (n·(u_b − u_a))²` | here |
//! | [`BodySpring`], the same two of rigid sets | of the rotation, of the reference points | `junction/springs.rs` |

mod of_bodies;
mod turning;

use std::ops::Range;

use sph_core::Vec3;

use crate::conditions::body::{Block, Body, place_block};
use crate::conditions::loads::check_set;
use crate::error::ShellError;
use crate::packs::Row;
use crate::reference::Reference;

pub use of_bodies::BodySpring;
pub use turning::TurnSpring;

/// Springs between particles and the ground, along a direction.
#[derive(Clone, Debug)]
pub struct Spring {
    /// Particles and the stiffness of each \[F/L\].
    pub stiffness: Vec<(u32, f64)>,
    /// Direction (any length).
    pub direction: Vec3,
}

/// Springs between pairs of particles, along a direction fixed in space.
///
/// Pairs on one place at rest do no work under any common rigid motion. Of others the force need not run along the line that joins them: it
/// keeps momentum, and moment of momentum not. A stiffness may be negative: it takes from springs beside it what they have too much of
/// ([`crate::EvenBed`]).
#[derive(Clone, Debug)]
pub struct SpringBetween {
    /// Pairs of particles and the stiffness of each, not zero \[F/L\].
    pub stiffness: Vec<([u32; 2], f64)>,
    /// Direction (any length).
    pub direction: Vec3,
}

/// All springs of a shell.
#[derive(Clone, Debug, Default)]
pub struct Springs {
    /// To the ground, along directions.
    pub ground: Vec<Spring>,
    /// To the ground, against turns of directors.
    pub turning: Vec<TurnSpring>,
    /// Between particles.
    pub between: Vec<SpringBetween>,
    /// Of rigid sets as a whole.
    pub of_bodies: Vec<BodySpring>,
}

impl From<Vec<Spring>> for Springs {
    fn from(ground: Vec<Spring>) -> Self {
        Self { ground, ..Self::default() }
    }
}

impl Springs {
    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.ground.is_empty()
            && self.turning.is_empty()
            && self.between.is_empty()
            && self.of_bodies.is_empty()
    }

    /// Whether there are any on particles.
    pub(crate) fn any_on_particles(&self) -> bool {
        !(self.ground.is_empty() && self.turning.is_empty() && self.between.is_empty())
    }

    /// The same with directions and axes of length one; whether rigid sets have the bodies that they name is not looked at.
    ///
    /// # Errors
    /// [`ShellError`] for an empty set, a particle that is none, a stiffness that is not finite, or not positive to the ground, a pair
    /// of one particle, an axis along a director.
    pub(crate) fn checked(mut self, reference: &Reference) -> Result<Self, ShellError> {
        let ground = self.ground.iter().flat_map(|spring| &spring.stiffness).copied();
        let turning = self.turning.iter().flat_map(|spring| &spring.stiffness).copied();
        let between = self.between.iter().flat_map(|spring| &spring.stiffness);
        let ends = between.clone().flat_map(|&([a, b], k)| [(a, k), (b, k)]);
        let sets = [self.ground.len(), self.turning.len(), self.between.len()];
        for ((count, all), to_ground) in sets
            .into_iter()
            .zip([ground.collect::<Vec<_>>(), turning.collect::<Vec<_>>(), ends.collect::<Vec<_>>()])
            .zip([true, true, false])
        {
            if count > 0 {
                check_set("a spring", all.iter().map(|s| s.0), reference)?;
            }
            let none = |k: f64| !k.is_finite() || k == 0.0 || (to_ground && k < 0.0);
            if let Some(&(particle, stiffness)) = all.iter().find(|(_, k)| none(*k)) {
                return Err(ShellError::Spring { particle, stiffness });
            }
        }
        if let Some(([particle, _], _)) = between.clone().find(|([a, b], _)| a == b) {
            return Err(ShellError::SpringOnItself { particle: *particle });
        }
        turning::check(&self.turning, reference)?;
        let Self { ground, turning, between, of_bodies } = &mut self;
        let directions = ground.iter_mut().map(|spring| &mut spring.direction);
        let directions = directions.chain(between.iter_mut().map(|spring| &mut spring.direction));
        for direction in directions.chain(turning.iter_mut().map(|spring| &mut spring.axis)) {
            *direction = direction.normalize();
        }
        of_bodies.iter_mut().for_each(BodySpring::normalize);
        Ok(self)
    }

    /// Those on particles of a range.
    pub(crate) fn on_share(&self, own: &Range<usize>) -> Self {
        let is_own = |a: u32| own.contains(&(a as usize));
        let mut springs = Self { of_bodies: Vec::new(), ..self.clone() };
        springs.ground.iter_mut().for_each(|spring| spring.stiffness.retain(|s| is_own(s.0)));
        springs.turning.iter_mut().for_each(|spring| spring.stiffness.retain(|s| is_own(s.0)));
        springs
            .between
            .iter_mut()
            .for_each(|spring| spring.stiffness.retain(|s| s.0.into_iter().any(is_own)));
        springs
    }

    /// Particles between which there are springs.
    pub(crate) fn ends(&self) -> impl Iterator<Item = u32> {
        self.between.iter().flat_map(|spring| &spring.stiffness).flat_map(|(ends, _)| *ends)
    }

    /// Adds the forces of all springs on particles in a state, a row each particle.
    pub(crate) fn add(&self, body: &Body<'_>, rows: &mut [Row]) {
        let way = |a: u32| {
            let row = &body.state[a as usize];
            Vec3::new(row[0], row[1], row[2]) - body.reference.cloud.positions[a as usize]
        };
        let mut put = |a: u32, force: Vec3| (0..3).for_each(|k| rows[a as usize][k] += force[k]);
        for Spring { stiffness, direction } in &self.ground {
            for &(a, k) in stiffness {
                put(a, direction * (-k * direction.dot(&way(a))));
            }
        }
        for SpringBetween { stiffness, direction } in &self.between {
            for &([a, b], k) in stiffness {
                let apart = way(b) - way(a);
                let pull = direction * (k * direction.dot(&apart));
                put(a, pull);
                put(b, -pull);
            }
        }
        turning::add(&self.turning, body, rows);
    }

    /// Hands the derivatives of the forces of all springs on particles to `put`, as loads do theirs.
    pub(crate) fn stiffness(&self, body: &Body<'_>, put: &mut dyn FnMut(u32, u32, &Block)) {
        for Spring { stiffness, direction } in &self.ground {
            for &(a, k) in stiffness {
                put(a, a, &place_block(0, 0, &(direction * direction.transpose() * -k)));
            }
        }
        for SpringBetween { stiffness, direction } in &self.between {
            for &([a, b], k) in stiffness {
                let own = place_block(0, 0, &(direction * direction.transpose() * -k));
                let other = place_block(0, 0, &(direction * direction.transpose() * k));
                [(a, a, &own), (b, b, &own), (a, b, &other), (b, a, &other)]
                    .into_iter()
                    .for_each(|(a, b, block)| put(a, b, block));
            }
        }
        turning::stiffness(&self.turning, body, put);
    }
}
