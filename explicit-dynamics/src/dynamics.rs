//! What a system must offer to be marched: forces, kick, drift, its stable step and its bounds.

use crate::error::{MarchError, OutOfBounds};
use crate::linearised::MassScaled;
use crate::stable_step::StableStep;
use crate::step::{Instant, Step, Work};

/// A mechanical system that central differences can march; object-safe, at the cost of one virtual call a step.
///
/// Velocities live half a step before the configuration. The order of calls is `evaluate(from)`, then `kick`, then
/// `drift`, over and over; [`Dynamics::advance`] is all three.
pub trait Dynamics {
    /// Evaluates internal and external forces for the present configuration; returns the stored energy \[F L\].
    fn evaluate(&mut self, at: Instant) -> f64;

    /// Advances the velocities by `v ← [v(1 − ½cκ) + κ f/m]/(1 + ½cκ)`, κ the span of the kick.
    ///
    /// Supports then put in the velocities that they prescribe, whatever the span: a kick of none does that at once, and its
    /// external work is the kinetic energy that they give.
    fn kick(&mut self, step: &Step) -> Work;

    /// Advances the configuration with the velocities over [`Step::drift`].
    fn drift(&mut self, step: &Step);

    /// The whole step: forces at `step.from`, kick, drift.
    ///
    /// Steps without a record take this way and need no energy; override it where that, or one sweep over the data, is
    /// cheaper.
    fn advance(&mut self, step: &Step) -> Work {
        self.evaluate(step.from);
        let work = self.kick(step);
        self.drift(step);
        work
    }

    /// The step to take in the present configuration: the largest stable one, times a safety \[–\].
    ///
    /// Systems with a tangent leave it to [`crate::lanczos_step`]. Forces evaluated before are lost.
    ///
    /// # Errors
    /// [`MarchError::NoStableStep`].
    fn stable_step(&mut self, safety: f64) -> Result<StableStep, MarchError>;

    /// The step to take next, at most the stable one \[T\], which was found with a safety \[–\]: shorter where something comes that no
    /// spectrum knows beforehand, such as parts that are about to meet. Asked for before every step, once.
    fn shortened(&mut self, stable: f64, _safety: f64) -> f64 {
        stable
    }

    /// Refuses a motion too fast, or a configuration outside the range of the model.
    ///
    /// # Errors
    /// The particle or place, and the number that is out of bounds.
    fn within_bounds(&self, bounds: Bounds) -> Result<(), OutOfBounds>;

    /// Sets all velocities to zero (kinetic damping).
    fn stop(&mut self);

    /// The system in mass-scaled coordinates, from which a quasi-static march tells how far it is from rest; none where
    /// nothing is at rest, and such marches are refused.
    fn linearised(&mut self) -> Option<&mut dyn MassScaled> {
        None
    }
}

/// Which bounds are asked for: those of the motion cost a pass over the particles, and are asked for more often.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bounds {
    /// Speeds that no particle of a sound run reaches, for example the speed of sound; not a number is beyond them.
    Motion,
    /// The range of the model, which an element turned inside out has left, for example.
    Configuration,
}
