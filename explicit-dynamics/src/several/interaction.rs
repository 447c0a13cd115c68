//! What a system offers to others that act on it, and what acts between systems.

use crate::dynamics::Dynamics;
use crate::linearised::MassScaled;

/// A system of particles on which others act.
pub trait Joinable: Dynamics + MassScaled {
    /// Number of its particles; [`Dynamics::within_bounds`] may name no other.
    fn particles(&self) -> usize;

    /// Positions \[L\] of some particles.
    fn places(&self, particles: &[u32], out: &mut [[f64; 3]]);

    /// Velocities \[L/T\] of some particles.
    fn velocities(&self, particles: &[u32], out: &mut [[f64; 3]]);

    /// Masses that move with a particle at least \[M\].
    fn mass(&self, particle: u32) -> f64;

    /// Exerts forces on some particles \[F\], always the same ones, in each evaluation from now on until others are given.
    fn exert(&mut self, particles: &[u32], forces: &[[f64; 3]]);

    /// How some particles move in a mass-scaled motion: `M^{-½} v`, without what supports hold.
    fn unscaled(&self, particles: &[u32], v: &[f64], out: &mut [[f64; 3]]);

    /// Adds forces on some particles in mass-scaled coordinates, `M^{-½} f`, without what supports hold.
    fn add_scaled(&self, particles: &[u32], forces: &[[f64; 3]], out: &mut [f64]);
}

/// What several systems do to each other: an energy of the places of some of their particles.
///
/// Those are numbered through in the order of [`Interaction::particles`], system after system.
pub trait Interaction: Send {
    /// Particles on which it acts, a list for each system; it never changes.
    fn particles(&self) -> Vec<Vec<u32>>;

    /// Fills in the forces at present places; returns its energy \[F L\].
    fn evaluate(&mut self, places: &[[f64; 3]], forces: &mut [[f64; 3]]) -> f64;

    /// Fills in the forces that resist a small motion at the places last evaluated, `∂²U/∂x² u`.
    fn resist(&self, motion: &[[f64; 3]], forces: &mut [[f64; 3]]);

    /// A bound of the square of its highest frequency, places having these masses \[1/T²\].
    fn fastest(&self, masses: &[f64]) -> f64;
}
