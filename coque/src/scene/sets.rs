//! Named sets of particles: those that every scene has, and regions.

use schemars::JsonSchema;
use serde::Deserialize;

/// Sets that every scene has.
pub(crate) const BUILT_IN: [&str; 11] =
    ["all", "u0", "u1", "v0", "v1", "u0v0", "u1v0", "u0v1", "u1v1", "centre-row", "centre-column"];

/// Built-in sets that are edges: particles in a row, each with a tributary length.
pub(crate) const EDGES: [&str; 4] = ["u0", "u1", "v0", "v1"];

/// Picks particles; exactly one of `nearest`, `box` and `plane` is given, in the un-turned frame.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Region {
    /// The body whose particles are picked; may be left out where there is one.
    pub of: Option<String>,
    /// The one particle nearest to this point \[L\].
    pub nearest: Option<[f64; 3]>,
    /// All particles in a box, its faces included.
    #[serde(rename = "box")]
    pub inside: Option<Box3>,
    /// All particles on a plane.
    pub plane: Option<OnPlane>,
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
    pub within: Option<f64>,
}
