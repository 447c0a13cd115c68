//! From text to a checked scene, with overrides on the way.

use serde::Deserialize;
use toml::Spanned;
use toml::de::DeTable;

use super::checked::Checked;
use super::error::SceneError;
use super::problem::Scene;
use super::source::Source;
use super::{forms, overrides, tables};

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
