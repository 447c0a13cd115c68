//! From text to a scene that has passed every check that needs no particles, with overrides on the way.

use std::ops::Deref;

use serde::Deserialize;
use toml::Spanned;
use toml::de::DeTable;

use crate::scene::body_in_scene::BodyInScene;
use crate::scene::check::{check, first_body};
use crate::scene::error::SceneError;
use crate::scene::problem::Scene;
use crate::scene::source::Source;
use crate::scene::{forms, overrides, tables};

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
        let mut scene = self;
        scene.touch_walls();
        scene.shake_base();
        Ok(Checked { scene })
    }
}

impl Scene {
    /// Reads and checks a scene; `origin` names the text in errors.
    ///
    /// # Errors
    /// [`SceneError`] for the first thing that is wrong.
    pub fn parse(text: &str, origin: &str) -> Result<Checked, SceneError> {
        Self::with_overrides(text, origin, &[])
    }

    /// Reads a scene in which some values are replaced: `("material.elastic.young", "2.1e11")`.
    ///
    /// A path goes through tables by key and through lists by number (`loads[0].couple.moment` or
    /// `loads.0.couple.moment`); `loads[+]` is one item more. A value is TOML; a bare word counts as a string. Naming another
    /// alternative (`formulation.nodal.order`) drops the one that the text names.
    ///
    /// # Errors
    /// [`SceneError`] for the first thing that is wrong, in the text or in an override.
    pub fn with_overrides(
        text: &str,
        origin: &str,
        replaced: &[(String, String)],
    ) -> Result<Checked, SceneError> {
        let document = overrides::shown(text, replaced);
        let mut source = Source::new(origin, &document);
        let whole = source.text();
        let mut table: Spanned<DeTable<'_>> =
            DeTable::parse(&whole[..text.len()]).map_err(|e| source.refusal(&e))?;
        overrides::apply(table.get_mut(), &whole, text.len(), replaced, &source)?;
        source.index(table.get_ref())?;
        tables::refuse_lists(table.get_ref(), &source)?;
        forms::lengthen(&mut table, &source)?;
        let mut scene =
            Self::deserialize(toml::de::Deserializer::from(table)).map_err(|e| source.refusal(&e))?;
        scene.source = source;
        scene.drop_body_names();
        scene.check()
    }
}
