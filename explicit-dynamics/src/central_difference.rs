//! Central differences with velocities at the half steps: one kick, one drift a step.

use crate::{Dynamics, Step, Work};

/// A rule that carries a system over one step whose forces are already evaluated.
pub trait Integrator {
    /// Advances velocities and configuration.
    fn advance(&self, system: &mut dyn Dynamics, step: &Step) -> Work;
}

/// Kick, then drift: the leapfrog form of velocity Verlet (the same trajectory of configurations).
#[derive(Clone, Copy, Debug, Default)]
pub struct CentralDifference;

impl Integrator for CentralDifference {
    fn advance(&self, system: &mut dyn Dynamics, step: &Step) -> Work {
        system.kick_drift(step)
    }
}
