//! Columns of the curve: what is measured on which particles.

use schemars::JsonSchema;
use serde::Deserialize;

/// One column of the curve.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Probe {
    /// Name of the column.
    pub name: String,
    /// What it measures.
    pub of: Measured,
    /// Particle set; the mean over it, for a reaction the sum.
    pub on: String,
    /// Component that is taken, in the un-turned frame.
    pub direction: [f64; 3],
    /// Factor on the value, such as 4 for the reaction of a quarter model.
    #[serde(default = "one")]
    pub factor: f64,
}

/// What a column measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Measured {
    /// Component of the displacement \[L\].
    Displacement,
    /// Component of the position \[L\].
    Position,
    /// Component of the force that the supports exert \[F\].
    Reaction,
    /// Angle by which the director has turned about the direction, counted on beyond π \[rad\].
    Rotation,
    /// Component of the director \[–\].
    Director,
}

fn one() -> f64 {
    1.0
}
