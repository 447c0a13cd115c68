//! What something goes through: a line, a face, a cut.

use schemars::JsonSchema;
use serde::Deserialize;

/// A line of a plane, a face in space: the part between bounds of what lies across a normal. Of a shell all of it, and the force is that with which
/// what lies beyond, where the normal points, pulls at the rest.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Through {
    /// A point of it \[L\].
    pub point: [f64; 3],
    /// Its normal, along which flow counts as positive; the length does not matter.
    pub normal: [f64; 3],
    /// Least coordinates of the part that counts \[L\]; left out, unbounded.
    pub min: Option<[f64; 3]>,
    /// Greatest coordinates of that part \[L\]; left out, unbounded.
    pub max: Option<[f64; 3]>,
}
