//! The stiffeners of a scene on their particles.

use sph_shell::Stiffener;

use super::bars::bar_of;
use super::build::Builder;
use crate::bodies::sets::Sets;
use crate::scene::error::SceneError;

impl Builder<'_> {
    /// Bars along lines, in the order of the scene.
    ///
    /// # Errors
    /// [`SceneError`] for sets that are none.
    pub(super) fn stiffeners(&self, sets: &Sets) -> Result<Vec<Stiffener>, SceneError> {
        let shell = self.scene.shell;
        let mut all = Vec::new();
        for (i, stiffener) in shell.stiffeners.iter().enumerate() {
            let path = self.scene.body_scope().path(&format!("stiffeners[{i}].on"));
            let particles = sets.at(self.scene, &path, &stiffener.on)?.to_vec();
            all.extend(bar_of(stiffener, shell).map(|bar| Stiffener { particles, ..bar }));
        }
        Ok(all)
    }
}
