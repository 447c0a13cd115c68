//! The analysis of steady vibration: frequencies, damping, what shakes the supports.

use implicit_statics::HarmonicDamping;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Deserialize;
use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{Deserializer, MapAccess, SeqAccess, Visitor};

use crate::scene::bounded::{DampingRatio, LossFactor, Modes, NotNegative, Points, Positive};
use crate::scene::combination::Combination;

/// Steady vibration under loads that go as cos ωt, all in phase, about the unloaded or the preloaded shell; `moved` supports without `preload` are none of it.
///
/// Each column has its amplitude and, as `NAME_phase`, the angle by which it is ahead of the loads, from −π to π.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Harmonic {
    /// Frequencies, in cycles by time: a list, or `{ from = 1.0, to = 100.0, points = 200, spacing = "logarithmic" }`, else linear \[1/T\].
    pub frequencies: Frequencies,
    /// Number of modes, the lowest ones, in which it is found, with what they leave out as one shape more; left out, each frequency takes a factor
    /// of its own.
    pub modes: Option<Modes>,
    /// What takes energy out; left out, nothing.
    pub damping: Option<VibrationDamping>,
    /// Shakes all that holds the body.
    pub base: Option<ShakenBase>,
    /// Combinations of load cases, an answer each after those of the cases.
    #[serde(default)]
    pub combinations: Vec<Combination>,
}

/// What takes energy out of a steady vibration: exactly one of these.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub enum VibrationDamping {
    /// Part of the critical damping, the same in each mode; beside `modes` alone \[–\].
    Ratio(DampingRatio),
    /// By mass and by stiffness, C = αM + βK.
    Rayleigh(RayleighDamping),
    /// Loss factor η of K (1 + iη): 2πη times the greatest stored energy is lost in a cycle \[–\].
    Structural(LossFactor),
}

/// `C = αM + βK`.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RayleighDamping {
    /// α \[1/T\].
    #[serde(default)]
    pub mass: NotNegative,
    /// β \[T\].
    #[serde(default)]
    pub stiffness: NotNegative,
}

/// An acceleration of all that holds the body, `a cos ωt` in one direction: the load −a on its mass in axes that go along.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ShakenBase {
    /// Acceleration \[L/T²\].
    pub acceleration: [f64; 3],
    /// Of what columns of displacement and velocity are.
    #[serde(default)]
    pub response: BaseResponse,
}

/// To what a displacement refers while the base is shaken.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum BaseResponse {
    /// To the base, as it moves.
    #[default]
    Relative,
    /// To space: what the base moves by is added, −a/ω² in a harmonic analysis, the integral of its acceleration from rest in time.
    Absolute,
}

/// Frequencies.
#[derive(Clone, Debug, PartialEq)]
pub enum Frequencies {
    /// So many between two, both included.
    Range(FrequencyRange),
    /// These, in order.
    List(Vec<f64>),
}

/// So many frequencies between two, both included.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FrequencyRange {
    /// The first \[1/T\].
    pub from: Positive,
    /// The last \[1/T\].
    pub to: Positive,
    /// How many.
    pub points: Points,
    /// How they follow each other.
    #[serde(default)]
    pub spacing: FrequencySpacing,
}

/// How frequencies follow each other.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum FrequencySpacing {
    /// By equal differences.
    #[default]
    Linear,
    /// By equal ratios.
    Logarithmic,
}

impl Frequencies {
    /// The frequencies, written out \[1/T\].
    pub fn list(&self) -> Vec<f64> {
        let FrequencyRange { from, to, points, spacing } = match self {
            Self::List(list) => return list.clone(),
            Self::Range(range) => *range,
        };
        let ([from, to], last) = ([from.get(), to.get()], points.get() - 1);
        let between = |share: f64| match spacing {
            FrequencySpacing::Linear => from + share * (to - from),
            FrequencySpacing::Logarithmic => from * libm::exp(share * libm::log(to / from)),
        };
        let one = |i: usize| if i == last { to } else { between(i as f64 / last as f64) };
        (0..=last).map(one).collect()
    }
}

impl Harmonic {
    /// The damping, as it is solved with.
    pub fn damped(&self) -> HarmonicDamping {
        self.damping.map_or(HarmonicDamping::None, VibrationDamping::damped)
    }
}

impl VibrationDamping {
    /// The same, as it is solved with.
    pub fn damped(self) -> HarmonicDamping {
        match self {
            Self::Ratio(ratio) => HarmonicDamping::Ratio(ratio.get()),
            Self::Structural(loss) => HarmonicDamping::Structural(loss.get()),
            Self::Rayleigh(RayleighDamping { mass, stiffness }) => {
                HarmonicDamping::Rayleigh { mass: mass.get(), stiffness: stiffness.get() }
            }
        }
    }
}

impl<'de> Deserialize<'de> for Frequencies {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct RangeOrList;
        impl<'de> Visitor<'de> for RangeOrList {
            type Value = Frequencies;

            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str(
                    "a range such as { from = 1.0, to = 100.0, points = 200 }, or a list of frequencies",
                )
            }

            fn visit_seq<A: SeqAccess<'de>>(self, seq: A) -> Result<Frequencies, A::Error> {
                Deserialize::deserialize(SeqAccessDeserializer::new(seq)).map(Frequencies::List)
            }

            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Frequencies, A::Error> {
                Deserialize::deserialize(MapAccessDeserializer::new(map)).map(Frequencies::Range)
            }
        }
        deserializer.deserialize_any(RangeOrList)
    }
}

impl JsonSchema for Frequencies {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Frequencies".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let range = generator.subschema_for::<FrequencyRange>();
        json_schema!({
            "description": "Frequencies: so many between two, or these, in order.",
            "oneOf": [
                range,
                { "type": "array", "items": { "type": "number", "exclusiveMinimum": 0.0 }, "minItems": 1 }
            ]
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_begin_and_end_exactly() {
        let range = |spacing| FrequencyRange {
            from: Positive::usual(2.0),
            to: Positive::usual(32.0),
            points: Points::usual(5),
            spacing,
        };
        let of = |spacing| Frequencies::Range(range(spacing)).list();
        assert_eq!(of(FrequencySpacing::Linear), [2.0, 9.5, 17.0, 24.5, 32.0]);
        let list = of(FrequencySpacing::Logarithmic);
        let near =
            list.iter().zip([2.0, 4.0, 8.0, 16.0, 32.0]).all(|(x, exact)| (x / exact - 1.0).abs() < 1e-15);
        assert!(near && list[4] == 32.0, "{list:?}");
    }
}
