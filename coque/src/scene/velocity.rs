//! Velocities with which a body sets out.

use schemars::JsonSchema;
use serde::Deserialize;

/// Velocity at the start of a transient run: `linear`, `spin` or both. What supports hold stays at rest.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Velocity {
    /// Particle set of a shell, by its name within the shell; left out, all of the body. The rest is at rest.
    pub on: Option<String>,
    /// Velocity of the particles \[L/T\].
    pub linear: Option<[f64; 3]>,
    /// Rotation, added to it.
    pub spin: Option<Spin>,
}

/// Rotation about an axis through a point: particles have the velocity ω × (x − point), directors turn with it.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Spin {
    /// Axis; its length does not matter.
    pub axis: [f64; 3],
    /// A point of the axis \[L\].
    #[serde(default)]
    pub point: [f64; 3],
    /// Angle in radians a time, right-handed about the axis \[1/T\].
    pub rate: f64,
}
