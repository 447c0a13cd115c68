//! Causes of known failures that several cases name.

/// Why nodal sampling misses what is asked of plates and curved shells.
pub const NODAL: &str = "strains sampled at the particles lock as the shell gets thin, on lattices too: in shear on flat plates, in \
                         stretch on curved shells, worst with the widest rows (order 3); orders 1 and 2 are off by several percent \
                         while thick, at clamped edges and on disordered clouds. Not isolated further";

/// Why thin curved shells of uneven cells miss what is asked.
pub const UNEVEN: &str = "chords of curved cells fall short of arcs unevenly where cells are uneven, and membrane stiffness answers; what is given \
                          back is bounded, and lets the membrane give way a little, more where it is stretched by percents (docs/uneven-cells.md)";

/// Why wide stencils miss what is asked on irregular meshes.
pub const OTHER_PARTICLES: &str =
    "the kernel reaches other particles than those of the cell, as in the case disorder";

/// Why wide stencils cannot be built on some clouds.
pub const CONTRADICTION: &str = "the conditions of a consistent divergence contradict each other on a curved disordered cloud: refused, with the \
                             advice to use cells";
