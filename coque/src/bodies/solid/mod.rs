//! Peridynamic solids: from the scene's words to `peridynamics`.

mod bending;
mod body;
pub(super) mod build;
pub(super) mod conditions;
mod conduction;
mod describe;
mod ends;
pub(super) mod fields;
mod parts;
mod places;
pub(super) mod sets;
pub(super) mod skin;
mod warnings;
