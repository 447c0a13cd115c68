//! How to find answers: by marching in time, along a load path or in real time, or without time.

use explicit_dynamics::Amplitude;
pub use explicit_dynamics::Damping;
use schemars::JsonSchema;
use serde::Deserialize;

use super::harmonic::{BaseResponse, Harmonic};
use super::levels::Levels;
use super::random_vibration::RandomVibration;
use super::response_spectrum::SpectrumAnalysis;
use super::statics::{ArcLength, Buckling, Heat, Linear, Modal, Relaxation, Static};
use crate::scene::bounded::{Missing, NotNegative, Positive, Rest, Safety};

/// How to find answers; exactly one of the tables is given.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub enum Analysis {
    /// Marching in time by central differences.
    Explicit(Explicit),
    /// The linear answer to the loads.
    Linear(Linear),
    /// Equilibria at load levels, by Newton's method.
    Static(Static),
    /// A path of equilibria past limit and turning points, by arc length.
    ArcLength(ArcLength),
    /// Equilibria at load levels, by dynamic relaxation.
    Relaxation(Relaxation),
    /// Modes of free vibration of the unloaded or the preloaded shell.
    Modal(Modal),
    /// Steady vibration under loads that go as cos ωt.
    Harmonic(Harmonic),
    /// Greatest answers to a ground that is known by its response spectra.
    ResponseSpectrum(SpectrumAnalysis),
    /// Steady vibration under noise.
    RandomVibration(RandomVibration),
    /// Buckling levels and modes, linearised about the unloaded or the preloaded shell.
    Buckling(Buckling),
    /// Temperatures of a shell that conducts heat, in balance or in time.
    Heat(Heat),
}

/// Central differences; exactly one of the two tables is given.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Explicit {
    /// Fraction of the stable step \[–\].
    #[serde(default = "usual_safety")]
    pub safety: Safety,
    /// Equilibria along a load path, by damped marching: ramp, then hold until the motion has died.
    pub quasi_static: Option<QuasiStatic>,
    /// Motion in real time.
    pub transient: Option<Transient>,
}

/// Equilibria along a load path: a smooth ramp to each level, then a hold until the motion has died.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct QuasiStatic {
    /// Load levels to stop at.
    pub levels: Levels,
    /// Period of the lowest mode that the loads excite \[T\]; left out, it is found on the way.
    pub period: Option<Positive>,
    /// Ramp to each level, in periods.
    #[serde(default = "usual_ramp")]
    pub ramp: Positive,
    /// Longest hold, in periods.
    #[serde(default = "usual_hold")]
    pub hold: Positive,
    /// How the motion dies.
    #[serde(default = "critical")]
    pub damping: Damping,
    /// The motion has died when kinetic over internal energy falls below this \[–\].
    #[serde(default = "usual_tolerance")]
    pub tolerance: Rest,
    /// … and when no more than this share of the answer is missing: force out of balance over load, remaining displacement over
    /// displacement \[–\].
    #[serde(default = "usual_accuracy")]
    pub accuracy: Missing,
    /// Whether the negative pivots of the tangent are counted at settled levels; left out, where that costs less than 1 %
    /// of the run or a tenth of a second.
    pub stability: Option<bool>,
}

/// A run in real time.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Transient {
    /// Length of the run \[T\].
    pub duration: Positive,
    /// Time between rows of the curve \[T\].
    pub record_every: Positive,
    /// Mass-proportional damping \[1/T\].
    #[serde(default)]
    pub damping: NotNegative,
    /// Shakes all that holds the bodies.
    pub base: Option<MovingBase>,
}

/// An acceleration of all that holds the bodies in time: supports, springs to the ground, prescribed motions and tools go along. In axes that go along
/// too it is the load −a on all mass.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MovingBase {
    /// Acceleration where its course is one \[L/T²\].
    pub acceleration: [f64; 3],
    /// Its course in time, such as a record of an earthquake; it starts from rest.
    pub amplitude: Amplitude,
    /// Of what columns of displacement, position and velocity are.
    #[serde(default)]
    pub response: BaseResponse,
}

fn critical() -> Damping {
    Damping::Ratio(1.0)
}

/// The stable step is an estimate from below 1 % sharp; membrane stiffening takes the rest.
fn usual_safety() -> Safety {
    Safety::usual(0.8)
}

fn usual_ramp() -> Positive {
    Positive::usual(1.0)
}

/// Long enough for the slow modes near a limit point.
fn usual_hold() -> Positive {
    Positive::usual(8.0)
}

fn usual_tolerance() -> Rest {
    Rest::usual(1e-8)
}

/// Half of the 1 % that an answer may be off: what the softness of a few modes at once hides is less than as much again.
fn usual_accuracy() -> Missing {
    Missing::usual(5e-3)
}
