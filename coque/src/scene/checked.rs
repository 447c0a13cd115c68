//! From text to a scene that has passed every check that needs no particles, with overrides on the way.

use std::collections::BTreeMap;
use std::ops::Deref;

use serde::Deserialize;
use toml::Spanned;
use toml::de::DeTable;

use crate::scene::body_in_scene::BodyInScene;
use crate::scene::check::{check, first_body};
use crate::scene::error::SceneError;
use crate::scene::includes::Included;
use crate::scene::parameters::Values;
use crate::scene::problem::Scene;
use crate::scene::source::Source;
use crate::scene::{forms, includes, lists, overrides, parameters, records, tables};

/// A checked scene: made by reading one or by [`Scene::check`], never changed, and the only thing that is built.
#[derive(Clone, Debug)]
pub struct Checked {
    scene: Scene,
}

impl Checked {
    /// A scene of which a checked one is a part, or a multiple: nothing in it is out of bounds that was not so before.
    pub(super) fn made_of(scene: Scene) -> Self {
        Self { scene }
    }

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
        let files = includes::read(text, origin)?;
        let source = Self::texts(text, origin, replaced, &files);
        let whole = source.text();
        Self::merged(&whole, text.len(), replaced, &files, source)
    }

    /// The text of a scene with all that it includes and the texts of files that its records name once values are replaced, to be read with these values and
    /// without the files; itself where there are none.
    ///
    /// # Errors
    /// [`SceneError`] for files that cannot be read or are no TOML.
    pub fn whole_text(text: &str, origin: &str, replaced: &[(String, String)]) -> Result<String, SceneError> {
        let files = includes::read(text, origin)?;
        let records = Self::files_of_records(text, origin, replaced, &files)?;
        Self::holding(text, origin, &files, records)
    }

    /// The same for several runs, each with values replaced. A run whose values or files cannot be read adds no file: it is refused where it is read.
    ///
    /// # Errors
    /// [`SceneError`] for files that are included and cannot be read, and what is no TOML.
    pub fn whole_text_of(
        text: &str,
        origin: &str,
        runs: &[Vec<(String, String)>],
    ) -> Result<String, SceneError> {
        let files = includes::read(text, origin)?;
        let each = runs.iter().map(|replaced| Self::files_of_records(text, origin, replaced, &files));
        let records = each.flatten().flatten().collect();
        Self::holding(text, origin, &files, records)
    }

    /// Texts of the files that records name once values are replaced, but for those that the scene holds.
    fn files_of_records(
        text: &str,
        origin: &str,
        replaced: &[(String, String)],
        files: &[Included],
    ) -> Result<BTreeMap<String, String>, SceneError> {
        let source = Self::texts(text, origin, replaced, files);
        let whole = source.text();
        let mut table = DeTable::parse(&whole[..text.len()]).map_err(|e| source.refusal(&e))?;
        includes::merge(table.get_mut(), &whole, files, &source)?;
        overrides::apply(table.get_mut(), &whole, text.len(), replaced, &source)?;
        records::files_of(table.get_ref(), &source)
    }

    /// The text with all that it includes and texts of files that records name.
    fn holding(
        text: &str,
        origin: &str,
        files: &[Included],
        records: BTreeMap<String, String>,
    ) -> Result<String, SceneError> {
        let source = Self::texts(text, origin, &[], files);
        let whole = source.text();
        let mut table = DeTable::parse(&whole[..text.len()]).map_err(|e| source.refusal(&e))?;
        includes::merge(table.get_mut(), &whole, files, &source)?;
        let alone = files.is_empty() && !records::holds_files(table.get_ref());
        if alone || records.is_empty() && files.is_empty() {
            return Ok(if records.is_empty() {
                text.into()
            } else {
                text.to_string() + &records::written(&records)
            });
        }
        records::keep(table.get_mut(), records);
        let names: Vec<&str> = files.iter().map(|file| file.origin.as_str()).collect();
        let head = match names.is_empty() {
            true => String::new(),
            false => format!("# {origin} with what it includes: {}\n", names.join(", ")),
        };
        Ok(head.replace(char::is_control, " ").trim_end().to_string()
            + "\n"
            + &includes::written(table.get_ref()))
    }

    /// All texts one after another: the scene, the values that are replaced, files.
    fn texts(text: &str, origin: &str, replaced: &[(String, String)], files: &[Included]) -> Source {
        let mut whole = overrides::shown(text, replaced);
        let mut starts = Vec::with_capacity(files.len());
        for file in files {
            whole.push('\n');
            starts.push((whole.len(), &file.origin));
            whole.push_str(&file.text);
        }
        let mut source = Source::new(origin, &whole);
        starts.into_iter().for_each(|(start, file)| source.includes(start, file));
        source
    }

    /// Reads a scene from its document and what goes into it.
    fn merged(
        whole: &str,
        length: usize,
        replaced: &[(String, String)],
        files: &[Included],
        mut source: Source,
    ) -> Result<Checked, SceneError> {
        let mut table = DeTable::parse(&whole[..length]).map_err(|e| source.refusal(&e))?;
        includes::merge(table.get_mut(), whole, files, &source)?;
        parameters::refuse_unknown(table.get_ref(), replaced, &source)?;
        overrides::apply(table.get_mut(), whole, length, replaced, &source)?;
        source.index(table.get_ref())?;
        let values = parameters::values(table.get_ref(), &source)?;
        Self::of(table, source, &values)
    }

    /// The scene of a document whose places are known, with the values of its expressions.
    fn of<'i>(
        mut document: Spanned<DeTable<'i>>,
        mut source: Source,
        values: &'i Values,
    ) -> Result<Checked, SceneError> {
        parameters::put(document.get_mut(), values);
        let tables = records::read(document.get_ref(), &source)?;
        let mut document = document;
        records::put(document.get_mut(), &tables, &mut source);
        lists::unite(document.get_mut(), &mut source)?;
        tables::refuse_lists(document.get_ref(), &source)?;
        forms::lengthen(&mut document, &source)?;
        let mut scene =
            Self::deserialize(toml::de::Deserializer::from(document)).map_err(|e| source.refusal(&e))?;
        scene.source = source;
        scene.drop_body_names();
        scene.check()
    }
}
