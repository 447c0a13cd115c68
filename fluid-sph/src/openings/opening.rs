//! What an opening of a fluid is.

use explicit_dynamics::Amplitude;
use sph_core::Vec3;

/// An opening through which a fluid comes in or goes out: a plane across an axis, as far as the fluid reaches at it at the start, and upwards
/// without an end.
#[derive(Clone, Debug, PartialEq)]
pub struct Opening {
    /// A point of its plane \[L\].
    pub at: Vec3,
    /// Unit vector along an axis, into the fluid.
    pub into: Vec3,
    /// What is given there.
    pub given: Given,
}

/// What is given at an opening; what is not comes from the fluid beside it.
#[derive(Clone, Debug, PartialEq)]
pub enum Given {
    /// Velocity across it; the pressure comes from the fluid.
    Velocity {
        /// Velocity into the fluid, negative out of it \[L/T\].
        into: f64,
        /// Its course in time.
        course: Amplitude,
        /// Factors of it at heights along −g, `[height, factor]`, straight lines between them; one everywhere if there is none.
        profile: Vec<[f64; 2]>,
        /// Height up to which water comes in \[L\]; without it as far as the water beside stands.
        level: Option<f64>,
    },
    /// Pressure at rest under a level, `P₀ + ρ₀ g (level − height)` and none below zero; the velocity comes from the fluid.
    Pressure {
        /// P₀ \[F/L²\].
        at_level: f64,
        /// Height of the level along −g \[L\]; none without gravity.
        level: f64,
    },
    /// Nothing: what gets there goes out.
    Free,
}

impl Given {
    /// Factor of a velocity at a height, by straight lines between those of a profile.
    pub(crate) fn factor(profile: &[[f64; 2]], height: f64) -> f64 {
        let (Some(first), Some(last)) = (profile.first(), profile.last()) else { return 1.0 };
        if height <= first[0] {
            return first[1];
        }
        for pair in profile.windows(2) {
            let ([a, u], [b, v]) = (pair[0], pair[1]);
            if height < b {
                return u + (v - u) * ((height - a) / (b - a));
            }
        }
        last[1]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn profiles_are_straight_between_their_heights_and_constant_beyond() {
        let profile = [[0.0, 0.0], [0.5, 1.0], [1.0, 2.0]];
        let found = [-1.0, 0.0, 0.25, 0.5, 0.75, 1.0, 3.0].map(|height| Given::factor(&profile, height));
        assert_eq!(found, [0.0, 0.0, 0.5, 1.0, 1.5, 2.0, 2.0]);
        assert_eq!(Given::factor(&[], 0.3), 1.0);
    }
}
