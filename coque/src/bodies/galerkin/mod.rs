//! Galerkin solids: from the scene's words to `sr-galerkin`.

mod body;
pub(super) mod build;
mod conditions;
mod conduction;
mod describe;
mod faces;
mod fields;
mod joined;
mod parts;
mod places;
mod recovery;
pub(super) mod solid;
mod warnings;
mod widened;
