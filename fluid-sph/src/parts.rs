//! What a fluid is built from.

use explicit_dynamics::{Amplitude, BoundaryLayout, BoundaryState};
use sph_core::Vec3;

use crate::formulation::Formulation;
use crate::liquid::Liquid;

/// Rows of particles outside the fluid, a spacing apart and half a spacing behind its border.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Wall {
    /// Places of its particles where its motion is zero \[L\].
    pub points: Vec<Vec3>,
    /// How it moves; it stands without.
    pub motion: Option<Motion>,
}

/// The motion of a rigid wall: a turn about a centre that a translation carries along.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Motion {
    /// Displacement \[L\], times its course.
    pub translation: Option<(Vec3, Course)>,
    /// Turn.
    pub rotation: Option<Rotation>,
}

/// A turn about a fixed axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Rotation {
    /// A point of the axis \[L\].
    pub centre: Vec3,
    /// Direction of the axis; in two dimensions the third.
    pub axis: Vec3,
    /// Angle where the amplitude is one \[rad\].
    pub by: f64,
    /// Course of the angle.
    pub angle: Course,
}

/// The course of a motion in time.
#[derive(Clone, Debug, PartialEq)]
pub enum Course {
    /// An amplitude.
    Amplitude(Amplitude),
    /// Sines: `Σ f sin(ωt + φ)` of terms `[f, ω, φ]`, grown over a time as `smooth` grows \[–, 1/T, rad; T\].
    Sines {
        /// The terms.
        terms: Vec<[f64; 3]>,
        /// The time.
        growth: f64,
    },
}

impl From<Amplitude> for Course {
    fn from(amplitude: Amplitude) -> Self {
        Self::Amplitude(amplitude)
    }
}

impl Course {
    /// The factor at a time \[T\].
    pub fn value(&self, time: f64) -> f64 {
        match self {
            Self::Amplitude(amplitude) => amplitude.value(time),
            Self::Sines { terms, growth } => {
                let sum: f64 =
                    terms.iter().map(|[factor, omega, phase]| factor * libm::sin(omega * time + phase)).sum();
                sum * Amplitude::Smooth(*growth).value(time)
            }
        }
    }
}

/// Pressures at the start.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(
    feature = "scene",
    derive(serde::Deserialize, schemars::JsonSchema),
    serde(rename_all = "kebab-case"),
    schemars(rename = "FluidStart")
)]
pub enum Start {
    /// Hydrostatic under the highest particle of each connected body of fluid and half a spacing.
    #[default]
    Hydrostatic,
    /// None.
    Uniform,
}

/// A structure that the fluid wets.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Structure {
    /// How its points belong together.
    pub layout: BoundaryLayout,
    /// Where they are at the start.
    pub state: BoundaryState,
}

/// All that a fluid is built from.
#[derive(Clone, Debug)]
pub struct Parts {
    /// Two (the plane z = 0, per unit of depth) or three.
    pub dimensions: usize,
    /// Distance of neighbouring particles Δx \[L\]; each has the mass ρ₀Δxᵈ.
    pub spacing: f64,
    /// Places of the particles \[L\].
    pub positions: Vec<Vec3>,
    /// Their velocities \[L/T\]; none given: at rest.
    pub velocities: Vec<Vec3>,
    /// The liquid.
    pub liquid: Liquid,
    /// The method.
    pub formulation: Formulation,
    /// Gravity \[L/T²\].
    pub gravity: Vec3,
    /// Pressures at the start.
    pub start: Start,
    /// Walls.
    pub walls: Vec<Wall>,
    /// Structures.
    pub structures: Vec<Structure>,
    /// Corners of the box that no particle may leave \[L\]; unbounded without.
    pub domain: Option<[Vec3; 2]>,
    /// Threads to use of those of the pool: one marches without it.
    pub threads: usize,
}
