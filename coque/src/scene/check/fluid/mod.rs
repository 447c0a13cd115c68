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
        self.check_geometry(s)
    }
}
