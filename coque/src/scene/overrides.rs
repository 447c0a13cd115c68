//! Values of a scene replaced from the command line (`--set path.to.key=value`) before it is read.

use std::borrow::Cow;
use std::ops::Range;

use toml::Spanned;
use toml::de::{DeArray, DeTable, DeValue};

use super::error::{Fault, SceneError};
use super::source::Source;

/// Tables that hold one of several alternatives: naming another one drops the first.
const ALTERNATIVES: [&str; 5] = ["geometry", "material", "section", "formulation", "analysis"];

/// Keys of such tables that stand beside the one of several, and neither drop it nor go with it.
const BESIDE: [&str; 1] = ["cut_outs"];

/// In place of the number of an item: one more, behind the last.
const APPENDED: &str = "+";

/// Keys in the longest sensible path; bounds the recursion below.
const DEEPEST: usize = 16;

/// The text with the overrides as lines at its end, so that errors can point at them.
pub(crate) fn shown(text: &str, replaced: &[(String, String)]) -> String {
    let mut shown = text.to_string();
    for (path, value) in replaced {
        shown.push_str(&format!("\n--set {path}={value}"));
    }
    shown
}

/// Puts every override into the document; `start` is where the lines of [`shown`] begin.
pub(crate) fn apply<'i>(
    table: &mut DeTable<'i>,
    whole: &'i str,
    start: usize,
    replaced: &[(String, String)],
    source: &Source,
) -> Result<(), SceneError> {
    let mut at = start;
    for (path, value) in replaced {
        let key = at + "\n--set ".len();
        let value_start = key + path.len() + 1;
        at = value_start + value.len();
        let line = Line { path, key: key..key + path.len(), source };
        let parsed = parse(&whole[value_start..at], value_start, &line)?;
        let keys = line.split()?;
        insert(table, &keys, parsed, &line)?;
    }
    Ok(())
}

/// One override and where it stands.
struct Line<'a> {
    path: &'a str,
    key: Range<usize>,
    source: &'a Source,
}

impl Line<'_> {
    fn refuse(&self, why: &str, repair: &str, span: Range<usize>) -> SceneError {
        let mut fault: Box<Fault> = self.source.fault(self.path, why, "path.to.key=value", repair);
        fault.place.span = Some(span);
        SceneError::Override(fault)
    }

    /// Keys of a path: `a.b[0].c` and `a.b.0.c` are the same.
    fn split(&self) -> Result<Vec<String>, SceneError> {
        let path = self.path.replace('[', ".").replace(']', "");
        let keys: Vec<String> = path.split('.').map(|key| key.trim().to_string()).collect();
        if keys.iter().any(String::is_empty) {
            let repair = "write --set path.to.key=value";
            return Err(self.refuse("the path has an empty key", repair, self.key.clone()));
        }
        if keys.len() > DEEPEST {
            let why =
                format!("the path has {} keys; no value of a scene lies deeper than {DEEPEST}", keys.len());
            return Err(self.refuse(&why, "shorten the path", self.key.clone()));
        }
        Ok(keys)
    }
}

/// Reads a value and moves its positions to where it stands in the whole text; a bare word is a string.
fn parse<'i>(text: &'i str, start: usize, line: &Line<'_>) -> Result<Spanned<DeValue<'i>>, SceneError> {
    let word = |c: char| c.is_alphanumeric() || "-_".contains(c);
    match DeValue::parse(text) {
        Ok(value) => Ok(moved(value, start)),
        Err(_) if !text.is_empty() && text.starts_with(char::is_alphabetic) && text.chars().all(word) => {
            Ok(Spanned::new(start..start + text.len(), DeValue::String(Cow::Borrowed(text))))
        }
        Err(error) => {
            let repair = "a value is TOML: 1.5, \"word\", [1, 2], { key = 1 }";
            if text.is_empty() {
                return Err(line.refuse("there is no value after `=`", repair, line.key.clone()));
            }
            let span = error.span().unwrap_or(0..text.len());
            Err(line.refuse(error.message(), repair, span.start + start..span.end + start))
        }
    }
}

/// A value that stands so many bytes further on in a whole text.
pub(super) fn moved(value: Spanned<DeValue<'_>>, by: usize) -> Spanned<DeValue<'_>> {
    let span = value.span().start + by..value.span().end + by;
    let value = match value.into_inner() {
        DeValue::Table(table) => DeValue::Table(
            table
                .into_iter()
                .map(|(key, value)| {
                    let key_span = key.span().start + by..key.span().end + by;
                    (Spanned::new(key_span, key.into_inner()), moved(value, by))
                })
                .collect(),
        ),
        DeValue::Array(array) => {
            DeValue::Array(array.into_iter().map(|item| moved(item, by)).collect::<DeArray<'_>>())
        }
        other => other,
    };
    Spanned::new(span, value)
}

/// Drops the alternatives of a table under one of this name that gives another.
pub(super) fn takes_over(key: &str, own: &DeTable<'_>, under: &mut DeTable<'_>) {
    let beside = |word: &str| BESIDE.contains(&word);
    let words: Vec<&str> = own.keys().map(|word| &**word.get_ref()).filter(|word| !beside(word)).collect();
    if ALTERNATIVES.contains(&key) && !words.is_empty() {
        let kept = |word: &str| beside(word) || words.contains(&word);
        *under = std::mem::take(under).into_iter().filter(|(word, _)| kept(word.get_ref())).collect();
    }
}

fn insert<'i>(
    table: &mut DeTable<'i>,
    keys: &[String],
    value: Spanned<DeValue<'i>>,
    line: &Line<'_>,
) -> Result<(), SceneError> {
    let (Some(key), rest) = (keys.first(), keys.get(1..).unwrap_or_default()) else { return Ok(()) };
    let name = Spanned::new(line.key.clone(), Cow::Owned(key.clone()));
    if rest.is_empty() {
        table.remove(&name);
        table.insert(name, value);
        return Ok(());
    }
    if !table.contains_key(&name) {
        let empty = match rest[0] == APPENDED {
            true => DeValue::Array(DeArray::new()),
            false => DeValue::Table(DeTable::new()),
        };
        table.insert(name.clone(), Spanned::new(line.key.clone(), empty));
    }
    match table.get_mut(&name).map(Spanned::get_mut) {
        Some(DeValue::Table(inner)) => {
            let beside = |word: &str| BESIDE.contains(&word);
            if ALTERNATIVES.contains(&key.as_str()) && !beside(&rest[0]) {
                *inner = std::mem::take(inner)
                    .into_iter()
                    .filter(|(word, _)| **word.get_ref() == rest[0] || beside(word.get_ref()))
                    .collect();
            }
            insert(inner, rest, value, line)
        }
        Some(DeValue::Array(array)) => insert_item(array, rest, value, line),
        _ => {
            let repair = format!("set `{key}` itself, or look up its path in the scene");
            Err(line.refuse(
                &format!("`{key}` is a single value with nothing below it"),
                &repair,
                line.key.clone(),
            ))
        }
    }
}

fn insert_item<'i>(
    array: &mut DeArray<'i>,
    keys: &[String],
    value: Spanned<DeValue<'i>>,
    line: &Line<'_>,
) -> Result<(), SceneError> {
    let count = array.len();
    if keys[0] == APPENDED && keys.len() == 1 {
        array.push(value);
        return Ok(());
    }
    let item = keys[0].parse::<usize>().ok().and_then(|i| array.get_mut(i));
    let Some(item) = item else {
        let bound = format!("a list of {count} has no item `{}`", keys[0]);
        let repair =
            "items are numbered from 0, as in loads[0].couple.moment; loads[+]={ … } appends a whole one";
        return Err(line.refuse(&bound, repair, line.key.clone()));
    };
    if keys.len() == 1 {
        *item = value;
        return Ok(());
    }
    match item.get_mut() {
        DeValue::Table(inner) => insert(inner, &keys[1..], value, line),
        DeValue::Array(inner) => insert_item(inner, &keys[1..], value, line),
        _ => Err(line.refuse("nothing lies below a single value", "shorten the path", line.key.clone())),
    }
}
