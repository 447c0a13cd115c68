//! A zone that takes the motion out of waves, as a long flat beach does.
//!
//! ```text
//! v' = … − β v      β = β₀ s²,   s = (r − p)·n/L from 0 where the zone begins to 1 at its end
//! ```
//!
//! Waves of the group velocity c_g lose half of β of their height in a unit of time, so that one that goes through the zone and comes back from a wall at its end
//! has the part `exp(−∫ β/c_g dx) = exp(−β₀L/3c_g)` of it: this gives β₀. The zone grows from nothing, so that little comes back before.

use sph_core::Vec3;

/// A damping zone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Beach {
    /// A point at which it begins \[L\].
    pub from: Vec3,
    /// Unit vector along which waves go into it.
    pub along: Vec3,
    /// Its length \[L\]; beyond it damps as at its end.
    pub length: f64,
    /// β₀ at its end \[1/T\].
    pub strength: f64,
}

impl Beach {
    /// The strength at which waves of a group velocity \[L/T\] come back with a part of their height.
    pub fn strength(length: f64, group_velocity: f64, left: f64) -> f64 {
        -3.0 * group_velocity / length * libm::log(left)
    }

    /// β at a place \[1/T\].
    pub(crate) fn rate(&self, at: [f64; 3]) -> f64 {
        let s = ((Vec3::from(at) - self.from).dot(&self.along) / self.length).clamp(0.0, 1.0);
        self.strength * s * s
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wave_to_the_end_and_back_has_the_part_that_is_asked() {
        let strength = Beach::strength(3.0, 1.5, 0.02);
        let beach = Beach { from: Vec3::x(), along: Vec3::x(), length: 3.0, strength };
        assert_eq!([0.0, 1.0, 9.0].map(|x| beach.rate([x, 5.0, 0.0])), [0.0, 0.0, strength]);
        // Its way there and back at the group velocity, in each of which half of β is lost.
        let (steps, step) = (3000, 1e-3);
        let lost: f64 =
            (0..steps).map(|i| beach.rate([1.0 + (f64::from(i) + 0.5) * step, 0.0, 0.0]) * step / 1.5).sum();
        assert!((libm::exp(-lost) - 0.02).abs() < 1e-6);
    }
}
