//! An implicit finite-element shell: the cross-check of the particle shell, written without its mechanics.
//!
//! Four nodes with five degrees of freedom each: a position x and a unit director d that moves along great circles. Both are
//! bilinear over the element, the mid-surface and the director field carry resultants (degenerated solid). Strains are
//! covariant differences to the reference configuration, measured along edges:
//!
//! - membrane: Green–Lagrange, E_αβ = ½(a_α·a_β − A_α·A_β), tied at edges and centre (MITC4+, \[ko2017\]), then relaxed
//!   by seven enhanced modes (\[simo1990\], \[andelfinger1993\]) that are eliminated once: see `membrane`;
//! - bending: κ = sym(k − E k) − B with k_ab = a_a·d,_b, the stretch taken out: see `point`; differences of directors
//!   are measured as arcs: see `geometry`;
//! - transverse shear: γ_α = a_α·d − A_α·D, tied at the middle of the edges (MITC4, \[dvorkin1984\]).
//!
//! All are products of differences of nodal vectors, so that rigid motions are free of strain at any size and the
//! tangent is a closed form: material part, second derivatives of the strains, curvature of the director's sphere.
//! Limits: strains small compared with one (rotations any), thickness small compared with the radii of curvature
//! (no shifter in the integral through the thickness), loads dead, mass lumped.

pub mod cases;

mod assembly;
mod director;
mod element;
mod geometry;
mod load;
mod membrane;
mod mesh;
mod model;
mod point;
mod rows;
mod section;
mod support;

pub use load::Load;
pub use mesh::{Mesh, Side};
pub use model::{FeShellError, Model};
pub use section::{Orthotropic, Ply, SHEAR_FACTOR, Section, Stiffness};
pub use support::{Support, Turning};
