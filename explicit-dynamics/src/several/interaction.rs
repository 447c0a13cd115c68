//! What a system offers to others that act on it, and what acts between systems.

use std::any::Any;

use crate::dynamics::Dynamics;
use crate::error::OutOfBounds;
use crate::linearised::MassScaled;
use crate::step::Instant;

/// Places on which an interaction acts, with their velocities and masses.
pub struct Places<'a> {
    /// Positions \[L\].
    pub at: &'a [[f64; 3]],
    /// Velocities \[L/T\].
    pub velocities: &'a [[f64; 3]],
    /// Masses that move with them at least \[M\].
    pub masses: &'a [f64],
}

/// A system of particles on which others act.
pub trait Joinable: Dynamics + MassScaled {
    /// Number of its particles; [`Dynamics::within_bounds`] may name no other.
    fn particles(&self) -> usize;

    /// Positions \[L\] of some particles. A system whose particles have directors may number those as places of unit length behind its particles:
    /// here and in what follows.
    fn places(&self, particles: &[u32], out: &mut [[f64; 3]]);

    /// Velocities \[L/T\] of some particles.
    fn velocities(&self, particles: &[u32], out: &mut [[f64; 3]]);

    /// Masses that move with some particles at least: `Σ m |v|²` is no more than twice the kinetic energy, whatever the motion \[M\].
    fn masses(&self, particles: &[u32]) -> Vec<f64>;

    /// Takes away all forces that others exert.
    fn release(&mut self);

    /// Exerts forces on some particles \[F\] beside those that others exert, in each evaluation from now on until they are taken away.
    fn exert(&mut self, particles: &[u32], forces: &[[f64; 3]]);

    /// How some particles move in a mass-scaled motion: `M^{-½} v`, without what supports hold.
    fn unscaled(&self, particles: &[u32], v: &[f64], out: &mut [[f64; 3]]);

    /// Adds forces on some particles in mass-scaled coordinates, `M^{-½} f`, without what supports hold.
    fn add_scaled(&self, particles: &[u32], forces: &[[f64; 3]], out: &mut [f64]);
}

/// What several systems do to each other: an energy of the places of some of their particles.
///
/// Those are numbered through in the order of [`Interaction::particles`], system after system. Whoever made it may read it again by its type.
pub trait Interaction: Any + Send {
    /// Particles on which it acts, a list for each system; it never changes.
    fn particles(&self) -> Vec<Vec<u32>>;

    /// Puts what is prescribed of it where an instant has that.
    fn put(&mut self, _at: Instant) {}

    /// Whether something prescribed, which is no system, takes part: its work is external then, as that of loads, but for what it loses, and it
    /// has no energy.
    fn is_external(&self) -> bool {
        false
    }

    /// Fills in the forces at present places; returns its energy \[F L\].
    fn evaluate(&mut self, places: &[[f64; 3]], forces: &mut [[f64; 3]]) -> f64;

    /// Whether its forces are those of velocities and take energy out: it has none of its own, and what they do is dissipated.
    fn damps(&self) -> bool {
        false
    }

    /// Shows velocities to one that damps before each evaluation: those before the kick of the step that starts at the instant.
    fn see(&mut self, _at: Instant, _velocities: &[[f64; 3]]) {}

    /// A bound of the rate at which it lets motions of places of these masses decay \[1/T\]; none but of one that damps.
    fn damping(&self, _masses: &[f64]) -> f64 {
        0.0
    }

    /// Fills in the forces that resist a small motion at places, those last evaluated, `∂²U/∂x² u`.
    fn resist(&self, places: &[[f64; 3]], motion: &[[f64; 3]], forces: &mut [[f64; 3]]);

    /// A bound of the square of its highest frequency, places having these masses \[1/T²\].
    fn fastest(&self, masses: &[f64]) -> f64;

    /// Whether it exerts nothing in the step to come, whatever places are: they are not read then. Asked once a step.
    fn rests(&mut self) -> bool {
        false
    }

    /// The step to take next, at most the stable one, as [`Dynamics::shortened`]; the next evaluation is of the same places.
    fn shortened(&mut self, stable: f64, _safety: f64, _now: &Places<'_>) -> f64 {
        stable
    }

    /// Takes note that places have moved: what was found for them before a step that a record was taken in is not that of the next evaluation.
    fn moved(&mut self) {}

    /// Refuses a state outside the range of the model.
    ///
    /// # Errors
    /// The place, and the number that is out of bounds.
    fn within_bounds(&self) -> Result<(), OutOfBounds> {
        Ok(())
    }

    /// Energy that it lost on the way to the places last evaluated, from those of the last commit \[F L\].
    fn lost(&self) -> f64 {
        0.0
    }

    /// Makes the history of the places last evaluated the one that counts: a step was taken from there.
    fn commit(&mut self) {}

    /// Energy lost at a place until the last commit \[F L\].
    fn lost_at(&self, _place: usize) -> f64 {
        0.0
    }

    /// What belongs to a state beside the motion of the systems.
    fn kept(&self) -> Vec<f64> {
        Vec::new()
    }

    /// Takes up what [`Interaction::kept`] gave, where places have these masses \[M\]; false if it is that of another.
    fn take_up(&mut self, kept: &[f64], _masses: &[f64]) -> bool {
        kept.is_empty()
    }
}
