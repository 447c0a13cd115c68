//! How to march: safety of the step, and either equilibria along a load path or a run in real time.

use serde::Deserialize;
use serde::de::value::SeqAccessDeserializer;
use serde::de::{Deserializer, SeqAccess, Visitor};

/// How to march.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub enum Analysis {
    /// Central differences.
    Explicit(Explicit),
}

/// Central differences; exactly one of the two tables is given.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Explicit {
    /// Fraction of the stable step \[–\].
    #[serde(default = "usual_safety")]
    pub safety: f64,
    /// Equilibria along a load path.
    pub quasi_static: Option<QuasiStatic>,
    /// Real time.
    pub transient: Option<Transient>,
}

/// Equilibria along a load path: a smooth ramp to each level, then a hold until the motion has died.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct QuasiStatic {
    /// Load levels to stop at.
    pub levels: Levels,
    /// Period of the lowest mode \[T\].
    pub period: f64,
    /// Ramp to each level, in periods.
    #[serde(default = "usual_ramp")]
    pub ramp: f64,
    /// Longest hold, in periods.
    #[serde(default = "usual_hold")]
    pub hold: f64,
    /// How the motion dies.
    #[serde(default)]
    pub damping: Damping,
    /// The motion has died when kinetic over internal energy falls below this \[–\].
    #[serde(default = "usual_tolerance")]
    pub tolerance: f64,
}

/// Load levels.
#[derive(Clone, Debug, PartialEq)]
pub enum Levels {
    /// This many equal steps up to one.
    Equal(u64),
    /// These levels, in order.
    List(Vec<f64>),
}

/// How a quasi-static run comes to rest.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub enum Damping {
    /// Mass-proportional, this fraction of critical for the lowest mode \[–\].
    Ratio(f64),
    /// Velocities are stopped whenever the kinetic energy passes a peak.
    Kinetic,
}

/// A run in real time.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Transient {
    /// Length of the run \[T\].
    pub duration: f64,
    /// Time between rows of the curve \[T\].
    pub record_every: f64,
    /// Mass-proportional damping \[1/T\].
    #[serde(default)]
    pub damping: f64,
}

impl Default for Damping {
    fn default() -> Self {
        Self::Ratio(1.0)
    }
}

impl Levels {
    /// The levels, written out.
    pub fn list(&self) -> Vec<f64> {
        match self {
            Self::Equal(count) => (1..=*count).map(|i| i as f64 / *count as f64).collect(),
            Self::List(levels) => levels.clone(),
        }
    }
}

/// The stable step is an estimate from below 1 % sharp; membrane stiffening takes the rest.
fn usual_safety() -> f64 {
    0.8
}

fn usual_ramp() -> f64 {
    1.0
}

/// Long enough for the slow modes near a limit point.
fn usual_hold() -> f64 {
    8.0
}

fn usual_tolerance() -> f64 {
    1e-8
}

impl<'de> Deserialize<'de> for Levels {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct CountOrList;
        impl<'de> Visitor<'de> for CountOrList {
            type Value = Levels;

            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("a number of equal levels, or a list such as [0.25, 0.5, 1.0]")
            }

            fn visit_i64<E: serde::de::Error>(self, count: i64) -> Result<Levels, E> {
                u64::try_from(count).map(Levels::Equal).map_err(|_| {
                    E::invalid_value(serde::de::Unexpected::Signed(count), &"a positive number of levels")
                })
            }

            fn visit_seq<A: SeqAccess<'de>>(self, seq: A) -> Result<Levels, A::Error> {
                Deserialize::deserialize(SeqAccessDeserializer::new(seq)).map(Levels::List)
            }
        }
        deserializer.deserialize_any(CountOrList)
    }
}
