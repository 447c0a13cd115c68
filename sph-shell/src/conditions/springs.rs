//! Springs to the ground: forces along fixed directions that grow with the displacement, in every analysis.
//!
//! They stand among the external forces, since they are no strain: `f_a = −k_a (n·u_a) n`, with the stiffness `k_a n nᵀ`. No level scales
//! them. What they bear is a reaction.

use sph_core::Vec3;

use crate::Shell;
use crate::conditions::loads::{Block, check_set, place_block};
use crate::error::ShellError;
use crate::packs::Row;

/// Springs between particles and the ground, along a direction.
#[derive(Clone, Debug)]
pub struct Spring {
    /// Particles and the stiffness of each \[F/L\].
    pub stiffness: Vec<(u32, f64)>,
    /// Direction (any length).
    pub direction: Vec3,
}

impl Shell {
    /// Adds springs to the ground.
    ///
    /// # Errors
    /// [`ShellError`] for an empty set, a particle beyond the cloud, a stiffness that is not positive and finite.
    pub fn spring(&mut self, springs: Vec<Spring>) -> Result<(), ShellError> {
        for spring in &springs {
            check_set("a spring", spring.stiffness.iter().map(|s| s.0), &self.reference)?;
            let bad = spring.stiffness.iter().find(|(_, k)| !(*k > 0.0 && k.is_finite()));
            if let Some(&(particle, stiffness)) = bad {
                return Err(ShellError::Spring { particle, stiffness });
            }
        }
        if !springs.is_empty() {
            self.external.resize(self.len(), [0.0; 6]);
            self.sprung.resize(self.len(), [0.0; 6]);
        }
        let unit = |spring: Spring| Spring { direction: spring.direction.normalize(), ..spring };
        self.springs.extend(springs.into_iter().map(unit));
        Ok(())
    }

    /// Hands the force of every spring in the present state to `put` \[F\].
    fn each_spring(&self, mut put: impl FnMut(u32, Vec3)) {
        for Spring { stiffness, direction } in &self.springs {
            for &(a, k) in stiffness {
                let along = direction.dot(&self.displacement(a as usize));
                put(a, direction * (-k * along));
            }
        }
    }

    /// Forces of all springs in the present state, a row each particle; nothing without springs.
    pub(crate) fn spring_rows(&self, rows: &mut [Row]) {
        rows.fill([0.0; 6]);
        self.each_spring(|a, force| (0..3).for_each(|k| rows[a as usize][k] += force[k]));
    }

    /// Evaluates the springs and adds their forces to the external ones.
    pub(crate) fn evaluate_springs(&mut self) {
        let mut rows = std::mem::take(&mut self.sprung);
        self.spring_rows(&mut rows);
        for (sum, row) in self.external.iter_mut().zip(&rows) {
            (0..3).for_each(|k| sum[k] += row[k]);
        }
        self.sprung = rows;
    }

    /// Hands the derivatives of the forces of all springs to `put`, as loads do theirs.
    pub(crate) fn spring_stiffness(&self, put: &mut dyn FnMut(u32, u32, &Block)) {
        for Spring { stiffness, direction } in &self.springs {
            for &(a, k) in stiffness {
                put(a, a, &place_block(0, 0, &(direction * direction.transpose() * -k)));
            }
        }
    }

    /// What its springs exert on a particle \[F\], for the last forces evaluated.
    pub(crate) fn sprung(&self, particle: usize) -> Row {
        self.sprung.get(particle).copied().unwrap_or_default()
    }
}
