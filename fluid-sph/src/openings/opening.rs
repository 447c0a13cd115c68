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
