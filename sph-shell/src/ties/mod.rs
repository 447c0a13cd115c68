//! Ties: the edge of a sheet along another whose particles stand elsewhere.
//!
//! A particle t of the edge has no unknowns of its own. It hangs on the cell of the host below it, with corners b, the numbers
//! φ_b of their bilinear interpolation at t and G_αb of the cell's gradient:
//!
//! ```text
//! x_t = Σ φ_b (x_b + h d_b) + ½ S:(k − K) m   m = Σ φ_b d_b,  k_αβ = x,α·d,β,  S = Σ φ_b ξ_b ξ_b about t,  h the height at rest
//! d_t = R R₀ᵀ D_t                             R = [e₁ e₂ e₃],  e₃ along m,  e₁ along the part of w across e₃,  w = l₁ x,₁ + l₂ x,₂
//! ```
//!
//! Where several cells are equally near it hangs on the mean of all of them (`host.rs`).
//!
//! S takes the chord of a bent cell to its arc: bilinear places alone fail the patch test of bending. l is the direction of the edge in the
//! cell: about the normal directors turn as the line does on which they stand. With the mean spin of the cell in its place they would
//! lag behind the line by half of the cell's shear, and a box in torsion would be .25 % too stiff.
//!
//! Both are functions of places and directors alone. Forces go back by their transpose `Zᵀ[f, n]`, which keeps force and moment; the
//! tangent is `Zᵀ H Z` with the second variation `f·∂²x_t + n·∂²d_t`. Corners may be free, members of a junction, or tied
//! themselves: edges are taken in an order in which none comes before what hangs on it. Masses are lumped, `m_b ← φ_b m_t`.

pub(crate) mod hanging;
mod host;
mod lines;
pub(crate) mod list;
pub(crate) mod loss;
mod statics;
