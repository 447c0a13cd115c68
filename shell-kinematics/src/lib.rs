//! One point of a shell: frames, finite rotations, strains with their transposes, sections.
//!
//! This crate knows neither neighbours nor time. A point is given by five vectors, its
//! [`Placement`]: the tangents `x,1` `x,2` of the mid-surface along two orthonormal reference
//! directions, the director `d`, and the director's derivatives `d,1` `d,2`. From them follow, in
//! this order,
//!
//! | step | type | function |
//! |---|---|---|
//! | products of the vectors | [`Measures`] | [`Placement::measures`] |
//! | strains | [`Strains`] | [`StrainMeasure::strains`] |
//! | stress resultants | [`Resultants`] | [`Section::resultants`] |
//! | back to the products | [`MeasureForces`] | [`StrainMeasure::transpose`] |
//! | back to the vectors | [`PlacementForces`] | [`Placement::transpose`] |
//!
//! Every step stands beside its transpose, so that forces are the exact derivative of the energy.
//! Four points are treated at a time in a [`Pack`]; formulas read as if it were one number.

mod frame;
mod integrated_section;
mod layered_section;
mod pack;
mod placement;
mod rotation;
mod section;
mod strain;
mod tangent;

pub use frame::{covariant_green_lagrange, local_green_lagrange, natural_basis};
pub use integrated_section::IntegratedSection;
pub use layered_section::{LayeredSection, Orthotropic, Ply};
pub use pack::{LANES, Pack, Pack3};
pub use placement::{MeasureForces, Measures, Placement, PlacementForces};
pub use rotation::{parallel_transport, rodrigues, tangent_map};
pub use section::{
    Isotropic, IsotropicSection, MaterialError, Resultants, Section, SectionScales, linear_tangent,
};
pub use strain::{GreenLagrange, StrainMeasure, Strains, StretchCorrected, strain_measure, strain_measures};
pub use tangent::{Matrix8, Matrix15, ZERO8, add_second_derivatives, congruence};
