//! Sections with memory: what they answer depends on what their points went through.
//!
//! A history h is some numbers of a point, zero where nothing has strained it. What strains ε make of it, and what they meet, are functions of
//! them and of the history h₀ that was committed last:
//!
//! ```text
//! h = H(ε, h₀)        σ = ∂W/∂ε        C = ∂σ/∂ε        at fixed h₀
//! ```
//!
//! W is the work done on the point since nothing had strained it: what is stored in it and what it has dissipated. Evaluations leave h₀ alone, so
//! that they may come in any number and order; a commit puts h in its place.

use crate::pack::Pack;
use crate::strains::{Resultants, Strains};
use crate::tangent::Matrix8;

/// The formulas of a section with memory, four points at a time.
pub trait Memory {
    /// Numbers of a history.
    fn history_len(&self) -> usize;

    /// What strains make of a committed history, and the resultants that they meet once it is committed.
    ///
    /// Of strains for which it was committed already, the same history but for rounding, unless what flows has an overstress that time takes away. `duration` is the
    /// time that the step takes \[T\], infinite at rest: what depends on rates is then as if all went slowly.
    fn history_from(
        &self,
        strains: &Strains,
        duration: f64,
        committed: &[Pack],
        trial: &mut [Pack],
    ) -> Resultants;

    /// Resultants from strains; they must be the derivative of [`Memory::energy_from`] at a fixed committed history.
    fn resultants_from(&self, strains: &Strains, committed: &[Pack]) -> Resultants;

    /// Resultants from strains while the history stays what it was committed: what unloading meets, the stiffest answer there is.
    fn held_resultants(&self, strains: &Strains, committed: &[Pack]) -> Resultants;

    /// `C = ∂σ/∂ε` at a fixed committed history, symmetric.
    fn tangent_from(&self, strains: &Strains, committed: &[Pack]) -> Matrix8;

    /// The share that the flow of the step committed last left of a stress beside the section's own, in (0, 1]: of what holds zero-energy modes.
    fn kept_share(&self, _committed: &[Pack]) -> Pack {
        Pack::splat(1.0)
    }

    /// Work per reference area \[F/L\]: stored energy and all that was dissipated.
    fn energy_from(&self, strains: &Strains, committed: &[Pack]) -> Pack;
}
