//! Courses in time from files: `amplitude = { record = { file = "quake.AT2" } }` becomes a table of the numbers before the scene is read.
//!
//! What a file holds is kept in the text of a scene under `[files]` ([`files_of`]): the copy beside results, checkpoints and parts of a sweep need
//! the file no more, and give the same bits.

mod at2;
mod baseline;
mod csv;
mod measures;

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::path::Path;

use mesh_io::read_text;
use serde::Deserialize;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use self::measures::Multiplied;
use super::error::{SceneError, Verdict};
use super::parameters::units;
use super::record::{Baseline, Record};
use super::source::Source;
use super::units::Units;

/// Key of a course that a file has.
const RECORD: &str = "record";
/// Key of courses.
const AMPLITUDE: &str = "amplitude";
/// Table of the texts of files.
const FILES: &str = "files";
/// What says by what a spectrum goes, and that it does so by frequency.
const BY: &str = "by";
const FREQUENCY: &str = "frequency";
/// What a record becomes.
const TABLE: &str = "table";

/// Points beyond which a record is taken for a mistake.
const MOST_POINTS: usize = 1_000_000;

/// Records of a document as tables in TOML, by where each stands.
pub(super) type Tables = BTreeMap<usize, String>;

/// Reads the records of a document.
///
/// # Errors
/// [`SceneError`] for files that cannot be read or hold no record, at the key that names them.
pub(super) fn read(document: &DeTable<'_>, source: &Source) -> Result<Tables, SceneError> {
    let mut tables = Tables::new();
    let units = units(document);
    walk("", document, false, &mut |path, (at, table), multiplied| {
        let record =
            Record::deserialize(toml::de::Deserializer::from(Spanned::new(at.clone(), table.clone())));
        let record = record.map_err(|error| source.refusal(&error))?;
        let text = text_of(document, &record.file, path, source)?;
        let points = points((&record, &text), (path, source), multiplied, units.as_ref())?;
        let list: Vec<String> = points.iter().map(|[t, x]| format!("[{t:?}, {x:?}]")).collect();
        tables.insert(at.start, format!("[{}]", list.join(", ")));
        Ok(())
    })?;
    Ok(tables)
}

/// Puts the tables where the records stand.
pub(super) fn put<'i>(document: &mut DeTable<'i>, tables: &'i Tables, source: &mut Source) {
    if !tables.is_empty() {
        put_below("", document, tables, source);
    }
}

fn put_below<'i>(path: &str, table: &mut DeTable<'i>, tables: &'i Tables, source: &mut Source) {
    for (key, value) in table.iter_mut() {
        let path = below(path, key.get_ref());
        put_in(&path, value, tables, source);
    }
}

fn put_in<'i>(path: &str, value: &mut Spanned<DeValue<'i>>, tables: &'i Tables, source: &mut Source) {
    match value.get_mut() {
        DeValue::Array(items) => {
            for (i, item) in items.iter_mut().enumerate() {
                put_in(&format!("{path}[{i}]"), item, tables, source);
            }
        }
        DeValue::Table(table) => {
            let found =
                table.get(RECORD).and_then(|record| Some((record.span(), tables.get(&record.span().start)?)));
            if let (true, Some((span, text))) = (is_amplitude(path), found)
                && let Ok(list) = DeValue::parse(text)
            {
                table.remove(RECORD);
                // Refusals point at the record.
                let list = Spanned::new(span.clone(), list.into_inner());
                table.insert(Spanned::new(span, Cow::Borrowed(TABLE)), list);
                source.calls(&format!("{path}.{TABLE}"), &format!("{path}.{RECORD}"));
            } else {
                put_below(path, table, tables, source);
            }
        }
        _ => {}
    }
}

/// The text of a scene with the files that its records name, to be read without them; none where it names none that it does not hold.
///
/// # Errors
/// [`SceneError`] for files that cannot be read.
pub(super) fn files_of(
    document: &DeTable<'_>,
    source: &Source,
) -> Result<BTreeMap<String, String>, SceneError> {
    let mut found = BTreeMap::new();
    walk("", document, false, &mut |path, (_, table), _| {
        let Some(DeValue::String(file)) = table.get("file").map(Spanned::get_ref) else { return Ok(()) };
        if kept(document, file).is_none() {
            found.insert(file.to_string(), text_of(document, file, path, source)?.into_owned());
        }
        Ok(())
    })?;
    Ok(found)
}

/// Those files as tables of TOML, behind a text that has none: `[files]` with a line each.
pub(super) fn written(files: &BTreeMap<String, String>) -> String {
    let line = |(name, text): (&String, &String)| {
        let name = toml_edit::Key::new(name);
        format!("{} = {}\n", name.display_repr(), toml_edit::Value::from(text.as_str()))
    };
    format!("\n[{FILES}]\n{}", files.iter().map(line).collect::<String>())
}

/// Puts texts of files into a document.
pub(super) fn keep(document: &mut DeTable<'_>, files: BTreeMap<String, String>) {
    let owned = |name: String| Spanned::new(0..0, Cow::Owned(name));
    if !files.is_empty() && !holds_files(document) {
        document.insert(owned(FILES.into()), Spanned::new(0..0, DeValue::Table(DeTable::new())));
    }
    if let Some(DeValue::Table(table)) = document.get_mut(FILES).map(Spanned::get_mut) {
        let texts = files.into_iter().map(|(name, text)| (owned(name), DeValue::String(Cow::Owned(text))));
        table.extend(texts.map(|(name, text)| (name, Spanned::new(0..0, text))));
    }
}

/// Names the files that a document holds from another folder.
pub(super) fn relocate(document: &mut DeTable<'_>, folder: &Path) {
    if let Some(DeValue::Table(files)) = document.get_mut(FILES).map(Spanned::get_mut) {
        let moved = |name: &Cow<'_, str>| folder.join(&**name).to_string_lossy().into_owned();
        *files = std::mem::take(files)
            .into_iter()
            .map(|(name, text)| (Spanned::new(name.span(), Cow::Owned(moved(name.get_ref()))), text))
            .collect();
    }
}

/// Whether a document holds texts of files.
pub(super) fn holds_files(document: &DeTable<'_>) -> bool {
    document.contains_key(FILES)
}

/// Hears of a record: the path of its key, where it stands and its table, what its course multiplies.
type Visit<'v, 'd> =
    &'v mut dyn FnMut(&str, (std::ops::Range<usize>, &'d DeTable<'d>), Multiplied) -> Verdict;

/// Visits every record of a document; a spectrum by frequency says so in its own table or in one about it.
fn walk<'d>(path: &str, table: &'d DeTable<'d>, by_frequency: bool, visit: Visit<'_, 'd>) -> Verdict {
    let by = table.get(BY).and_then(|by| by.get_ref().as_str());
    let by_frequency = by.map_or(by_frequency, |by| by == FREQUENCY);
    for (key, value) in table {
        let path_of_value = below(path, key.get_ref());
        if let (AMPLITUDE, DeValue::Table(course)) = (&**key.get_ref(), value.get_ref())
            && let Some(record) = course.get(RECORD)
            && let DeValue::Table(own) = record.get_ref()
        {
            let at = (record.span(), own);
            visit(&format!("{path_of_value}.{RECORD}"), at, Multiplied::beside(path, table, by_frequency))?;
            continue;
        }
        walk_in(&path_of_value, value, by_frequency, visit)?;
    }
    Ok(())
}

fn walk_in<'d>(
    path: &str,
    value: &'d Spanned<DeValue<'d>>,
    by_frequency: bool,
    visit: Visit<'_, 'd>,
) -> Verdict {
    match value.get_ref() {
        DeValue::Array(items) => {
            let mut items = items.iter().enumerate();
            items.try_for_each(|(i, item)| walk_in(&format!("{path}[{i}]"), item, by_frequency, visit))
        }
        DeValue::Table(table) => walk(path, table, by_frequency, visit),
        _ => Ok(()),
    }
}

fn below(path: &str, key: &str) -> String {
    if path.is_empty() { key.into() } else { format!("{path}.{key}") }
}

fn is_amplitude(path: &str) -> bool {
    path.rsplit('.').next() == Some(AMPLITUDE)
}

/// The text of a file that a document holds.
fn kept<'d>(document: &'d DeTable<'_>, file: &str) -> Option<&'d str> {
    let DeValue::Table(files) = document.get(FILES)?.get_ref() else { return None };
    files.get(file)?.get_ref().as_str()
}

/// The text of a file: as the document holds it, else from the disk.
fn text_of<'d>(
    document: &'d DeTable<'_>,
    file: &str,
    path: &str,
    source: &Source,
) -> Result<Cow<'d, str>, SceneError> {
    if let Some(text) = kept(document, file) {
        return Ok(text.into());
    }
    let place = Path::new(source.origin()).parent().unwrap_or(Path::new("")).join(file);
    read_text(&place).map(Cow::Owned).map_err(|error| {
        let bound = format!("a file that can be read: {error}");
        let repair = "name a record by its path from the folder of the scene, or hold its text in [files]";
        SceneError::Choice(source.fault(
            &format!("{path}.file"),
            &place.display().to_string(),
            &bound,
            repair,
        ))
    })
}

/// What a file says that is no record.
struct Misread {
    value: String,
    bound: String,
    repair: String,
    /// The key of the record that it concerns.
    key: &'static str,
}

impl Misread {
    fn new(
        key: &'static str,
        value: impl Into<String>,
        bound: impl Into<String>,
        repair: impl Into<String>,
    ) -> Self {
        Self { value: value.into(), bound: bound.into(), repair: repair.into(), key }
    }
}

/// The points of a record in the units of the scene, times ascending.
fn points(
    (record, text): (&Record, &str),
    (path, source): (&str, &Source),
    multiplied: Multiplied,
    own: Option<&Units>,
) -> Result<Vec<[f64; 2]>, SceneError> {
    course(record, text, multiplied, own).map_err(|misread| {
        let Misread { value, bound, repair, key } = misread;
        SceneError::Value(source.fault(&format!("{path}.{key}"), &value, &bound, &repair))
    })
}

/// The same, with what is no record as the file says it.
fn course(
    record: &Record,
    text: &str,
    multiplied: Multiplied,
    own: Option<&Units>,
) -> Result<Vec<[f64; 2]>, Misread> {
    let peer = record.file.to_ascii_lowercase().ends_with(".at2");
    let (mut points, read) = if peer {
        if record.columns.is_some() {
            let repair = "remove it: its times follow from DT";
            return Err(Misread::new("columns", "columns", "none of an .AT2", repair));
        }
        record.units.as_ref().map_or(Ok(()), measures::check_peer)?;
        (at2::read(text)?, Some(["s".to_string(), "g".to_string()]))
    } else {
        (csv::read(text, record.columns.as_ref())?, None)
    };
    if points.len() > MOST_POINTS {
        let bound = format!("at most {MOST_POINTS} points");
        return Err(Misread::new("file", format!("{} points", points.len()), bound, "take every second one"));
    }
    if let Some(units) = record.units.clone().or(read) {
        measures::convert(&mut points, &units, multiplied, own)?;
    }
    points.iter_mut().for_each(|[_, x]| *x *= record.factor);
    let straightened = record.baseline == Baseline::Linear;
    // What is accelerated is so no longer than the record.
    if peer || straightened {
        baseline::close(&mut points);
    }
    if straightened && baseline::straighten(&mut points).is_none() {
        let value = format!("\"linear\" of {} points", points.len());
        let bound = format!(
            "of {} or more, the zero at its end among them, and some time after zero",
            baseline::FEWEST
        );
        return Err(Misread::new("baseline", value, bound, "remove it, or give the whole record"));
    }
    Ok(points)
}
