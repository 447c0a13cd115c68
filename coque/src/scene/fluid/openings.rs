//! Openings of a fluid: where it comes in and goes out.

use explicit_dynamics::Amplitude;
use schemars::JsonSchema;
use serde::Deserialize;

/// A side of a fluid by which it comes in or goes out: with `velocity` that is given, the pressure comes from the fluid; with `level` or `pressure`, the velocity does;
/// with none of them what gets there goes out. It is as wide as the fluid that stands at it at the start, and walls go on four to five spacings beyond it.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FluidOpening {
    /// A point of it, at a face of the fluid \[L\].
    pub at: [f64; 3],
    /// Direction into the fluid, along an axis; its length does not matter.
    pub into: [f64; 3],
    /// Velocity of the water across it, positive into the fluid \[L/T\].
    pub velocity: Option<f64>,
    /// Course of the velocity in time; left out, constant.
    #[serde(default)]
    pub amplitude: Amplitude,
    /// Factors of the velocity at heights, `[height, factor]`, straight lines between them; left out, one \[L, –\].
    pub profile: Option<Vec<[f64; 2]>>,
    /// Height of the level along gravity: with a velocity that up to which water comes in, left out as far as the water beside stands; without one that of the water
    /// outside, whose pressure at rest is given \[L\].
    pub level: Option<f64>,
    /// Pressure outside, of a fluid without gravity \[F/L²\].
    pub pressure: Option<f64>,
}
