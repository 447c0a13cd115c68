//! Contact of fragments: short-range repulsion of nodes without a bond, and walls.

use sph_core::Vec3;

/// Short-range repulsion.
#[derive(Clone, Debug, PartialEq)]
pub struct Contact {
    /// Distance below which nodes without a bond repel each other, over the spacing \[–\].
    pub distance: f64,
    /// Planes that nodes do not pass: a point, and the normal towards the side of the body.
    pub walls: Vec<[Vec3; 2]>,
}
