//! Rubber, as a scene says it.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::scene::bounded::{NotNegative, Positive};

/// Incompressible hyperelastic material.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Rubber {
    /// Mass per volume \[F T²/L⁴\].
    pub density: Positive,
    /// Stored energy.
    pub law: RubberLaw,
}

/// Stored energy of rubber, of principal stretches λ1, λ2 in the surface and λ3 = 1/(λ1λ2).
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub enum RubberLaw {
    /// `c1 (λ1² + λ2² + λ3² − 3)`.
    NeoHooke(NeoHooke),
    /// The same and `c2 (λ1⁻² + λ2⁻² + λ3⁻² − 3)`.
    MooneyRivlin(MooneyRivlin),
    /// Rows of μ \[F/L²\] and α \[–\]: `Σ μ/α (λ1^α + λ2^α + λ3^α − 3)`.
    Ogden(Vec<[f64; 2]>),
}

/// Neo-Hooke's law.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct NeoHooke {
    /// Half the shear modulus \[F/L²\].
    pub c1: Positive,
}

/// Mooney and Rivlin's law.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MooneyRivlin {
    /// Of the first invariant \[F/L²\].
    pub c1: Positive,
    /// Of the second \[F/L²\].
    pub c2: NotNegative,
}

impl RubberLaw {
    /// Word of the scene.
    pub(crate) fn word(&self) -> &'static str {
        match self {
            Self::NeoHooke(_) => "neo-hooke",
            Self::MooneyRivlin(_) => "mooney-rivlin",
            Self::Ogden(_) => "ogden",
        }
    }
}
