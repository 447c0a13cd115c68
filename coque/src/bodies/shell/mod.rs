//! Shells of one layer of particles: from the scene's words to `sph-shell`.

pub(crate) mod build;
pub(crate) mod doubts;
pub(crate) mod imported;
mod material;
mod places;
mod rigid;
mod velocity;
