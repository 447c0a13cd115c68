//! A thin plate of two plane-stress sheets of bonds, on directors.
//!
//! A column of the plate has a place x on the mid-surface and a director d, a free vector through the thickness t that is one
//! at rest. Its two points `y± = x ± z₀ d` lie at the Gauss heights `z₀ = t/(2√3)` and belong to two sheets, each a network
//! of bonds of thickness t/2: `2 · ½t · z₀² = t³/12`, so that bending is exact as the membrane is. Sheets know nothing of
//! transverse shear and of the thickness; pairs and columns store it:
//!
//! ```text
//! U = U₊(x + z₀ d) + U₋(x − z₀ d) + Σ_pairs ½ k γ² + Σᵢ ½ E t Aᵢ [½ (d·d − d₀·d₀)]²
//! γ = (xⱼ − xᵢ)/r · ½ (dᵢ + dⱼ) − γ₀             k = 2 w/(1/(⅚ μ t) + r²/(12 D)),   Σ_pairs w = Σᵢ Aᵢ
//! ```
//!
//! γ vanishes for every deflection of the second degree with its normals. Higher ones leave of the order of r² in it, which a
//! thin plate could not bear at ⅚ μ t: `r²/(12 D)` in series is the compliance that a strip of length r has in bending.

mod columns;
mod plate;
mod rest_shape;
mod shear;
mod sheet;
mod tangent;

pub(crate) use plate::Plate;
