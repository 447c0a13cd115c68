//! Hard cases of Galerkin solids: slender and thin bodies, nodes out of order, near incompressibility, steps too far, cycles of strain.

pub mod refusals;
pub mod solids;
