//! Waves in a scene: what a wall makes, and a beach on which they run out.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::scene::bounded::{Components, Peakedness, Positive};

/// Waves of small height, regular ones unless they have a spectrum, that a wall makes by its motion, as a piston or as a flap: its stroke follows from the period and the height by the transfer
/// function of the first order.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WallWaves {
    /// Height from trough to crest; of irregular waves the significant one, four times the standard deviation of the surface \[L\].
    pub height: Positive,
    /// Period; of irregular waves that of the peak of their spectrum \[T\].
    pub period: Positive,
    /// Depth of the water before the wall \[L\].
    pub depth: Positive,
    /// Horizontal direction in which they go; its length does not matter. Left out, along x.
    #[serde(default = "along_x")]
    pub along: [f64; 3],
    /// A point of the hinge of a flap, at the floor; left out, the wall goes to and fro as a piston \[L\].
    pub hinge: Option<[f64; 3]>,
    /// Time in which the motion grows to its size; left out, two periods \[T\].
    pub growth: Option<Positive>,
    /// Spectrum of irregular waves; left out, they are regular.
    pub spectrum: Option<WaveSpectrum>,
}

/// Irregular waves: the sum of so many of different frequencies, drawn with their phases from a seed, the same on every machine.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WaveSpectrum {
    /// How their energy is spread over frequencies.
    pub shape: SpectrumShape,
    /// Which waves of that spectrum; left out, 1.
    #[serde(default = "first")]
    pub seed: u32,
    /// Number of waves that are summed; left out, 64.
    pub components: Option<Components>,
}

/// Shapes of spectra, scaled to the significant height.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub enum SpectrumShape {
    /// That of Pierson and Moskowitz: a sea that the wind has raised to the full.
    PiersonMoskowitz,
    /// That of JONSWAP, a sea under way, by how much higher its peak is, 3.3 for many \[–\].
    Jonswap(Peakedness),
    /// Densities by frequency, `[frequency, density]`, straight lines between them, to any scale \[1/T, –\].
    Table(Vec<[f64; 2]>),
}

/// A zone of a fluid in which waves run out: its motion is damped, the more the farther in, so that a fiftieth of a wave comes back from a wall at its end.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Beach {
    /// A point at which it begins \[L\].
    pub from: [f64; 3],
    /// Direction in which waves go into it; its length does not matter. Left out, along x.
    #[serde(default = "along_x")]
    pub along: [f64; 3],
    /// Its length, that of a wave at least \[L\].
    pub length: Positive,
    /// Period of the waves \[T\].
    pub period: Positive,
    /// Depth of the water \[L\].
    pub depth: Positive,
}

impl WallWaves {
    /// Time in which the motion grows \[T\].
    pub(crate) fn growth(&self) -> f64 {
        self.growth.map_or(2.0 * self.period.get(), |growth| growth.get())
    }
}

fn first() -> u32 {
    1
}

fn along_x() -> [f64; 3] {
    [1.0, 0.0, 0.0]
}
