//! The analysis by response spectra: how the ground shakes, what damps, how modes and directions are combined.

use explicit_dynamics::Amplitude;
use implicit_statics::{Combination, DirectionRule, ResponseSpectrum, SpectrumBy};
use schemars::JsonSchema;
use serde::Deserialize;

use super::harmonic::VibrationDamping;
use crate::scene::bounded::{DampingRatio, Modes};

/// Greatest answers to a ground that is known by its response spectra, by modes of the unloaded or the preloaded body: displacements and velocities with respect
/// to the ground, accelerations with respect to space, none with a sign.
///
/// What modes leave out of the mass follows the ground, as the stiff end of the spectrum says. A row of the curve has the answers to one base, and the last row
/// those to all.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SpectrumAnalysis {
    /// Number of modes, the lowest ones.
    pub modes: Modes,
    /// What damps the modes.
    pub damping: VibrationDamping,
    /// How greatest answers of modes are combined.
    #[serde(default)]
    pub combination: Combination,
    /// How answers to several bases are combined.
    #[serde(default)]
    pub directions: DirectionRule,
    /// Whether what modes leave out of the mass is added.
    #[serde(default = "yes")]
    pub missing_mass: bool,
    /// Directions in which all that holds the body is accelerated, each with its spectrum.
    pub base: Vec<SpectrumBase>,
}

/// A direction in which all that holds the body is accelerated.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SpectrumBase {
    /// Acceleration that the numbers of the spectrum are times \[L/T²\]: `[0.0, 0.0, 9.81]` of a spectrum in parts of g.
    pub acceleration: [f64; 3],
    /// What the first number of a point of the spectrum is: the `period` or the `frequency` of an oscillator, or the `time` of a course of the ground, whose own
    /// spectrum is found for each mode.
    pub by: SpectrumBy,
    /// Whether it goes along straight lines between logarithms, else between numbers.
    #[serde(default)]
    pub logarithmic: bool,
    /// The spectrum, for any damping: a `table`, or a `record` from a file. Beyond its ends it stays as it ends.
    pub amplitude: Option<Amplitude>,
    /// The spectra for several dampings, between which it goes with the logarithm of the damping.
    #[serde(default)]
    pub damped: Vec<DampedSpectrum>,
}

/// The spectrum of oscillators with a damping.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DampedSpectrum {
    /// Part of the critical damping \[–\].
    pub ratio: DampingRatio,
    /// The spectrum: a `table`, or a `record` from a file.
    pub amplitude: Amplitude,
}

impl SpectrumBase {
    /// Its curves by damping; that for any damping under one that does not count.
    pub fn curves(&self) -> impl Iterator<Item = (f64, &Amplitude)> {
        let one = self.amplitude.iter().map(|amplitude| (1.0, amplitude));
        one.chain(self.damped.iter().map(|own| (own.ratio.get(), &own.amplitude)))
    }

    /// The spectrum as it is solved with; accelerations are times that of the base.
    pub fn spectrum(&self) -> ResponseSpectrum {
        let points = |amplitude: &Amplitude| match amplitude {
            Amplitude::Table(points) => points.clone(),
            // The checks leave no other.
            _ => Vec::new(),
        };
        let curves = self.curves().map(|(damping, amplitude)| (damping, points(amplitude))).collect();
        ResponseSpectrum { by: self.by, logarithmic: self.logarithmic, curves }
    }
}

fn yes() -> bool {
    true
}
