//! Damping: proportional to mass, or kinetic (stop where the kinetic energy peaks).

use serde::{Deserialize, Serialize};

/// How a quasi-static run comes to rest.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
#[cfg_attr(feature = "scene", derive(schemars::JsonSchema))]
pub enum Damping {
    /// Mass-proportional, this fraction ζ of critical for the lowest mode, whose period the march is given: `c = 4πζ/T₁` \[–\].
    Ratio(f64),
    /// Velocities are stopped whenever the kinetic energy passes a peak.
    Kinetic,
}

impl Damping {
    /// The mass-proportional coefficient c \[1/T\].
    pub fn coefficient(&self, period: f64) -> f64 {
        match self {
            Self::Ratio(zeta) => 2.0 * zeta * std::f64::consts::TAU / period,
            Self::Kinetic => 0.0,
        }
    }
}

/// Finds the peaks of the kinetic energy.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct KineticDamping {
    last: f64,
    /// The highest peak since the last reset: what the stop criterion takes \[F L\].
    pub peak: f64,
}

impl KineticDamping {
    /// Takes the kinetic energy of a step; true where it has just begun to fall.
    pub fn peaked(&mut self, kinetic: f64) -> bool {
        if kinetic < self.last {
            self.peak = self.last;
            self.last = 0.0;
            true
        } else {
            self.last = kinetic;
            false
        }
    }
}
