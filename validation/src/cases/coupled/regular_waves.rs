//! Regular waves by their gauges: first harmonics, what goes along a flume and what comes back, and the course of the height.

use std::f64::consts::TAU;

use super::measure::line;
use crate::JudgeError;
use crate::judge::Run;

/// A number of the complex plane, by its parts.
pub type Complex = [f64; 2];

/// Gravity \[m/s²\].
const GRAVITY: f64 = 9.81;

/// Waves, and the whole periods in which they are looked at.
#[derive(Clone, Copy, Debug)]
pub struct RegularWaves {
    /// Period \[s\].
    pub period: f64,
    /// Depth of the water \[m\].
    pub depth: f64,
    /// From when on they are regular \[s\].
    pub from: f64,
    /// Periods that are measured.
    pub periods: f64,
}

impl RegularWaves {
    /// Length by linear theory, `ω² = g k tanh kd`, by halving \[m\].
    pub fn length(&self) -> f64 {
        let wanted = (TAU / self.period) * (TAU / self.period) * self.depth / GRAVITY;
        let (mut low, mut high) = (1e-3, 50.0);
        for _ in 0..100 {
            let middle = 0.5 * (low + high);
            if middle * libm::tanh(middle) > wanted {
                high = middle;
            } else {
                low = middle;
            }
        }
        TAU * self.depth / low
    }

    /// Times and values within the periods that are measured.
    pub fn kept(&self, time: &[f64], values: &[f64]) -> Vec<[f64; 2]> {
        let end = self.from + self.periods * self.period - 1e-9;
        let inside = |t: f64| t > self.from - 1e-9 && t < end;
        time.iter().zip(values).filter(|(t, _)| inside(**t)).map(|(t, h)| [*t, *h]).collect()
    }

    /// The first harmonic of a gauge, `2/n Σ 2 h exp(iωt)`: its size is the height from trough to crest, its phase how late the wave is.
    pub fn harmonic(&self, time: &[f64], level: &[f64]) -> Option<Complex> {
        let kept = self.kept(time, level);
        if kept.is_empty() {
            return None;
        }
        let part = |of: &dyn Fn(f64) -> f64| {
            let sum: f64 = kept.iter().map(|[t, h]| h * of(TAU * t / self.period)).sum();
            4.0 / kept.len() as f64 * sum
        };
        Some([part(&libm::cos), part(&libm::sin)])
    }

    /// Heights of the waves that go along x and of those that come back, `h = a exp(ikx) + b exp(−ikx)` at both gauges.
    pub fn separated(&self, places: [f64; 2], gauges: [Complex; 2]) -> [f64; 2] {
        let number = TAU / self.length();
        let turned = |[x, y]: Complex, angle: f64| {
            let (sin, cos) = libm::sincos(angle);
            [x * cos - y * sin, x * sin + y * cos]
        };
        let [near, far] = places.map(|x| number * x);
        let height = |sign: f64| {
            // a = (h₀ exp(−ikx₁) − h₁ exp(−ikx₀))/(2i sin k(x₀ − x₁)), b with the other sign of k.
            let ([a, b], [c, d]) = (turned(gauges[0], -sign * far), turned(gauges[1], -sign * near));
            libm::hypot(a - c, b - d) / (2.0 * libm::sin(far - near).abs())
        };
        [height(1.0), height(-1.0)]
    }

    /// Height at x = 0 \[m\] and the rate at which it falls along the flume \[1/m\], by a straight line through the logarithms of the heights that pairs of gauges separate, over the
    /// middles of the pairs. Gauges by their places \[m\] and columns, of which `apart` lie between the two of a pair.
    pub fn course(
        &self,
        run: &Run,
        gauges: &[(f64, String)],
        apart: usize,
    ) -> Result<Option<[f64; 2]>, JudgeError> {
        let time = run.column("time")?;
        let of = |(place, name): &(f64, String)| Ok((*place, self.harmonic(&time, &run.column(name)?)));
        let waves = gauges.iter().map(of).collect::<Result<Vec<_>, JudgeError>>()?;
        let pairs = waves.iter().zip(waves.iter().skip(apart));
        let heights: Option<Vec<[f64; 2]>> = pairs
            .map(|(&(near, one), &(far, other))| {
                let [along, _] = self.separated([near, far], [one?, other?]);
                Some([0.5 * (near + far), libm::log(along)])
            })
            .collect();
        Ok(heights.map(|heights| {
            let [start, slope] = line(&heights);
            [libm::exp(start), -slope]
        }))
    }
}
