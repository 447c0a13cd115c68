//! Sections that yield, by plane-stress plasticity at points through the thickness, and sections of rubber.

mod energies;
mod flow_step;
mod functions;
mod hardening;
mod hill;
mod layer;
mod met;
mod modes;
mod ply;
mod point;
mod rate;
mod return_map;
mod rubber;
mod rubber_section;
mod section;
mod slices;
mod tallies;
mod tangent;
mod thickness;

pub use hardening::Hardening;
pub use hill::RValues;
pub use ply::{Plastic, PlasticPly, PlyMaterial};
pub use point::{BackStress, MOST_BACK_STRESSES};
pub use rate::Rate;

pub use rubber::Rubber;
pub use rubber_section::RubberSection;
pub use section::PlasticSection;
pub use tallies::Tallies;
