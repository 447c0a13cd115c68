//! How to find answers: by marching in time, along a load path or in real time, or without time.

use schemars::JsonSchema;
use serde::Deserialize;

use super::levels::Levels;
use super::statics::{ArcLength, Buckling, Linear, Modal, Static};

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
    /// Modes of free vibration of the unloaded shell.
    Modal(Modal),
    /// Buckling levels and modes, linearised about the unloaded shell.
    Buckling(Buckling),
}

/// Central differences; exactly one of the two tables is given.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Explicit {
    /// Fraction of the stable step \[–\].
    #[serde(default = "usual_safety")]
    pub safety: f64,
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
    /// … and when no more than this share of the answer is missing: force out of balance over load, way left over
    /// displacement \[–\].
    #[serde(default = "usual_accuracy")]
    pub accuracy: f64,
    /// Whether the negative pivots of the tangent are counted at settled levels; left out, where that costs less than 1 %
    /// of the run.
    pub stability: Option<bool>,
}

/// How a quasi-static run comes to rest.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub enum Damping {
    /// Mass-proportional, this fraction of critical for the lowest mode \[–\].
    Ratio(f64),
    /// Velocities are stopped whenever the kinetic energy passes a peak.
    Kinetic,
}

/// A run in real time.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
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

impl Analysis {
    /// Key of the analysis in a scene.
    pub fn word(&self) -> &'static str {
        match self {
            Self::Explicit(_) => "explicit",
            Self::Linear(_) => "linear",
            Self::Static(_) => "static",
            Self::ArcLength(_) => "arc-length",
            Self::Modal(_) => "modal",
            Self::Buckling(_) => "buckling",
        }
    }

    /// Whether time passes, as loads with a course in time want it.
    pub fn transient(&self) -> bool {
        matches!(self, Self::Explicit(explicit) if explicit.transient.is_some())
    }

    /// Whether answers are modes, not states: nothing is measured on them.
    pub fn gives_modes(&self) -> bool {
        matches!(self, Self::Modal(_) | Self::Buckling(_))
    }

    /// Whether shapes are those that the body takes, not enlarged for the eye.
    pub(crate) fn states_are_true_to_scale(&self) -> bool {
        matches!(self, Self::Explicit(_) | Self::Static(_) | Self::ArcLength(_))
    }

    /// What the run is called in messages.
    pub(crate) fn run_name(&self) -> &'static str {
        match self {
            Self::Explicit(explicit) if explicit.quasi_static.is_some() => "a quasi-static run",
            Self::Explicit(_) => "a transient run",
            Self::Linear(_) => "a linear analysis",
            Self::Static(_) => "a static analysis",
            Self::ArcLength(_) => "an arc-length analysis",
            Self::Modal(_) => "a modal analysis",
            Self::Buckling(_) => "a buckling analysis",
        }
    }

    /// Whether a load drives it without time: a prescribed motion then becomes a force that finds its size.
    pub(crate) fn driven_by_load(&self) -> bool {
        matches!(self, Self::Linear(_) | Self::Static(_) | Self::ArcLength(_) | Self::Buckling(_))
    }
}

impl Default for Damping {
    fn default() -> Self {
        Self::Ratio(1.0)
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

/// Half of the 1 % that an answer may be off: what the softness of a few modes at once hides is less than as much again.
fn usual_accuracy() -> f64 {
    5e-3
}
