//! Lists of sets where a support, a load, a spring or a column takes one: short for a declared union of them.

use std::borrow::Cow;
use std::collections::BTreeSet;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::error::{SceneError, Verdict};
use super::source::{BODIES, Source};

/// Lists of tables whose `on` may be a list of names.
const LISTS: [&str; 4] = ["supports", "loads", "curve", "heat"];

/// Declares the union of each list of sets in a document, and puts its name in place of the list.
///
/// # Errors
/// [`SceneError::Type`] for a list that has no names or others than texts, [`SceneError::Set`] where the name of the union is taken.
pub(super) fn unite(document: &mut DeTable<'_>, source: &mut Source) -> Verdict {
    let lone = lone(document);
    let lone = lone.as_deref();
    let mut found = Vec::new();
    for list in LISTS {
        let Some(DeValue::Array(items)) = document.get_mut(list).map(Spanned::get_mut) else { continue };
        for (i, item) in items.iter_mut().enumerate() {
            let DeValue::Table(item) = item.get_mut() else { continue };
            found.extend(named(item, "on", &format!("{list}[{i}].on"), lone, source)?);
            if let Some(DeValue::Table(spring)) = item.get_mut("spring").map(Spanned::get_mut) {
                found.extend(named(spring, "to", &format!("{list}[{i}].spring.to"), lone, source)?);
            }
        }
    }
    if found.is_empty() {
        return Ok(());
    }
    if !document.contains_key("sets") {
        let span = found[0].names.span();
        let key = Spanned::new(span.clone(), Cow::Borrowed("sets"));
        document.insert(key, Spanned::new(span, DeValue::Table(DeTable::new())));
    }
    let Some(DeValue::Table(sets)) = document.get_mut("sets").map(Spanned::get_mut) else { return Ok(()) };
    let own: BTreeSet<String> = sets.keys().map(|key| key.get_ref().to_string()).collect();
    for List { name, names, path } in found {
        if own.contains(&name) {
            let bound = "but there is a set of that name: it is what this list is called";
            let fault = source.fault(&path, &format!("\"{name}\""), bound, "give that set another name");
            return Err(SceneError::Set(fault));
        }
        let span = names.span();
        source.calls(&format!("sets.{name}"), &path);
        source.calls(&format!("sets.{name}.union"), &path);
        let key = |word| Spanned::new(span.clone(), word);
        let region = DeTable::from_iter([(key(Cow::Borrowed("union")), names)]);
        sets.insert(key(Cow::Owned(name)), Spanned::new(span.clone(), DeValue::Table(region)));
    }
    Ok(())
}

/// The one body of a document, whose sets may be named with it or without.
fn lone(document: &DeTable<'_>) -> Option<String> {
    let DeValue::Table(bodies) = document.get(BODIES)?.get_ref() else { return None };
    let mut names = bodies.keys().map(|name| name.get_ref().to_string());
    names.next().filter(|_| names.next().is_none())
}

/// A list of sets.
struct List<'i> {
    /// What their union is called.
    name: String,
    names: Spanned<DeValue<'i>>,
    /// Where it stands.
    path: String,
}

/// Takes the list at a key of a table, and leaves its name there; none where there is no list.
fn named<'i>(
    table: &mut DeTable<'i>,
    key: &str,
    path: &str,
    lone: Option<&str>,
    source: &Source,
) -> Result<Option<List<'i>>, SceneError> {
    let Some(given) = table.get_mut(key) else { return Ok(None) };
    let DeValue::Array(items) = given.get_ref() else { return Ok(None) };
    let bound = "the name of a set, or a list of names";
    if items.is_empty() {
        return Err(SceneError::Type(source.fault(path, "a list without names", bound, "name a set here")));
    }
    let mut words = Vec::with_capacity(items.len());
    for (i, item) in items.iter().enumerate() {
        let DeValue::String(word) = item.get_ref() else {
            let fault =
                source.fault(&format!("{path}[{i}]"), "no text", "the name of a set", "write it in quotes");
            return Err(SceneError::Type(fault));
        };
        words.push(word.to_string());
    }
    let own =
        |word: &String| lone.and_then(|body| word.strip_prefix(body)?.strip_prefix('.').map(str::to_string));
    let short: Vec<String> = words.iter().map(|word| own(word).unwrap_or_else(|| word.clone())).collect();
    let name = short.join(", ");
    let list = std::mem::replace(given.get_mut(), DeValue::String(Cow::Owned(name.clone())));
    // One name alone is that set.
    let several = words.len() > 1;
    Ok(several.then(|| List { name, names: Spanned::new(given.span(), list), path: path.into() }))
}
