//! What holds zero-energy modes, and what corrects the strains of uneven stencils.

pub(crate) mod arcs;
pub(crate) mod cells;
pub(crate) mod pairs;
pub(crate) mod shear;
pub(crate) mod yielding;
