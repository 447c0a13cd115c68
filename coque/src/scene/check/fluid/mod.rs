//! The checks of a fluid and its walls, their keys relative to where they stand in the scene.

mod conditions;
mod geometry;
mod speed;
mod walls;

pub(super) use self::conditions::{check_load_of_fluid, check_unsupported, check_velocity_of_fluid};
pub(super) use self::speed::check_sound_speed;
use crate::scene::error::Verdict;
use crate::scene::fluid::FluidScene;
use crate::scene::scope::Scope;

impl FluidScene {
    /// Refuses the first of its own keys that is out of bounds.
    pub(super) fn check(&self, s: &Scope<'_>) -> Verdict {
        self.check_geometry(s)?;
        self.check_liquid(s)?;
        self.check_formulation(s)
    }

    fn check_liquid(&self, s: &Scope<'_>) -> Verdict {
        let liquid = self.liquid();
        s.positive("material.liquid.density", liquid.density)?;
        s.positive("material.liquid.sound_speed", liquid.sound_speed)?;
        s.not_negative("material.liquid.kinematic_viscosity", liquid.kinematic_viscosity)
    }

    fn check_formulation(&self, s: &Scope<'_>) -> Verdict {
        let options = self.formulation.options();
        let at = |key: &str| format!("formulation.{}.{key}", self.formulation.word());
        let given = |key: &str, value: Option<f64>, bounds: [f64; 2], repair: &str| match value {
            Some(value) => s.within(&at(key), value, bounds, repair),
            None => Ok(()),
        };
        given(
            "smoothing",
            options.smoothing,
            [1.0, 3.0],
            "1.55 is usual; 2 covers fluid that is stretched twofold and costs half as much again",
        )?;
        given(
            "viscosity",
            options.viscosity,
            [0.0, 1.0],
            "0.02 is usual; 0.1 hides a third of the energy at walls",
        )?;
        given(
            "density_diffusion",
            options.density_diffusion,
            [0.0, 0.5],
            "0.1 is usual; 0 leaves pressures noisy",
        )?;
        given("xsph", options.xsph, [0.0, 1.0], "0 is usual, 0.5 in the published method")?;
        given(
            "courant",
            options.courant,
            [0.001, 0.5],
            "0.3 is usual; at 0.6 still water does not stay at rest",
        )
    }
}
