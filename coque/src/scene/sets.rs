//! Named sets of particles: those that every scene has, and regions.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::scene::bounded::Positive;

/// Sets that every shell has.
pub(crate) const BUILT_IN: [&str; 11] =
    ["all", "u0", "u1", "v0", "v1", "u0v0", "u1v0", "u0v1", "u1v1", "centre-row", "centre-column"];

/// Sets that every solid has: all nodes, and those on the faces of its block.
pub(crate) const OF_SOLIDS: [&str; 7] = ["all", "x0", "x1", "y0", "y1", "z0", "z1"];

/// Sets that every rigid body has: the body itself, at its centre of mass.
pub(crate) const OF_RIGID_BODIES: [&str; 1] = ["all"];

/// Sets that every fluid has.
pub(crate) const OF_FLUIDS: [&str; 1] = ["all"];

/// Sets that walls have: all of them and, of a basin, its sides.
pub(crate) const OF_WALLS: [&str; 7] = OF_SOLIDS;

/// Built-in sets that are edges: particles in a row, each with a tributary length.
pub(crate) const EDGES: [&str; 4] = ["u0", "u1", "v0", "v1"];

/// Picks particles; exactly one of `nearest`, `box`, `plane` and, of a solid, `layer` is given, in the un-turned frame.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Region {
    /// The body whose particles, or places of whose walls, are picked; may be left out where there is one.
    pub of: Option<String>,
    /// The one particle nearest to this point \[L\].
    pub nearest: Option<[f64; 3]>,
    /// All particles in a box, its faces included.
    #[serde(rename = "box")]
    pub inside: Option<Box3>,
    /// All particles on a plane.
    pub plane: Option<OnPlane>,
    /// All nodes of a solid within a depth of a face of its block.
    pub layer: Option<Layer>,
}

/// A layer under a face of a block.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Layer {
    /// The face, one of `x0`, `x1`, `y0`, `y1`, `z0`, `z1`.
    pub face: String,
    /// Its depth from the face \[L\].
    pub depth: Positive,
}

/// Axis-parallel box.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Box3 {
    /// Least coordinates \[L\].
    pub min: [f64; 3],
    /// Greatest coordinates \[L\].
    pub max: [f64; 3],
}

/// Plane.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OnPlane {
    /// A point of the plane \[L\].
    pub point: [f64; 3],
    /// Its normal; the length does not matter.
    pub normal: [f64; 3],
    /// Greatest distance from the plane \[L\]; a thousandth of the spacing without.
    pub within: Option<Positive>,
}
