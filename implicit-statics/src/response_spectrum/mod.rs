//! Greatest answers of modes to a ground whose motion is known by its response spectrum.
//!
//! ```text
//! q_n = Γ_n S_a(ω_n, ζ_n)/ω_n²       Γ_n = φ_nᵀ M r       R = Σ over modes, by a rule
//! ```
//!
//! What modes leave out of the load follows the ground: it is the static answer to what is left of `M r`, times the acceleration of the ground, which is the
//! spectrum at its stiff end.

mod combination;
mod oscillator;

pub use combination::{Combination, DirectionRule, ModesTogether, correlation};
pub use oscillator::pseudo_acceleration;

use std::f64::consts::TAU;

/// Greatest pseudo-accelerations of damped oscillators, by their frequency or period and their damping.
#[derive(Clone, Debug, PartialEq)]
pub struct ResponseSpectrum {
    /// What the first number of a point is.
    pub by: SpectrumBy,
    /// Whether curves are straight between logarithms.
    pub logarithmic: bool,
    /// `(ζ, points)`, dampings ascending, points by ascending first number; one curve holds for any damping.
    pub curves: Vec<(f64, Vec<[f64; 2]>)>,
}

/// What the first number of a point of a spectrum is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(feature = "scene", derive(schemars::JsonSchema))]
pub enum SpectrumBy {
    /// A period \[T\].
    Period,
    /// A frequency, in cycles by time \[1/T\].
    Frequency,
    /// A time: the numbers are the course of the ground itself, whose own spectrum is found for each mode \[T\].
    Time,
}

/// A number of a spectrum, and where it was looked for beyond its ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpectralValue {
    /// The number.
    pub value: f64,
    /// Whether the oscillator is softer than any of the spectrum: its number is that at the soft end.
    pub softer: bool,
    /// Whether its damping is less or more than any of the spectrum: its number is that of the nearest.
    pub other_damping: bool,
}

impl ResponseSpectrum {
    /// The number of an oscillator of circular frequency ω \[1/T\] and damping ζ. Beyond the ends the number at the end stands; between dampings it goes
    /// with their logarithm.
    pub fn at(&self, omega: f64, zeta: f64) -> SpectralValue {
        let mut softer = false;
        let mut value = |(_, points): &(f64, Vec<[f64; 2]>)| match self.by {
            SpectrumBy::Time => pseudo_acceleration(points, omega, zeta),
            SpectrumBy::Period => {
                softer |= points.last().is_some_and(|last| TAU / omega > last[0]);
                self.between(points, TAU / omega)
            }
            SpectrumBy::Frequency => {
                softer |= points.first().is_some_and(|first| omega / TAU < first[0]);
                self.between(points, omega / TAU)
            }
        };
        let next = self.curves.partition_point(|(damping, _)| *damping < zeta);
        let (below, above) = (next.checked_sub(1).map(|i| &self.curves[i]), self.curves.get(next));
        let (found, other_damping) = match (below, above) {
            (Some(below), Some(above)) => {
                let share = libm::log(zeta / below.0) / libm::log(above.0 / below.0);
                ((1.0 - share) * value(below) + share * value(above), false)
            }
            (Some(only), None) => (value(only), self.curves.len() > 1),
            (None, Some(only)) => (value(only), self.curves.len() > 1 && only.0 > zeta),
            (None, None) => (0.0, false),
        };
        SpectralValue { value: found, softer, other_damping }
    }

    /// What it is at its stiff end, where an oscillator goes with the ground: the greatest acceleration of that.
    pub fn of_ground(&self) -> f64 {
        let end = |(_, points): &(f64, Vec<[f64; 2]>)| match self.by {
            SpectrumBy::Time => points.iter().fold(0.0_f64, |most, point| most.max(point[1].abs())),
            SpectrumBy::Period => points.first().map_or(0.0, |point| point[1]),
            SpectrumBy::Frequency => points.last().map_or(0.0, |point| point[1]),
        };
        self.curves.iter().map(end).fold(0.0, f64::max)
    }

    /// Whether it is one number, whatever the oscillator.
    pub fn is_flat(&self) -> bool {
        let ground = self.of_ground();
        let mut points = self.curves.iter().flat_map(|(_, points)| points);
        self.by != SpectrumBy::Time && points.all(|point| point[1] == ground)
    }

    fn between(&self, points: &[[f64; 2]], x: f64) -> f64 {
        let next = points.partition_point(|point| point[0] < x);
        let (Some([x1, y1]), Some([x0, y0])) =
            (points.get(next), next.checked_sub(1).and_then(|i| points.get(i)))
        else {
            return points.get(next).or(points.last()).map_or(0.0, |point| point[1]);
        };
        if self.logarithmic {
            let share = libm::log(x / x0) / libm::log(x1 / x0);
            return y0 * libm::exp(share * libm::log(y1 / y0));
        }
        y0 + (x - x0) / (x1 - x0) * (y1 - y0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Wilson, Der Kiureghian and Bayo's figures for 5 % in both: ρ = .273 at r = .9, .071 at .8 (from the closed form for equal dampings,
    /// `8 ζ² (1 + r) r^{3/2}/((1 − r²)² + 4 ζ² r (1 + r)²)`).
    #[test]
    fn modes_go_together_as_noise_lets_them() {
        let equal = |zeta: f64, r: f64| {
            8.0 * zeta * zeta * (1.0 + r) * libm::pow(r, 1.5)
                / ((1.0 - r * r).powi(2) + 4.0 * zeta * zeta * r * (1.0 + r).powi(2))
        };
        for r in [0.5, 0.8, 0.9, 0.99, 1.3] {
            let own = correlation([7.0, 0.05], [7.0 * r, 0.05]);
            assert!((own / equal(0.05, r) - 1.0).abs() < 1e-13, "{r} {own}");
            let back = correlation([7.0 * r, 0.02], [7.0, 0.07]);
            assert!((back / correlation([7.0, 0.07], [7.0 * r, 0.02]) - 1.0).abs() < 1e-13);
        }
        assert_eq!(correlation([2.0, 0.0], [2.0, 0.0]), 1.0);
        assert_eq!(correlation([2.0, 0.0], [3.0, 0.0]), 0.0);
    }

    #[test]
    fn rules_agree_where_they_must() {
        let modes = [[1.0, 0.05], [1.0, 0.05], [30.0, 0.05]];
        let of = |rule, peaks: [f64; 3]| ModesTogether::new(rule, &modes).of(&peaks, 0.0);
        // Two modes of one frequency are one: their sum counts, be it nothing.
        assert!((of(Combination::Cqc, [3.0, 1.0, 0.0]) - 4.0).abs() < 1e-14);
        assert!(of(Combination::Cqc, [3.0, -3.0, 0.0]) < 1e-7);
        assert!((of(Combination::Srss, [3.0, 4.0, 12.0]) - 13.0).abs() < 1e-14);
        assert_eq!(of(Combination::Absolute, [3.0, -4.0, 12.0]), 19.0);
        assert_eq!(DirectionRule::HundredThirty.of(&[1.0, 10.0, 2.0]), 10.0 + 0.3 * 3.0);
        assert_eq!(DirectionRule::Srss.of(&[3.0, 4.0]), 5.0);
        assert_eq!(DirectionRule::Absolute.of(&[3.0, 4.0]), 7.0);
        let rest = ModesTogether::new(Combination::Srss, &modes).of(&[3.0, 0.0, 0.0], 4.0);
        assert!((rest - 5.0).abs() < 1e-14);
    }

    /// A step of the acceleration: `|u| ω² = a (1 + exp(−πζ/√(1 − ζ²)))` at half of the damped period; after a short pulse `ω Δv`.
    #[test]
    fn an_oscillator_overshoots_a_step_as_its_closed_form_says() {
        for (omega, zeta) in [(3.0, 0.0), (3.0, 0.05), (40.0, 0.3), (0.2, 0.02)] {
            let record = [[0.0, 2.0], [100.0, 2.0]];
            let over = libm::exp(-std::f64::consts::PI * zeta / (1.0_f64 - zeta * zeta).sqrt());
            let found = pseudo_acceleration(&record, omega, zeta);
            assert!((found / (2.0 * (1.0 + over)) - 1.0).abs() < 1e-12, "{omega} {zeta} {found}");
        }
        for zeta in [1.0, 1.0 + 1e-9, 2.0] {
            let record = [[0.0, 2.0], [400.0, 2.0]];
            assert!((pseudo_acceleration(&record, 1.5, zeta) - 2.0).abs() < 1e-6, "{zeta}");
        }
        // Of a triangle of an area Δv, in a thousandth of a radian.
        let pulse = pseudo_acceleration(&[[0.0, 0.0], [0.0005, 2.0], [0.001, 0.0]], 1.0, 0.0);
        assert!((pulse / 0.001 - 1.0).abs() < 1e-6, "{pulse}");
    }

    #[test]
    fn curves_are_met_at_their_points_and_between() {
        let mut spectrum = ResponseSpectrum {
            by: SpectrumBy::Period,
            logarithmic: false,
            curves: vec![(0.02, vec![[0.1, 4.0], [0.5, 8.0]]), (0.08, vec![[0.1, 2.0], [0.5, 4.0]])],
        };
        let of = |spectrum: &ResponseSpectrum, period: f64, zeta| spectrum.at(TAU / period, zeta);
        assert!((of(&spectrum, 0.3, 0.02).value - 6.0).abs() < 1e-14);
        // Half of the way in the logarithm.
        assert!((of(&spectrum, 0.3, 0.04).value - 4.5).abs() < 1e-14);
        assert_eq!(
            of(&spectrum, 0.01, 0.08),
            SpectralValue { value: 2.0, softer: false, other_damping: false }
        );
        assert_eq!(of(&spectrum, 0.6, 0.1), SpectralValue { value: 4.0, softer: true, other_damping: true });
        assert!(of(&spectrum, 0.3, 0.01).other_damping);
        assert_eq!(spectrum.of_ground(), 4.0);
        spectrum.logarithmic = true;
        spectrum.curves.truncate(1);
        let middle = of(&spectrum, 0.05_f64.sqrt(), 0.5);
        assert!((middle.value - 32.0_f64.sqrt()).abs() < 1e-13 && !middle.other_damping);
        spectrum.by = SpectrumBy::Frequency;
        assert!((spectrum.at(TAU * 0.5, 0.02).value - 8.0).abs() < 1e-14);
        assert!(spectrum.at(TAU * 0.05, 0.02).softer && spectrum.of_ground() == 8.0);
    }
}
