//! What a system must offer to be marched: force, kick, drift.

use serde::{Deserialize, Serialize};

use crate::OutOfBounds;

/// A moment of a run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Instant {
    /// Time \[T\].
    pub time: f64,
    /// Load level λ \[–\]: scales driven loads and prescribed motions; one in a transient run.
    pub level: f64,
}

/// One step of central differences, from `from` to `to`.
#[derive(Clone, Copy, Debug)]
pub struct Step {
    /// Where the forces were evaluated.
    pub from: Instant,
    /// Where the configuration arrives.
    pub to: Instant,
    /// Span of the velocity update \[T\]: from the middle of the last step to the middle of this one.
    pub kick: f64,
    /// Mass-proportional damping c \[1/T\].
    pub damping: f64,
}

impl Step {
    /// Span of the configuration update \[T\].
    pub fn drift(&self) -> f64 {
        self.to.time - self.from.time
    }
}

/// What one kick did.
#[derive(Clone, Copy, Debug, Default)]
pub struct Work {
    /// Kinetic energy at `from`, with the mean of the velocities before and after the kick \[F L\].
    pub kinetic: f64,
    /// Work of loads and of prescribed motions over the kick \[F L\].
    pub external: f64,
    /// Energy taken by mass-proportional damping over the kick \[F L\].
    pub dissipated: f64,
}

/// A mechanical system that central differences can march.
///
/// Velocities live half a step before the configuration. The order of calls is
/// `force(from)`, then `kick`, then `drift`, over and over.
pub trait Dynamics {
    /// Evaluates internal and external forces for the present configuration.
    ///
    /// With `energy` the internal energy is found as well.
    fn force(&mut self, at: Instant, energy: bool);

    /// Internal energy found by the last `force` that was asked for it \[F L\].
    fn internal_energy(&self) -> f64;

    /// Advances the velocities by `v ← [v(1 − ½cκ) + κ f/m]/(1 + ½cκ)`, κ the span of the kick.
    fn kick(&mut self, step: &Step) -> Work;

    /// Advances the configuration with the velocities over [`Step::drift`].
    fn drift(&mut self, step: &Step);

    /// The whole step: forces at `step.from`, kick, drift; override it where one sweep over the data is cheaper.
    fn advance(&mut self, step: &Step) -> Work {
        self.force(step.from, false);
        let work = self.kick(step);
        self.drift(step);
        work
    }

    /// Sets all velocities to zero (kinetic damping).
    fn stop(&mut self);

    /// The particle with the greatest speed, and that speed \[L/T\]; not a number counts as greatest.
    fn fastest(&self) -> (usize, f64);

    /// Speed no particle of a sound run reaches \[L/T\], for example the speed of sound.
    fn speed_bound(&self) -> f64;

    /// Refuses a configuration outside the range of the model, such as an element turned inside out.
    ///
    /// # Errors
    /// The place and the number that is out of bounds.
    fn within_bounds(&self) -> Result<(), OutOfBounds> {
        Ok(())
    }
}
