//! The particle method of a fluid.

use fluid_sph::Formulation;
pub use fluid_sph::{Start as FluidStart, WallRule as WallMethod};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::scene::bounded::{Courant, Diffusion, FluidSmoothing, Shared, Viscosity};

/// How particles carry a fluid.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub enum FluidFormulation {
    /// Smoothed particles with densities of their own, a stiff equation of state, explicit steps.
    WeaklyCompressible(WeaklyCompressible),
}

impl Default for FluidFormulation {
    fn default() -> Self {
        Self::WeaklyCompressible(WeaklyCompressible::default())
    }
}

/// Options of the weakly compressible method.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct WeaklyCompressible {
    /// Who steps it; the other options take the defaults of the method.
    pub method: FluidMethod,
    /// Smoothing length in spacings; left out, 1.55, of the published method 1.3.
    pub smoothing: Option<FluidSmoothing>,
    /// Artificial viscosity α; left out, 0.02, of the published method 0.1.
    pub viscosity: Option<Viscosity>,
    /// Diffusion of density δ; left out, 0.1, of the published method none.
    pub density_diffusion: Option<Diffusion>,
    /// Share of the neighbours' velocity with which particles drift; left out, none, of the published method 0.5.
    pub xsph: Option<Shared>,
    /// Courant number; left out, 0.3.
    pub courant: Option<Courant>,
    /// What wall particles do; left out, `extrapolated`, of the published method `dynamic`.
    pub walls: Option<WallMethod>,
    /// Pressure at the start.
    pub start: FluidStart,
    /// Whether walls enclose the fluid without a free surface, and may pull.
    pub confined: bool,
    /// Whether walls and structures let the fluid slip: no friction acts against them, neither that of the liquid nor the artificial one.
    pub slip: bool,
}

/// Integrators of a fluid, each with options that suit it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum FluidMethod {
    /// Kick, drift, kick: one half sweep for densities and one for forces a step.
    #[default]
    KickDriftKick,
    /// The published predictor and corrector: two sweeps a step.
    Source,
}

impl WeaklyCompressible {
    /// Smoothing length in spacings \[–\], that of the method where it is left out.
    pub fn smoothing(&self) -> f64 {
        self.smoothing.map_or_else(|| self.usual().smoothing, |smoothing| smoothing.get())
    }

    /// Courant number \[–\], that of the method where it is left out.
    pub fn courant(&self) -> f64 {
        self.courant.map_or_else(|| self.usual().courant, |courant| courant.get())
    }

    /// What the method has where nothing is said.
    fn usual(&self) -> Formulation {
        match self.method {
            FluidMethod::KickDriftKick => Formulation::default(),
            FluidMethod::Source => Formulation::published(),
        }
    }
}

impl FluidFormulation {
    /// Its key in a scene.
    pub fn word(&self) -> &'static str {
        "weakly-compressible"
    }

    /// Its options.
    pub fn options(&self) -> WeaklyCompressible {
        let Self::WeaklyCompressible(options) = self;
        *options
    }
}
