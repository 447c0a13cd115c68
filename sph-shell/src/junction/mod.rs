//! Junctions: sheets that meet along a line, each with a particle and a director of its own there.
//!
//! The particles of a group stand on one place and turn by one rotation, `d_k = R d_k0`; cells know nothing of it. With
//! `f_k = ∂U/∂x_k`, `n_k = ∂U/∂d_k` and the loads' `e_k`:
//!
//! ```text
//! force     F = Σ f_k             torque  τ = Σ d_k × n_k
//! variation δx_k = δx,  δd_k = θ × d_k  =  −[d_k]× θ          six unknowns a group
//! tangent   Σ_kl T_kᵀ H_kl T_l  +  Σ_k [½(p_k d_kᵀ + d_k p_kᵀ) − (p_k·d_k) 1],   T_k = [1 0; 0 −[d_k]×],  p_k = n_k − e_k
//! march     m = Σ m_k,  I = Σ I_k (a number),   I ω̇ = −Σ d_k × p_k,   d_k ← exp(Δt ω) d_k
//! modes     Σ ρtA_k t²/12 (1 − d_k d_kᵀ)
//! ```
//!
//! The last term of the tangent is the second variation along the rotation. A number I has no gyroscopic term and keeps moment of
//! momentum to round-off; tying is a constraint and lowers no period, so the stable step is at least that of the sheets.
//!
//! A rigid body is a group whose particles stand apart: `δx_k = δx + θ × a_k` with arms a_k, and the terms of arms and forces are those of
//! directors and couples. Its inertia is a tensor (`body.rs`), and supports hold or move its reference point (`guide.rs`).

pub(crate) mod body;
pub(crate) mod group;
mod guide;
mod kick;
mod march;
pub(crate) mod rigid;
pub(crate) mod rotation;
pub(crate) mod spectrum;
pub(crate) mod springs;
mod statics;
