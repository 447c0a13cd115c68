//! A scene that has passed every check that needs no particles.

use std::ops::Deref;

use super::body_in_scene::BodyInScene;
use super::check::{check, first_body};
use super::error::SceneError;
use super::problem::Scene;

/// A checked scene: made by reading one or by [`Scene::check`], never changed, and the only thing that is built.
#[derive(Clone, Debug)]
pub struct Checked {
    scene: Scene,
}

impl Checked {
    /// The scene, to be changed; [`Scene::check`] checks it anew.
    pub fn into_scene(self) -> Scene {
        self.scene
    }

    /// Each body with all that the scene says of it, by name.
    ///
    /// # Errors
    /// [`SceneError`] for what the checks refuse.
    pub(crate) fn bodies_in_scene(&self) -> Result<Vec<BodyInScene<'_>>, SceneError> {
        let bodies = self.bodies.iter();
        bodies.map(|(name, body)| BodyInScene::new(&self.scene, name, body)).collect()
    }

    /// The one body with all that the scene says of it; of several the first by name.
    ///
    /// # Errors
    /// [`SceneError`] for what the checks refuse.
    pub(crate) fn first_body(&self) -> Result<BodyInScene<'_>, SceneError> {
        first_body(&self.scene)
    }
}

impl Deref for Checked {
    type Target = Scene;

    fn deref(&self) -> &Scene {
        &self.scene
    }
}

impl Scene {
    /// Checks all that needs no particles.
    ///
    /// # Errors
    /// [`SceneError`] for the first thing that is out of bounds.
    pub fn check(self) -> Result<Checked, SceneError> {
        check(&self)?;
        Ok(Checked { scene: self })
    }
}
