//! Shells of one layer of particles: from the scene's words to `sph-shell`.

mod arrays;
mod attached;
mod balance;
mod body;
pub(crate) mod build;
mod cells;
mod columns;
mod contacts;
mod describe;
mod edges;
mod fields;
pub(crate) mod imported;
mod indicator;
mod linear_forces;
pub(super) mod material;
mod own_contact;
mod parts;
mod places;
mod plies;
mod refusal;
mod rigid;
mod sections;
mod start;
mod thickness;
pub(super) mod tools;
pub(crate) mod warnings;
mod yielding;
