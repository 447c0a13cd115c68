//! A fluid in a scene: its particles at the start, the liquid, the method, its velocity.

pub(crate) mod current;
pub(crate) mod formulation;
pub(crate) mod geometry;
pub(crate) mod openings;
pub(crate) mod periodic;

use schemars::JsonSchema;
use serde::Deserialize;

use super::velocity::Velocity;
use super::waves::Beach;
use crate::scene::bounded::{NotNegative, Positive};
use current::Current;
use formulation::FluidFormulation;
use geometry::FluidGeometry;
use openings::FluidOpening;
use periodic::PeriodicSides;

/// A weakly compressible fluid of particles, in a plane or in space.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FluidScene {
    /// Where it is at the start.
    pub geometry: FluidGeometry,
    /// What it is.
    pub material: FluidMaterial,
    /// The particle method; left out, `weakly-compressible` with its defaults.
    #[serde(default)]
    pub formulation: FluidFormulation,
    /// Velocity at the start.
    pub velocity: Option<Velocity>,
    /// A zone in which waves run out.
    pub beach: Option<Beach>,
    /// Sides of its box that are one.
    pub periodic: Option<PeriodicSides>,
    /// A zone that carries the water along.
    pub current: Option<Current>,
    /// Sides by which water comes in and goes out.
    #[serde(default)]
    pub openings: Vec<FluidOpening>,
    /// Particles that it has room for, with openings; left out, twice those at the start. A run that comes to need more ends.
    pub most_particles: Option<usize>,
}

/// Fluids.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub enum FluidMaterial {
    /// A liquid of the Tait equation `p = ρ₀c₀²/7 [(ρ/ρ₀)⁷ − 1]`.
    Liquid(Liquid),
}

/// A liquid.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Liquid {
    /// Density at rest \[F T²/L⁴\].
    pub density: Positive,
    /// Speed of sound of the model, ten times the greatest speed of the flow: seven times at least \[L/T\].
    pub sound_speed: Positive,
    /// Kinematic viscosity; left out, none \[L²/T\].
    #[serde(default)]
    pub kinematic_viscosity: NotNegative,
}

impl FluidScene {
    /// Dimensions of its particles, two or three.
    pub fn dimensions(&self) -> usize {
        self.geometry.dimensions()
    }

    /// Particles that it has room for, of so many at the start.
    pub(crate) fn room(&self, at_start: usize) -> usize {
        if self.openings.is_empty() { at_start } else { self.most_particles.unwrap_or(2 * at_start) }
    }

    /// The liquid.
    pub fn liquid(&self) -> Liquid {
        let FluidMaterial::Liquid(liquid) = self.material;
        liquid
    }
}
