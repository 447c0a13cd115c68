//! The checks of a shell, its keys relative to where it stands in the scene.

mod formulation;
mod geometry;
mod initial_stress;
mod material;
mod parts;
mod placed;
mod rigid;
mod tools;

pub(super) use self::parts::check_parts;
pub(super) use self::placed::check_wetting;
pub(super) use self::tools::check_tools;
use crate::scene::error::SceneError;
use crate::scene::scope::Scope;
use crate::scene::shell::ShellScene;

impl ShellScene {
    /// Refuses the first thing that is out of bounds.
    pub(super) fn check(&self, s: &Scope<'_>) -> Result<(), SceneError> {
        self.check_geometry(s)?;
        self.check_placed(s)?;
        self.check_material(s)?;
        formulation::check_formulation(&self.formulation, s)
    }
}
