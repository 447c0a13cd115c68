//! Sections that yield: plane-stress plasticity at points through the thickness.

mod functions;
mod hardening;
mod modes;
mod return_map;
mod section;
mod slices;
mod tallies;
mod tangent;
mod thickness;

pub use hardening::Hardening;
pub use section::{Plastic, PlasticPly, PlasticSection};
pub use tallies::Tallies;
