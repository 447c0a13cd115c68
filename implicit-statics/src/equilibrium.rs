//! What a discrete system must offer to be solved without time.

use crate::OutOfBounds;

/// A system whose equilibria `internal(q) = external(q, λ)` are sought.
///
/// Unknowns are the free freedoms only: held ones are eliminated by the system. A state may live on a
/// manifold (directors on spheres): increments are taken in the tangent space of the present state and
/// [`Equilibrium::update`] moves along it.
pub trait Equilibrium {
    /// Number of free freedoms.
    fn unknowns(&self) -> usize;

    /// Positions `(row, column)` of the tangent's entries, lower triangle with the whole diagonal, each once.
    ///
    /// Known beforehand and the same for every state; the tangent's values come in this order.
    fn pattern(&self) -> Vec<(usize, usize)>;

    /// `out = ∂U/∂q` at the present state \[F, F L\].
    fn internal(&mut self, out: &mut [f64]);

    /// `out = external(q, λ)`, the loads at level λ.
    fn external(&mut self, level: f64, out: &mut [f64]);

    /// `out = ∂external/∂λ` at the present state.
    fn load_rate(&mut self, level: f64, out: &mut [f64]);

    /// Values of the symmetric tangent `∂(internal − external)/∂q` in the order of the pattern; the part of a
    /// follower load that is not symmetric is symmetrised: critical points are then those of the symmetric part.
    fn tangent(&mut self, level: f64, values: &mut [f64]);

    /// The tangent of the present, unstressed configuration with the stresses that a motion would bring: what
    /// [`crate::Prebuckling::Stress`] differentiates. False, and nothing done, where the system does not offer it.
    fn stressed_tangent(&mut self, _level: f64, _motion: &[f64], _values: &mut [f64]) -> bool {
        false
    }

    /// Moves the state by an increment in its present tangent space.
    fn update(&mut self, increment: &[f64]);

    /// A copy of the state, to come back to.
    fn save(&self) -> Vec<f64>;

    /// Comes back to a saved state.
    fn restore(&mut self, saved: &[f64]);

    /// Internal energy of the present state \[F L\].
    fn energy(&mut self) -> f64;

    /// Diagonal mass of each unknown \[M, M L²\], for modes of vibration.
    fn masses(&self) -> Vec<f64>;

    /// What an unknown is, for messages: the particle or node, and the direction.
    fn name_unknown(&self, unknown: usize) -> String;

    /// Refuses a state outside the range of the model, such as an element turned inside out, though it balances.
    ///
    /// # Errors
    /// The place and the number that is out of bounds.
    fn within_bounds(&self) -> Result<(), OutOfBounds> {
        Ok(())
    }
}
