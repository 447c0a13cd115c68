//! A zone of a fluid that carries the water along.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::scene::bounded::Positive;

/// A zone that draws the water in it to a velocity, as the pump of a flume does: of what water differs from it on its way in, a fiftieth is left on its way out, waves
/// among it. With `periodic` sides that the water goes through again and again it makes a steady flow.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Current {
    /// A point at which it begins \[L\].
    pub from: [f64; 3],
    /// Direction of the velocity; its length does not matter. Left out, along x.
    #[serde(default = "along_x")]
    pub along: [f64; 3],
    /// Its length, twice the reach of the kernel at least \[L\].
    pub length: Positive,
    /// Velocity of the water along it, at all depths \[L/T\].
    pub velocity: Positive,
}

fn along_x() -> [f64; 3] {
    [1.0, 0.0, 0.0]
}
