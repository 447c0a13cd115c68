//! The law of contact: energy of a depth, its slope and its curvature.

use libm::log;

/// Depth over the contact distance from which the barrier stands.
const BARRIER: f64 = 0.5;
/// Depth that stands for all beyond: a mid-surface that would have come through.
const THROUGH: f64 = 1.0 - 1e-9;

/// Energy of a relative depth `s = (D − d)/D`, D the distance at which faces touch and d that of the mid-surfaces, in units of k D².
///
/// ```text
/// φ = s³/(12 b)               0 ≤ s < 2b
/// φ = (s − b)²/2 + b²/6       s ≥ 2b
/// φ += −(s − ½)² ln 2(1 − s)  s > ½
/// ```
///
/// It is twice differentiable for b > 0, and infinite at s = 1: mid-surfaces never meet. A rounded corner keeps the energy of
/// bodies that bounce in steps of finite size; without it (b = 0) depths of any size are resolved, as answers without time need.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Law {
    rounding: f64,
    /// Whether the barrier is left out.
    open: bool,
}

impl Law {
    /// The law without rounding.
    pub const SHARP: Self = Self { rounding: 0.0, open: false };

    /// A law with the rounding b \[–\] of its corner, from zero to an eighth, so that it ends before the barrier begins.
    pub fn new(rounding: f64) -> Option<Self> {
        (0.0..=0.125).contains(&rounding).then_some(Self { rounding, open: false })
    }

    /// The rounding b \[–\].
    pub fn rounding(&self) -> f64 {
        self.rounding
    }

    /// The law without its barrier: quadratic at any depth, what is soft may come through.
    pub fn open(self) -> Self {
        Self { open: true, ..self }
    }

    /// φ, its first and its second derivative at a relative depth \[–\].
    #[inline]
    pub fn at(&self, depth: f64) -> [f64; 3] {
        if depth <= 0.0 {
            return [0.0; 3];
        }
        let (s, b) = (if self.open { depth } else { depth.min(THROUGH) }, self.rounding);
        let [mut energy, mut slope, mut curvature] = if s < 2.0 * b {
            [s * s * s / (12.0 * b), s * s / (4.0 * b), s / (2.0 * b)]
        } else {
            [0.5 * (s - b) * (s - b) + b * b / 6.0, s - b, 1.0]
        };
        if s > BARRIER && !self.open {
            let (beyond, left) = (s - BARRIER, 1.0 - s);
            let log = log(2.0 * left);
            energy -= beyond * beyond * log;
            slope += beyond * (beyond / left - 2.0 * log);
            curvature += -2.0 * log + 4.0 * beyond / left + (beyond / left) * (beyond / left);
        }
        [energy, slope, curvature]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ROUNDINGS: [f64; 3] = [0.0, 0.05, 0.125];

    /// Central differences of 1e-6 of numbers of the order of one are right to 1e-9.
    #[test]
    fn slope_and_curvature_are_derivatives_everywhere() {
        for b in ROUNDINGS {
            let law = Law::new(b).unwrap();
            for i in 1..95 {
                // No point on a corner of the law: there the curvature of b = 0 jumps.
                let s = 0.01 * f64::from(i) + 0.0033;
                let h = 1e-6;
                let [[e0, f0, _], [e1, f1, _]] = [law.at(s - h), law.at(s + h)];
                let [_, slope, curvature] = law.at(s);
                assert!(((e1 - e0) / (2.0 * h) - slope).abs() < 1e-8 * (1.0 + slope), "{b} {s}");
                assert!(((f1 - f0) / (2.0 * h) - curvature).abs() < 3e-8 * (1.0 + curvature), "{b} {s}");
            }
        }
    }

    #[test]
    fn the_law_is_smooth_where_its_pieces_meet() {
        for b in [0.05, 0.125] {
            let law = Law::new(b).unwrap();
            for meet in [0.0, 2.0 * b, 0.5] {
                let [below, above] = [law.at(meet - 1e-9), law.at(meet + 1e-9)];
                for (below, above) in below.into_iter().zip(above) {
                    assert!((below - above).abs() < 1e-7, "{b} {meet}: {below} {above}");
                }
            }
        }
    }

    #[test]
    fn what_does_not_touch_feels_nothing_and_what_came_through_feels_much() {
        let law = Law::new(0.0).unwrap();
        assert_eq!(law.at(-0.1), [0.0; 3]);
        assert_eq!(law.at(0.25), [0.5 * 0.25 * 0.25, 0.25, 1.0]);
        assert!(law.at(1.5)[1] > 1e8 && law.at(f64::INFINITY)[1].is_finite());
        assert_eq!(Law::new(0.0).unwrap().open().at(1.5), [0.5 * 1.5 * 1.5, 1.5, 1.0]);
        assert_eq!(Law::new(-0.1), None);
        assert_eq!(Law::new(0.2), None);
        assert_eq!(Law::new(f64::NAN), None);
    }
}
