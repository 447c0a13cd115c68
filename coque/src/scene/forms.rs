//! The two forms of a scene: a lone shell whose keys stand at the top, and bodies by name.

use std::borrow::Cow;
use std::ops::Range;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::error::SceneError;
use super::shell::ShellScene;
use super::source::{BODIES, Source, unknown};

/// All keys at the top of a scene, in either form.
fn words() -> Vec<&'static str> {
    let others = [
        BODIES, "sets", "supports", "loads", "heat", "contact", "glue", "links", "joints", "analysis",
        "coupling", "curve", "output", "error",
    ];
    [&["title", "units", "include", "parameters", "files"], &ShellScene::WORDS[..], &others].concat()
}

/// Name and kind of the body that the short form means.
const SHELL: &str = "shell";

/// Puts the keys of a shell that stand at the top of a document into `bodies.shell.shell`; their places stay.
///
/// # Errors
/// [`SceneError::UnknownKey`] or [`SceneError::NotYet`] for a key that neither form has, [`SceneError::Choice`] for one of a shell beside `bodies`.
pub(super) fn lengthen(document: &mut Spanned<DeTable<'_>>, source: &Source) -> Result<(), SceneError> {
    let span = document.span();
    let top = document.get_mut();
    let words = words();
    if let Some((key, _)) = top.iter().find(|(key, _)| !words.contains(&&**key.get_ref())) {
        let place = source.at(Some(key.span()));
        return Err(unknown(key.get_ref(), "", &words, place, SceneError::UnknownKey));
    }
    let mut shell = DeTable::new();
    for key in ShellScene::WORDS {
        if let Some((key, value)) = top.remove_entry(key) {
            shell.insert(key, value);
        }
    }
    let Some((key, _)) = shell.iter().next() else { return Ok(()) };
    if top.contains_key(BODIES) {
        let key = key.get_ref();
        let repair = format!("move it into the body, as in [bodies.NAME.shell.{key}], or remove [bodies]");
        let fault = source.fault(key, "a key of a lone shell", "none beside [bodies]", &repair);
        return Err(SceneError::Choice(fault));
    }
    let body = table(SHELL, shell, &span);
    let bodies = table(SHELL, body, &span);
    top.extend(table(BODIES, bodies, &span));
    Ok(())
}

/// A table with one table in it.
fn table<'i>(key: &'static str, inner: DeTable<'i>, span: &Range<usize>) -> DeTable<'i> {
    let key = Spanned::new(span.clone(), Cow::Borrowed(key));
    DeTable::from_iter([(key, Spanned::new(span.clone(), DeValue::Table(inner)))])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_keys_at_the_top_are_those_of_the_schema() {
        let schema = crate::scene::schema::schema();
        let mut words = words();
        words.sort_unstable();
        assert!(schema["properties"].as_object().unwrap().keys().eq(words));
    }
}
