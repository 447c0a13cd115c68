//! All supports of a shell, joined particle by particle.

use crate::conditions::supports::{Constraint, DirectorHold, Holds, Supported};
use crate::error::ShellError;
use crate::reference::Reference;

/// A director held in a plane may stand out of it by this much: rounding of positions and rotations, and no more.
const OUT_OF_PLANE: f64 = 1e-6;

/// What is held of each particle.
pub(crate) struct Constraints {
    /// Number of each particle's entry in `all`, one up; zero for a free particle.
    pub of_particle: Vec<u32>,
    pub all: Vec<Constraint>,
}

impl Constraints {
    /// Joins all supports of each particle.
    ///
    /// # Errors
    /// [`ShellError`] for empty and unknown sets, planes that directors stand out of, and supports that contradict each other.
    pub fn new(reference: &Reference, supports: &[Supported]) -> Result<Self, ShellError> {
        let cloud = &reference.cloud;
        let count = cloud.len();
        let mut asked: Vec<Vec<(usize, Holds)>> = vec![Vec::new(); count];
        for (support, supported) in supports.iter().enumerate() {
            if supported.particles.is_empty() {
                return Err(ShellError::EmptySet("a support"));
            }
            for &particle in &supported.particles {
                let list = asked.get_mut(particle as usize).ok_or(ShellError::NoSuchParticle {
                    what: "a support",
                    particle,
                    count,
                })?;
                let holds = supported.support.holds().about(&reference.origin);
                if let DirectorHold::InPlane(normal) = holds.director {
                    // The turn that is left free runs along ν × d.
                    let along = normal.dot(&cloud.frames[particle as usize].n);
                    if along.abs() > OUT_OF_PLANE {
                        return Err(ShellError::OutOfPlane { support, particle, along });
                    }
                }
                list.push((support, holds));
            }
        }
        let mut tied = vec![false; if cloud.joined.is_empty() { 0 } else { count }];
        for group in &cloud.joined {
            // What one particle of a group is asked all are, each support once.
            let mut all: Vec<_> =
                group.iter().flat_map(|&a| std::mem::take(&mut asked[a as usize])).collect();
            all.sort_by_key(|(support, _)| *support);
            all.dedup_by_key(|(support, _)| *support);
            for &a in group {
                asked[a as usize].clone_from(&all);
                tied[a as usize] = true;
            }
        }
        let tied = |particle: usize| tied.get(particle).copied().unwrap_or_default();
        let mut of_particle = vec![0; count];
        let mut all = Vec::new();
        for (particle, list) in asked.iter().enumerate().filter(|(a, list)| !list.is_empty() || tied(*a)) {
            let rest = (cloud.positions[particle], cloud.frames[particle].n);
            let joined = Constraint::join(particle as u32, rest, list)?;
            all.push(Constraint { tied: tied(particle), ..joined });
            of_particle[particle] = all.len() as u32;
        }
        Ok(Self { of_particle, all })
    }

    /// What is held of a particle.
    pub fn of(&self, particle: usize) -> Option<&Constraint> {
        let number = self.of_particle[particle] as usize;
        number.checked_sub(1).map(|i| &self.all[i])
    }

    /// Holds some particles so, whatever held them before.
    pub fn hold(&mut self, particles: &[u32], constraint: Constraint) {
        self.all.push(constraint);
        let number = self.all.len() as u32;
        particles.iter().for_each(|&a| self.of_particle[a as usize] = number);
    }
}
