//! A material that yields, as a scene says it.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::scene::bounded::{Exponent, NotNegative, Positive};

/// Isotropic elasticity that yields by von Mises' criterion, or Hill's, and flows along its normal.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Plastic {
    /// Young's modulus \[F/L²\].
    pub young: Positive,
    /// Poisson's ratio \[–\].
    pub poisson: f64,
    /// Mass per volume \[F T²/L⁴\].
    pub density: Positive,
    /// How the yield stress grows with the equivalent plastic strain.
    pub hardening: Hardening,
    /// Modulus of linear kinematic hardening, by which the back stress grows a plastic strain in uniaxial tension \[F/L²\]; none without.
    #[serde(default)]
    pub kinematic: NotNegative,
    /// Back stresses that recover, of a shell, three at most (Armstrong and Frederick, Chaboche); none without.
    #[serde(default)]
    pub back_stresses: Vec<BackStress>,
    /// How the yield stress grows with the rate of plastic strain, of a shell in real time; not at all without.
    pub rate: Option<Rate>,
    /// Hill's criterion of a rolled sheet in place of von Mises', of a shell.
    pub anisotropy: Option<Anisotropy>,
}

/// A back stress X that recovers: in uniaxial tension `dX = modulus dε − recovery X dα`, so that it nears modulus/recovery.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BackStress {
    /// By how much it grows a plastic strain at first \[F/L²\].
    pub modulus: Positive,
    /// How fast it recovers, by a unit of plastic strain \[–\].
    pub recovery: Positive,
}

/// The yield stress over that of slow flow, `1 + s`, at the rate ε̇ of equivalent plastic strain.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub enum Rate {
    /// `s = (ε̇/reference)^(1/exponent)`.
    CowperSymonds(CowperSymonds),
    /// `s = factor ln(ε̇/reference)` beyond the reference, without heat.
    JohnsonCook(JohnsonCook),
}

/// Cowper and Symonds' law.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CowperSymonds {
    /// Rate at which the yield stress is twice that of slow flow \[1/T\]: 40/s is usual of mild steel, 6500/s of aluminium.
    pub reference: Positive,
    /// Exponent, one at least \[–\]: 5 is usual of mild steel, 4 of aluminium.
    pub exponent: Positive,
}

/// Johnson and Cook's factor of the rate.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JohnsonCook {
    /// Rate up to which nothing changes \[1/T\].
    pub reference: Positive,
    /// Overstress by e times the rate \[–\].
    pub factor: Positive,
}

/// Strains of bars cut from a rolled sheet: that across its width over that through its thickness.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Anisotropy {
    /// Rolling direction, whose projection on the surface counts, in the un-turned frame.
    pub axis: [f64; 3],
    /// Of a bar along it \[–\].
    pub r0: Positive,
    /// Of one at 45° \[–\].
    pub r45: Positive,
    /// Of one across \[–\].
    pub r90: Positive,
}

/// The yield stress K as a function of the equivalent plastic strain α.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub enum Hardening {
    /// `K = yield-stress + slope α`.
    Linear(Linear),
    /// `K = yield-stress + rise (1 − e^(−rate α))`, Voce's saturation.
    Voce(Voce),
    /// `K = factor (offset + α)^exponent`, Swift's power law.
    Swift(Swift),
    /// Rows of equivalent plastic strain and yield stress, joined by lines: `[[0, 248], [0.1, 320]]`. The last slope is kept.
    Table(Vec<[f64; 2]>),
}

/// Linear hardening.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Linear {
    /// Yield stress where nothing has flowed \[F/L²\].
    pub yield_stress: Positive,
    /// Slope \[F/L²\]; zero, perfect plasticity, without.
    #[serde(default)]
    pub slope: NotNegative,
}

/// Voce's hardening.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Voce {
    /// Yield stress where nothing has flowed \[F/L²\].
    pub yield_stress: Positive,
    /// By how much it rises in all \[F/L²\].
    pub rise: NotNegative,
    /// How fast, by a unit of plastic strain \[–\].
    pub rate: Positive,
}

/// Swift's hardening.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Swift {
    /// Yield stress at `offset + α = 1` \[F/L²\].
    pub factor: Positive,
    /// Strain from which the power counts \[–\].
    pub offset: Positive,
    /// Exponent \[–\].
    pub exponent: Exponent,
}

impl Hardening {
    /// Word of the scene.
    pub(crate) fn word(&self) -> &'static str {
        match self {
            Self::Linear(_) => "linear",
            Self::Voce(_) => "voce",
            Self::Swift(_) => "swift",
            Self::Table(_) => "table",
        }
    }
}
