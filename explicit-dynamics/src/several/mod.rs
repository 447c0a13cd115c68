//! Several systems on one clock, and what they do to each other.
//!
//! All take the same step, the least stable one of all. Without an [`Interaction`] each is marched by its own [`Dynamics::advance`], to the
//! bits that it has alone at that step. With one, its forces at the present places stand among the external forces of the systems while
//! they are kicked; since the work on both sides of a force between systems is not external, its energy is counted as internal:
//!
//! ```text
//! U ← Σ U_k + U_i        W ← Σ W_k − κ Σ f·v̄        f = −∂U_i/∂x at places,  v̄ the mean of the velocities before and after the kick
//! ```
//!
//! The stable step follows from `λ_max(A + B) ≤ λ_max(A) + λ_max(B)`: with ω_k² = (2s/Δt_k)² of the least step of the systems at a safety s
//! and a bound ω_i² of the interaction alone on the masses of its places, `Δt = 2s/√(ω_k² + ω_i²)`.

mod acting;
mod interaction;
mod interactions;
mod linearised;
mod system;

pub use interaction::{Interaction, Joinable, Places};
pub use interactions::Interactions;
pub use system::Several;
