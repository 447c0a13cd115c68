//! Whose set a name is, in a scene of several bodies.

use super::error::SceneError;
use super::problem::Scene;
use super::source::suggest;

/// Whose set a name is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Owner<'a> {
    /// All of every body.
    Every,
    /// A set of one body, by the names of both.
    Of(&'a str, &'a str),
}

impl<'a> Owner<'a> {
    /// Whose set the name at `path` is: `body.set`, `all`, or a declared set that says `of` whom.
    ///
    /// # Errors
    /// [`SceneError::Set`] for a name that names no body.
    pub(crate) fn of(scene: &'a Scene, path: &str, on: &'a str) -> Result<Self, SceneError> {
        if let Some((only, _)) = scene.bodies.first_key_value().filter(|_| scene.bodies.len() == 1) {
            return Ok(Self::Of(only, on));
        }
        if on == "all" {
            return Ok(Self::Every);
        }
        if let Some(of) = scene.sets.get(on).and_then(|region| scene.owner_of(region)) {
            return Ok(Self::Of(of, on));
        }
        match on.split_once('.') {
            Some((body, set)) if scene.bodies.contains_key(body) => Ok(Self::Of(body, set)),
            _ => {
                let every = scene.bodies.keys().map(|name| format!("{name}.all"));
                let is_list = |name: &&String| scene.source.is_called(&format!("sets.{name}"));
                let declared = scene.sets.keys().filter(|name| !is_list(name));
                let known: Vec<String> = every.chain(declared.cloned()).collect();
                let repair = suggest(on, &known.iter().map(String::as_str).collect::<Vec<_>>());
                let bound =
                    "which names no set of any body: a set of one of several bodies is written body.set";
                Err(SceneError::Set(scene.source.fault(path, &format!("\"{on}\""), bound, &repair)))
            }
        }
    }
}
