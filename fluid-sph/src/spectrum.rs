//! Irregular waves: spectra of the sea, and the components of which a wall makes them.
//!
//! ```text
//! S(f) ∝ f⁻⁵ exp(−5/4 (f_p/f)⁴) γ^exp(−(f/f_p − 1)²/2σ²)      σ = .07 below the peak, .09 above; γ = 1: Pierson and Moskowitz
//! η(t) = Σ a_i cos(2πf_i t + φ_i)      a_i²/2 = S(f_i) Δf_i      ∫ S df = H_s²/16
//! ```
//!
//! \[hasselmann1973, pierson1964\] Frequencies are drawn within equal parts of the band and phases from a whole turn, from a seed by a generator of whole numbers, so that they are the same on every
//! machine; heights are scaled so that the sum of a_i²/2 is H_s²/16, whatever was drawn.

use explicit_dynamics::Amplitude;

use crate::waves::Waves;

/// Band of frequencies in those of the peak: 6·10⁻⁵ of the energy of Pierson's and Moskowitz's spectrum lie below it, and 1.5 % above.
const BAND: [f64; 2] = [0.6, 3.0];
/// Widths of the peak below and above it.
const WIDTHS: [f64; 2] = [0.07, 0.09];

/// How the energy of waves is spread over frequencies.
#[derive(Clone, Debug, PartialEq)]
pub enum Spectrum {
    /// Of a sea that the wind still raises, or that it has raised, γ = 1 \[hasselmann1973, pierson1964\].
    Jonswap {
        /// γ, how much higher its peak is than that of a sea raised to the full \[–\].
        peakedness: f64,
    },
    /// Densities at frequencies, straight between them and none beyond, to any scale \[1/T, –\].
    Table(Vec<[f64; 2]>),
}

/// One of the waves that make a sea.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Component {
    /// Amplitude \[L\].
    pub amplitude: f64,
    /// Frequency \[1/T\].
    pub frequency: f64,
    /// Phase \[rad\].
    pub phase: f64,
}

impl Spectrum {
    /// Density at a frequency, to any scale, of a peak at another \[1/T\].
    pub fn density(&self, frequency: f64, peak: f64) -> f64 {
        match self {
            Self::Jonswap { peakedness } => {
                let x = frequency / peak;
                let width = WIDTHS[usize::from(x > 1.0)];
                let (square, off) = (x * x, (x - 1.0) / width);
                let risen = libm::pow(*peakedness, libm::exp(-0.5 * off * off));
                libm::exp(-1.25 / (square * square)) / (square * square * x) * risen
            }
            Self::Table(points) => {
                let [low, high] = self.band(peak);
                if (low..=high).contains(&frequency) { Amplitude::along(points, frequency) } else { 0.0 }
            }
        }
    }

    /// The band of frequencies that it has, about a peak \[1/T\].
    pub fn band(&self, peak: f64) -> [f64; 2] {
        match self {
            Self::Jonswap { .. } => BAND.map(|part| part * peak),
            Self::Table(points) => [points.first(), points.last()].map(|end| end.map_or(peak, |end| end[0])),
        }
    }

    /// So many components of a sea of a significant height \[L\] and a frequency of the peak \[1/T\], drawn from a seed.
    pub fn components(&self, height: f64, peak: f64, count: usize, seed: u32) -> Vec<Component> {
        let [low, high] = self.band(peak);
        let width = (high - low) / count as f64;
        let mut random = Random(u64::from(seed));
        let mut all: Vec<Component> = (0..count)
            .map(|i| {
                let frequency = low + (i as f64 + random.next()) * width;
                let amplitude = (2.0 * self.density(frequency, peak) * width).sqrt();
                Component { amplitude, frequency, phase: std::f64::consts::TAU * random.next() }
            })
            .collect();
        let energy: f64 = all.iter().map(|own| 0.5 * own.amplitude * own.amplitude).sum();
        let factor = if energy > 0.0 { 0.25 * height / energy.sqrt() } else { 0.0 };
        all.iter_mut().for_each(|own| own.amplitude *= factor);
        all
    }
}

/// What a wall does of it, as a piston or as a flap: terms of its way at the surface, factor \[L\], angular frequency \[1/T\] and phase.
pub fn way_of_wall(components: &[Component], depth: f64, gravity: f64, flap: bool) -> Vec<[f64; 3]> {
    let term = |own: &Component| {
        let waves = Waves { period: 1.0 / own.frequency, depth, gravity };
        let over_way = if flap { waves.of_flap() } else { waves.of_piston() };
        [own.amplitude / over_way, std::f64::consts::TAU * own.frequency, own.phase]
    };
    components.iter().map(term).collect()
}

/// Numbers from zero to one, the same on every machine: SplitMix64 \[steele2014\].
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut x = self.0;
        x = (x ^ (x >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        x = (x ^ (x >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((x ^ (x >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A moment of a density by its frequency over a range, of 10⁵ parts.
    fn moment(spectrum: &Spectrum, order: i32, [low, high]: [f64; 2]) -> f64 {
        let width = (high - low) * 1e-5;
        let at = |i: i32| low + (f64::from(i) + 0.5) * width;
        (0..100_000).map(|i| spectrum.density(at(i), 1.0) * at(i).powi(order) * width).sum()
    }

    /// `∫ f⁻⁵ exp(−5/4 f⁻⁴) df` is 1/5; below .6 and above 3 of the peak lie 6·10⁻⁵ and 1.5 % of it.
    #[test]
    fn the_band_has_nearly_all_of_the_energy() {
        let spectrum = Spectrum::Jonswap { peakedness: 1.0 };
        let [below, within, above] =
            [[0.1, BAND[0]], BAND, [BAND[1], 100.0]].map(|part| moment(&spectrum, 0, part) / 0.2);
        assert!((below + within + above - 1.0).abs() < 1e-4, "{below} {within} {above}");
        assert!((below - 6e-5).abs() < 2e-5 && (above - 0.0153).abs() < 1e-4, "{below} {above}");
    }

    /// The sum has the height asked, whatever the seed, its second moment that of the density in the band: drawn frequencies move it by a part of a cell, measured 1 %.
    #[test]
    fn components_have_the_height_and_the_moments_of_their_spectrum() {
        for peakedness in [1.0, 3.3] {
            let spectrum = Spectrum::Jonswap { peakedness };
            let all = spectrum.components(0.06, 0.8, 200, 3);
            let of = |order: i32| {
                all.iter()
                    .map(|own| 0.5 * own.amplitude * own.amplitude * own.frequency.powi(order))
                    .sum::<f64>()
            };
            assert!((4.0 * of(0).sqrt() / 0.06 - 1.0).abs() < 1e-12);
            let exact = (moment(&spectrum, 2, BAND) / moment(&spectrum, 0, BAND)).sqrt();
            let crossing = (of(2) / of(0)).sqrt() / 0.8;
            assert!((crossing / exact - 1.0).abs() < 0.03, "{crossing} {exact}");
            assert_ne!(all, spectrum.components(0.06, 0.8, 200, 4));
            assert_eq!(all, spectrum.components(0.06, 0.8, 200, 3));
        }
    }

    #[test]
    fn a_table_is_straight_between_its_points() {
        let table = Spectrum::Table(vec![[0.5, 0.0], [1.0, 2.0], [2.0, 0.0]]);
        assert_eq!([0.25, 0.75, 1.0, 1.5, 3.0].map(|f| table.density(f, 1.0)), [0.0, 1.0, 2.0, 1.0, 0.0]);
        let all = table.components(0.04, 1.0, 50, 1);
        assert!(all.iter().all(|own| (0.5..=2.0).contains(&own.frequency)));
    }
}
