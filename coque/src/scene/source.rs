//! The text of a scene with the place of every key and value: what errors point at.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::absent::{Absent, absent};
use super::bounded::MARK;
use super::error::{Fault, Place, SceneError};
use super::nearest::nearest;

/// Table of the bodies, in the long form of a scene.
pub(super) const BODIES: &str = "bodies";

/// Where a key and its value stand.
#[derive(Clone, Debug)]
struct Entry {
    key: Range<usize>,
    value: Range<usize>,
}

/// A scene's text, its name, and where everything in it stands.
///
/// Checks speak of values by their path (`loads[0].couple.moment`), so the data of a scene stay plain.
#[derive(Clone, Debug)]
pub struct Source {
    origin: Arc<str>,
    text: Arc<str>,
    entries: BTreeMap<String, Entry>,
    /// Paths of what the scene does not write, each with that of what it is written as.
    called: BTreeMap<String, String>,
    /// Where the texts of files that are included begin in the whole one, each with its file.
    files: Vec<(usize, Arc<str>)>,
}

impl Source {
    /// A text of which nothing is known yet.
    pub(crate) fn new(origin: &str, text: &str) -> Self {
        Self {
            origin: origin.into(),
            text: text.into(),
            entries: BTreeMap::new(),
            called: BTreeMap::new(),
            files: Vec::new(),
        }
    }

    /// No text at all.
    pub(crate) fn none() -> Self {
        Self::new("", "")
    }

    /// Notes that the text of a file begins so many bytes on: one behind the text before it.
    pub(super) fn includes(&mut self, start: usize, file: &str) {
        self.files.push((start, file.into()));
    }

    /// Notes the place of everything in a document; refuses numbers that are not finite.
    pub(crate) fn index(&mut self, table: &DeTable<'_>) -> Result<(), SceneError> {
        self.walk_table("", table)
    }

    fn walk_table(&mut self, path: &str, table: &DeTable<'_>) -> Result<(), SceneError> {
        for (key, value) in table {
            let name = key.get_ref();
            let path = if path.is_empty() { name.to_string() } else { format!("{path}.{name}") };
            self.visit(path, key.span(), value)?;
        }
        Ok(())
    }

    fn visit(
        &mut self,
        path: String,
        key: Range<usize>,
        value: &Spanned<DeValue<'_>>,
    ) -> Result<(), SceneError> {
        self.entries.insert(path.clone(), Entry { key, value: value.span() });
        match value.get_ref() {
            DeValue::Table(table) => self.walk_table(&path, table),
            DeValue::Array(array) => {
                for (i, item) in array.iter().enumerate() {
                    self.visit(format!("{path}[{i}]"), item.span(), item)?;
                }
                Ok(())
            }
            DeValue::Float(x) if !x.as_str().parse::<f64>().is_ok_and(f64::is_finite) => {
                Err(self.value(&path, x.as_str(), "a finite number", "write a number such as 1.5e3"))
            }
            _ => Ok(()),
        }
    }

    /// Notes that what would stand at a path is written at another.
    pub(super) fn calls(&mut self, path: &str, written: &str) {
        self.called.insert(path.into(), written.into());
    }

    /// Whether what would stand at a path is written at another.
    pub(super) fn is_called(&self, path: &str) -> bool {
        self.called.contains_key(path)
    }

    /// Where in the scene it is written what stands at a path.
    fn written<'a>(&self, path: &'a str) -> Cow<'a, str> {
        let list = path.strip_suffix(']').and_then(|path| path.rsplit_once('['));
        match (self.called.get(path), list) {
            (Some(written), _) => Cow::Owned(written.clone()),
            (None, Some((above, item))) => match self.called.get(above) {
                Some(written) => Cow::Owned(format!("{written}[{item}]")),
                None => Cow::Borrowed(path),
            },
            _ => Cow::Borrowed(path),
        }
    }

    /// The bytes of a part of a text value whose token stands at `span`; of one written with escapes those of the whole.
    pub(super) fn within(&self, span: &Range<usize>, value: &str, part: &Range<usize>) -> Range<usize> {
        let token = &self.text[span.clone()];
        let quoted = token.get(1..).is_some_and(|rest| rest.starts_with(value));
        let quote = match quoted && token.len() == value.len() + 2 {
            true => 1,
            false if token == value => 0,
            false => return span.clone(),
        };
        span.start + quote + part.start..span.start + quote + part.end
    }

    /// Whether something stands at a path.
    pub(crate) fn has(&self, path: &str) -> bool {
        self.entries.contains_key(path)
    }

    /// Name of the text.
    pub(crate) fn origin(&self) -> &str {
        &self.origin
    }

    /// The text as a whole.
    pub(crate) fn text(&self) -> Arc<str> {
        self.text.clone()
    }

    /// Place of a value, or of the nearest table above it that is written down.
    fn place(&self, path: &str) -> Place {
        let mut path = path;
        let span = loop {
            if let Some(entry) = self.entries.get(path) {
                break Some(entry.value.clone());
            }
            match path.rfind(['.', '[']) {
                Some(cut) => path = &path[..cut],
                None => break None,
            }
        };
        self.at(span)
    }

    /// A place in the text.
    pub(super) fn at(&self, span: Option<Range<usize>>) -> Place {
        let Some((first, _)) = self.files.first() else {
            return Place { origin: self.origin.clone(), text: self.text.clone(), span };
        };
        let begins = |span: &Range<usize>| self.files.iter().rposition(|(start, _)| *start <= span.start);
        let Some((number, span)) = span.as_ref().and_then(|span| Some((begins(span)?, span))) else {
            return Place { origin: self.origin.clone(), text: self.text[..first - 1].into(), span };
        };
        let (start, file) = &self.files[number];
        let end = self.files.get(number + 1).map_or(self.text.len(), |(next, _)| next - 1);
        let span = Some(span.start - start..span.end.min(end) - start);
        Place { origin: file.clone(), text: self.text[*start..end].into(), span }
    }

    /// Everything that a refusal of the value at `path` carries.
    pub(crate) fn fault(&self, path: &str, value: &str, bound: &str, repair: &str) -> Box<Fault> {
        let path = self.written(path);
        let place = self.place(&path);
        Box::new(Fault {
            key: path.into(),
            value: value.into(),
            bound: bound.into(),
            repair: repair.into(),
            place,
        })
    }

    /// Refusal of a value.
    pub(crate) fn value(&self, path: &str, value: impl ToString, bound: &str, repair: &str) -> SceneError {
        SceneError::Value(self.fault(path, &value.to_string(), bound, repair))
    }

    /// Turns what the TOML reader says into a refusal with a repair.
    pub(crate) fn refusal(&self, error: &toml::de::Error) -> SceneError {
        let message = error.message();
        // What the scene as a whole lacks has an empty span at its beginning, where any key may stand.
        let missing = message.starts_with("missing field");
        let span = error.span().filter(|span| !(missing && span.is_empty()));
        // A span over the whole text says nothing.
        let place = self.at(span.clone().filter(|span| span.len() < self.text.trim().len()));
        let key = span.and_then(|span| self.path_at(&span)).unwrap_or_default();
        let parent = key.rsplit_once('.').map_or("", |(parent, _)| parent).to_string();
        let mut quoted = message.split('`').skip(1).step_by(2);
        let word = quoted.next().unwrap_or_default().to_string();
        let known: Vec<&str> = quoted.collect();
        let fault = |key: String, value: String, bound: String, repair: String| {
            Box::new(Fault { key, value, bound, repair, place: place.clone() })
        };
        if message.starts_with("unknown") {
            let table = if key.ends_with(&word) { parent } else { key };
            let kind = match message.starts_with("unknown field") {
                true => SceneError::UnknownKey,
                false => SceneError::UnknownWord,
            };
            unknown(&word, &table, &known, place.clone(), kind)
        } else if missing {
            let path = if key.is_empty() { word.clone() } else { format!("{key}.{word}") };
            let repair = format!("add `{word} = …`{}", within(&key));
            SceneError::Missing(fault(path, "nothing".into(), "given: it has no default".into(), repair))
        } else if message.starts_with("wanted exactly 1 element") {
            let bound = "exactly one table".to_string();
            let repair = match key.starts_with(BODIES) && key.matches('.').count() == 1 {
                true => format!("a body is of one kind, as in [{key}.shell]"),
                false => "keep one of the alternatives, such as [material.elastic]".to_string(),
            };
            SceneError::Choice(fault(key, "none or several tables".into(), bound, repair))
        } else if let [_, value, bound, repair] = Vec::from_iter(message.split(MARK))[..] {
            SceneError::Value(fault(key, value.into(), bound.into(), repair.into()))
        } else if let Some((found, expected)) = mismatch(message) {
            let repair = format!("write {expected} here");
            SceneError::Type(fault(key, found, expected, repair))
        } else {
            let repair = "compare with a file in scenes/, or see `coque run --help`".to_string();
            SceneError::Syntax(fault(key, message.replace('\n', " "), "TOML".into(), repair))
        }
    }

    /// Path of the smallest key or value that covers a span.
    fn path_at(&self, span: &Range<usize>) -> Option<String> {
        let covers = |r: &Range<usize>| r.start <= span.start && span.end <= r.end && r.start < r.end;
        let size = |entry: &Entry| {
            let covering = [&entry.key, &entry.value].into_iter().filter(|r| covers(r));
            covering.map(|r| r.end - r.start).min()
        };
        self.entries
            .iter()
            .filter_map(|(path, entry)| size(entry).map(|size| (size, path)))
            .min_by_key(|(size, path)| (*size, std::cmp::Reverse(path.len())))
            .map(|(_, path)| path.clone())
    }
}

/// What was found and what was expected, in words, from a message of the reader about types.
fn mismatch(message: &str) -> Option<(String, String)> {
    let rest = ["invalid type: ", "invalid value: ", "invalid length "]
        .iter()
        .find_map(|m| message.strip_prefix(m))?;
    let (found, expected) = rest.split_once(", expected ")?;
    let expected = match expected {
        "f64" => "a number",
        "usize" | "u64" => "a whole number, zero or more",
        "a string" => "a text in quotes",
        "a boolean" => "true or false",
        other if other.starts_with("struct ") || other.contains(" enum ") => "a table",
        other => other,
    };
    Some((found.into(), expected.into()))
}

fn within(key: &str) -> String {
    if key.is_empty() { " at the top of the scene".into() } else { format!(" in `{key}`") }
}

/// Refusal of a word that the table at `path` does not know: of the kind given, unless it names a feature that is missing.
pub(super) fn unknown(
    word: &str,
    path: &str,
    known: &[&str],
    place: Place,
    kind: fn(Box<Fault>) -> SceneError,
) -> SceneError {
    let bound = format!("one of {}", known.join(", "));
    let fault =
        |value: &str, repair| Box::new(Fault { key: path.into(), value: value.into(), bound, repair, place });
    match absent(word, path, known) {
        Some(Absent::NotYet { feature, nearest }) => {
            SceneError::NotYet(fault(feature, format!("nearest is {nearest}")))
        }
        Some(Absent::Instead(repair)) => kind(fault(word, repair.into())),
        None if known.is_empty() => {
            kind(fault(word, "remove it: this table is empty, as in `clamped = {}`".into()))
        }
        None => kind(fault(word, suggest(word, known))),
    }
}

/// "did you mean …?" with the list of what is known.
pub(crate) fn suggest(word: &str, known: &[&str]) -> String {
    let list = known.join(", ");
    match nearest(word, known.iter().copied()) {
        Some(near) => format!("did you mean `{near}`? known here: {list}"),
        None => format!("known here: {list}"),
    }
}
