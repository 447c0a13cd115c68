//! A zone that carries the water along with a velocity, as the pump of a flume does.
//!
//! ```text
//! v' = … − β (v − U n)      β = 4β₀ s(1 − s),   s = (r − p)·n/L from 0 to 1 within the zone, none outside
//! ```
//!
//! Of what water that goes through with U differs from it on its way in, the part `exp(−∫ β dx/U) = exp(−2β₀L/3U)` is left on its way out: this gives β₀. The
//! zone grows from nothing and ends in nothing, so that little comes back of waves that run into it, which it takes the motion of too. What it does
//! to the kinetic energy is work from outside.

use sph_core::Vec3;

/// A zone of a given velocity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Current {
    /// A point at which it begins \[L\].
    pub from: Vec3,
    /// Unit vector along which the water goes.
    pub along: Vec3,
    /// Its length \[L\].
    pub length: f64,
    /// Velocity of the water U along it \[L/T\].
    pub velocity: f64,
    /// β₀, a quarter more than which it has nowhere \[1/T\].
    pub strength: f64,
}

impl Current {
    /// The strength at which a part is left of what water differs from the velocity \[1/T\].
    pub fn strength(length: f64, velocity: f64, left: f64) -> f64 {
        -1.5 * velocity / length * libm::log(left)
    }

    /// β at a place \[1/T\].
    pub(crate) fn rate(&self, at: [f64; 3]) -> f64 {
        let s = ((Vec3::from(at) - self.from).dot(&self.along) / self.length).clamp(0.0, 1.0);
        4.0 * self.strength * s * (1.0 - s)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Water that goes through loses what it differs by but for the part asked, and the zone begins and ends in nothing.
    #[test]
    fn water_that_goes_through_has_the_part_that_is_asked() {
        let strength = Current::strength(2.0, 0.5, 0.02);
        let current = Current { from: Vec3::x(), along: Vec3::x(), length: 2.0, velocity: 0.5, strength };
        assert_eq!(
            [0.0, 1.0, 2.0, 3.0, 9.0].map(|x| current.rate([x, 5.0, 0.0])),
            [0.0, 0.0, strength, 0.0, 0.0]
        );
        let (steps, step) = (2000, 1e-3);
        let lost: f64 = (0..steps)
            .map(|i| current.rate([1.0 + (f64::from(i) + 0.5) * step, 0.0, 0.0]) * step / 0.5)
            .sum();
        assert!((libm::exp(-lost) - 0.02).abs() < 1e-6);
    }
}
