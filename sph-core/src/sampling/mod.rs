//! Sampling operators: stencils, their corrections, divergence consistency, and what is uneven between neighbours;
//! shape functions on nodes in space.

pub(crate) mod cell_stencil;
pub(crate) mod consistent;
pub(crate) mod correction;
pub(crate) mod kernel_operator;
pub(crate) mod moving_least_squares;
pub(crate) mod nodal_operator;
pub(crate) mod operator;
pub(crate) mod spin;
pub(crate) mod unevenness;
