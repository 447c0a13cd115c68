//! How a load varies in time.

use serde::{Deserialize, Serialize};

/// Variation of a load in time.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
#[cfg_attr(feature = "scene", derive(schemars::JsonSchema))]
pub enum Amplitude {
    /// One throughout.
    #[default]
    Constant,
    /// Linear from zero to one over this time, one after \[T\].
    Ramp(f64),
    /// Quintic from zero to one over this time, without velocity and acceleration at its ends, `s³(10 − 15s + 6s²)` \[T\].
    Smooth(f64),
    /// Straight lines between `[time, factor]`, times ascending; constant before and after.
    Table(Vec<[f64; 2]>),
    /// Sine of time, `sin(2πt/T)`.
    Sine {
        /// Period \[T\].
        period: f64,
        /// Time in which it grows to its size, by the factor of `smooth`; left out, none \[T\].
        #[serde(default, skip_serializing_if = "Option::is_none")]
        growth: Option<f64>,
    },
}

impl Amplitude {
    /// The number at a place on straight lines between `[place, number]`, places ascending; beyond them that of the end, of no points one.
    pub fn along(points: &[[f64; 2]], at: f64) -> f64 {
        table(points, at)
    }

    /// Times at which it turns a corner or ends to change \[T\].
    pub fn corners(&self) -> Vec<f64> {
        match self {
            Self::Constant => Vec::new(),
            Self::Ramp(duration) | Self::Smooth(duration) => vec![*duration],
            Self::Table(points) => points.iter().map(|[time, _]| *time).collect(),
            Self::Sine { growth, .. } => growth.iter().copied().collect(),
        }
    }

    /// The factor at a time \[T\].
    pub fn value(&self, time: f64) -> f64 {
        match self {
            Self::Constant => 1.0,
            Self::Ramp(duration) => (time / duration).clamp(0.0, 1.0),
            Self::Smooth(duration) => smooth(time / duration),
            Self::Sine { period, growth } => {
                let sine = libm::sin(std::f64::consts::TAU * time / period);
                growth.map_or(sine, |growth| sine * smooth(time / growth))
            }
            Self::Table(points) => table(points, time),
        }
    }
}

impl Amplitude {
    /// Its integral from zero to a time, and the integral of that: `[∫a dt, ∬a dt²]` \[T, T²\], exact but for rounding.
    pub fn integrals(&self, time: f64) -> [f64; 2] {
        let t = time;
        match self {
            Self::Constant => [t, 0.5 * t * t],
            Self::Ramp(duration) => {
                let (up, after) = (t.min(*duration), (t - duration).max(0.0));
                let [v, u] = [0.5 * up * up / duration, up * up * up / (6.0 * duration)];
                [v + after, u + after * (v + 0.5 * after)]
            }
            Self::Smooth(duration) => {
                let (s, after) = ((t / duration).min(1.0), (t - duration).max(0.0));
                let v = duration * s * s * s * s * (2.5 + s * (s - 3.0));
                let u = duration * duration * s * s * s * s * s * (0.5 + s * (s / 7.0 - 0.5));
                [v + after, u + after * (v + 0.5 * after)]
            }
            Self::Sine { period, growth: None } => {
                let omega = std::f64::consts::TAU / period;
                let half = libm::sin(0.5 * omega * t);
                [2.0 * half * half / omega, (t - libm::sin(omega * t) / omega) / omega]
            }
            Self::Sine { period, growth: Some(growth) } => {
                let (end, omega) = (t.min(*growth), std::f64::consts::TAU / period);
                let [v, u] = self.growing(end, end / period);
                let (after, [s0, c0], s1) =
                    (t - end, [libm::sin(omega * end), libm::cos(omega * end)], libm::sin(omega * t));
                let whole = (c0 - libm::cos(omega * t)) / omega;
                [v + whole, u + after * (v + c0 / omega) - (s1 - s0) / (omega * omega)]
            }
            Self::Table(points) => {
                let (mut from, mut a0, mut sums) = (0.0, table(points, 0.0), [0.0; 2]);
                let mut go_to = |to: f64, a1: f64| {
                    let h = to - from;
                    sums =
                        [sums[0] + 0.5 * h * (a0 + a1), sums[1] + h * (sums[0] + h * (2.0 * a0 + a1) / 6.0)];
                    (from, a0) = (to, a1);
                };
                let after_start = points.iter().skip_while(|point| point[0] <= 0.0);
                after_start.take_while(|point| point[0] < t).for_each(|&[at, x]| go_to(at, x));
                go_to(t, table(points, t));
                sums
            }
        }
    }
}

/// Abscissae on (−1, 1) and weights of Gauss and Legendre, exact to the ninth degree.
const GAUSS: [[f64; 2]; 5] = [
    [-0.906_179_845_938_664, 0.236_926_885_056_189_1],
    [-0.538_469_310_105_683_1, 0.478_628_670_499_366_47],
    [0.0, 0.568_888_888_888_888_9],
    [0.538_469_310_105_683_1, 0.478_628_670_499_366_47],
    [0.906_179_845_938_664, 0.236_926_885_056_189_1],
];

impl Amplitude {
    /// The integrals to a time at which it still grows, so many periods from its start: by pieces so short that nothing but rounding is left.
    fn growing(&self, end: f64, periods: f64) -> [f64; 2] {
        let pieces = (24.0 * periods.max(1.0)).ceil();
        let h = end / pieces;
        let mut sums = [0.0; 2];
        for piece in 0..pieces as usize {
            for [at, weight] in GAUSS {
                let time = h * (piece as f64 + 0.5 + 0.5 * at);
                let own = 0.5 * h * weight * self.value(time);
                sums = [sums[0] + own, sums[1] + own * (end - time)];
            }
        }
        sums
    }
}

/// The quintic `s³(10 − 15s + 6s²)` on \[0, 1\].
pub(crate) fn smooth(s: f64) -> f64 {
    let s = s.clamp(0.0, 1.0);
    s * s * s * (10.0 - 15.0 * s + 6.0 * s * s)
}

fn table(points: &[[f64; 2]], time: f64) -> f64 {
    let after = points.partition_point(|&[t, _]| t <= time);
    match (after.checked_sub(1).and_then(|i| points.get(i)), points.get(after)) {
        (Some(&[t0, v0]), Some(&[t1, v1])) => v0 + (v1 - v0) * (time - t0) / (t1 - t0),
        (Some(&[_, v]), None) | (None, Some(&[_, v])) => v,
        (None, None) => 1.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn amplitudes_take_the_values_they_name() {
        assert_eq!(Amplitude::Constant.value(7.0), 1.0);
        assert_eq!(Amplitude::Ramp(2.0).value(0.5), 0.25);
        assert_eq!(Amplitude::Ramp(2.0).value(5.0), 1.0);
        assert_eq!(Amplitude::Smooth(2.0).value(1.0), 0.5);
        for (time, value) in [(1.0, 1.0), (2.0, 0.0), (3.0, -1.0)] {
            assert!((Amplitude::Sine { period: 4.0, growth: None }.value(time) - value).abs() < 1e-15);
        }
        let grown = Amplitude::Sine { period: 4.0, growth: Some(2.0) };
        assert!((grown.value(1.0) - 0.5).abs() < 1e-15 && (grown.value(5.0) - 1.0).abs() < 1e-14);
        let table = Amplitude::Table(vec![[1.0, 2.0], [3.0, 6.0]]);
        assert_eq!([0.0, 1.0, 2.0, 3.0, 9.0].map(|t| table.value(t)), [2.0, 2.0, 4.0, 6.0, 6.0]);
    }

    /// Simpson's rule over steps so small that what it leaves, h⁴, is below rounding of the sums.
    #[test]
    fn integrals_are_those_of_small_steps() {
        let table = vec![[0.3, 1.0], [0.5, -2.0], [0.9, 0.7], [1.4, 0.0]];
        let all = [
            Amplitude::Constant,
            Amplitude::Ramp(0.75),
            Amplitude::Smooth(0.75),
            Amplitude::Sine { period: 0.6, growth: None },
            Amplitude::Sine { period: 0.6, growth: Some(1.1) },
            Amplitude::Sine { period: 0.9, growth: Some(0.1) },
            Amplitude::Table(table),
        ];
        for amplitude in all {
            let (mut v, mut u) = (0.0, 0.0);
            let h = 1e-3;
            for i in 0..2000 {
                let t = f64::from(i) * h;
                let [a, m, b] = [t, t + 0.5 * h, t + h].map(|t| amplitude.value(t));
                // ∫₀ʰ (h − s) a(t + s) ds by the same points.
                u += h * v + h * h * (a + 2.0 * m) / 6.0;
                v += h * (a + 4.0 * m + b) / 6.0;
            }
            let [exact_v, exact_u] = amplitude.integrals(2.0);
            assert!(
                (v - exact_v).abs() < 1e-10 && (u - exact_u).abs() < 1e-10,
                "{amplitude:?}: {v} {exact_v}, {u} {exact_u}"
            );
        }
    }

    /// It grows for longer than anyone marches, `10 (t/G)³ sin ωt` is all but zero, and only as many pieces are summed as the time has.
    #[test]
    fn a_growth_of_ages_takes_no_longer_than_its_time() {
        let ages = Amplitude::Sine { period: 0.5, growth: Some(1e9) };
        assert!(ages.integrals(1.0).iter().all(|x| x.abs() < 1e-20));
        // To the end of a long growth: −cos ωG / ω, and what its slope adds falls with the fourth power of the periods in it.
        let grown = Amplitude::Sine { period: 0.5, growth: Some(200.0) };
        let [v, _] = grown.integrals(200.0);
        assert!((v + 0.5 / std::f64::consts::TAU).abs() < 1e-9, "{v}");
    }

    #[test]
    fn smooth_starts_and_ends_without_velocity_or_acceleration() {
        // The quintic deviates from its end values by 10 s³ + O(s⁴).
        let s = 1e-3;
        assert!((smooth(s) - 10.0 * s * s * s).abs() < 16.0 * s * s * s * s);
        assert!((1.0 - smooth(1.0 - s) - 10.0 * s * s * s).abs() < 16.0 * s * s * s * s);
    }
}
