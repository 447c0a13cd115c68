//! The analysis of steady random vibration: noise that shakes the supports or goes with the loads, and what damps.

use implicit_statics::PowerDensity;
use schemars::JsonSchema;
use serde::Deserialize;

use super::harmonic::{Frequencies, VibrationDamping};
use crate::scene::bounded::Modes;

/// Steady random vibration by modes of the unloaded or the preloaded body, under noise whose power by frequency is known: displacements and velocities with
/// respect to the base, accelerations with respect to space.
///
/// The curve has the density of each column by frequency. `summary.json` has its root mean square, over all frequencies of the noise, and how often it crosses
/// zero. What modes leave out of the load is one shape more.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RandomVibration {
    /// Number of modes, the lowest ones.
    pub modes: Modes,
    /// What damps the modes.
    pub damping: VibrationDamping,
    /// Frequencies of the curve, in cycles by time: a list, or `{ from = 20.0, to = 2000.0, points = 200, spacing = "logarithmic" }`, else linear \[1/T\].
    pub frequencies: Frequencies,
    /// Noise that accelerates all that holds the body, in directions that know nothing of each other.
    #[serde(default)]
    pub base: Vec<NoisyBase>,
    /// Noise with which all loads of the scene go, in step.
    pub loads: Option<NoisyLoads>,
}

/// Noise that accelerates all that holds the body in a direction.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct NoisyBase {
    /// Acceleration that the noise is times \[L/T²\]: `[0.0, 0.0, 9.81]` of a density in g² by frequency.
    pub acceleration: [f64; 3],
    /// One-sided power density of the noise, `[frequency, density]` \[1/T, T\]: straight between logarithms, nothing beyond its ends.
    pub density: Vec<[f64; 2]>,
}

/// Noise with which loads go.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct NoisyLoads {
    /// One-sided power density of the factor on the loads, `[frequency, density]` \[1/T, T\]: straight between logarithms, nothing beyond its ends.
    pub density: Vec<[f64; 2]>,
}

impl RandomVibration {
    /// Densities of all sources: those of the bases, then that of the loads.
    pub fn densities(&self) -> impl Iterator<Item = PowerDensity> {
        let bases = self.base.iter().map(|base| &base.density);
        let all = bases.chain(self.loads.iter().map(|loads| &loads.density));
        all.map(|points| PowerDensity { points: points.clone() })
    }
}
