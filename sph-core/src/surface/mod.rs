//! Surfaces and the clouds of particles on them: patches, lattices, scattered particles, their cells, frames and edges.

pub(crate) mod boundary;
pub(crate) mod cell;
pub(crate) mod cloud;
pub(crate) mod flips;
pub(crate) mod frame;
pub(crate) mod graded;
pub(crate) mod jitter;
pub(crate) mod lattice;
pub(crate) mod matching;
pub(crate) mod numbering;
pub(crate) mod pairing;
pub(crate) mod patch;
pub(crate) mod poisson;
pub(crate) mod sides;
pub(crate) mod surface_mesh;
pub(crate) mod triangulate;
