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
    /// Particle set.
    pub on: String,
    /// What is taken of the values of its particles; left out, the mean, for a reaction the sum.
    pub take: Option<Take>,
    /// Component that is taken, in the un-turned frame.
    pub direction: [f64; 3],
    /// Factor on the value, such as 4 for the reaction of a quarter model.
    #[serde(default = "one")]
    pub factor: f64,
}

/// What a column takes of the values of its particles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Take {
    /// Their mean.
    Mean,
    /// Their sum.
    Sum,
    /// The largest.
    Max,
    /// The least.
    Min,
}

impl Probe {
    /// What it takes of the values of its particles.
    pub fn taken(&self) -> Take {
        self.take.unwrap_or_else(|| Take::usual(self.of))
    }
}

impl Take {
    /// What is taken where nothing is said: the sum of reactions, else the mean.
    pub fn usual(of: Measured) -> Self {
        if of == Measured::Reaction { Self::Sum } else { Self::Mean }
    }
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
