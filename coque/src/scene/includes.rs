//! Files that a scene includes: `include = ["steel.toml"]` takes their tables, except where the scene has its own.

use std::borrow::Cow;
use std::path::{Path, PathBuf};

use mesh_io::read_text;
use toml::Spanned;
use toml::de::{DeArray, DeTable, DeValue};

use super::error::{SceneError, Verdict};
use super::overrides::{moved, takes_over};
use super::records;
use super::source::Source;

/// Key of the files.
const INCLUDE: &str = "include";

/// Key of a file beside the scene that it stands in.
const FILE: &str = "file";

/// Table whose tables are each one thing: that of the scene replaces that of a file.
const SETS: &str = "sets";

/// Files beyond which including is taken for a mistake.
const MOST: usize = 64;

/// A file that is included.
pub(super) struct Included {
    /// Its path, from where the command runs.
    pub origin: String,
    pub text: String,
    /// The way from the folder of the scene to its own.
    folder: PathBuf,
}

/// Files that are included, those that they include after them.
///
/// # Errors
/// [`SceneError`] for files that cannot be read, are no TOML or include each other in a circle; each stands in the file that names it.
pub(super) fn read(text: &str, origin: &str) -> Result<Vec<Included>, SceneError> {
    let mut found = Found { files: Vec::new(), open: vec![path_of(Path::new(origin))], known: Vec::new() };
    // What is no TOML is refused with the values that are replaced in it.
    if text.contains(INCLUDE)
        && let Ok(document) = DeTable::parse(text)
    {
        found.take(document.get_ref(), origin, text, Path::new(""))?;
    }
    Ok(found.files)
}

/// A path without ways round, so that a file is known again.
fn path_of(path: &Path) -> PathBuf {
    path.canonicalize().unwrap_or_else(|_| path.into())
}

/// Files found so far.
struct Found {
    files: Vec<Included>,
    /// The scene and the files on the way to the present one.
    open: Vec<PathBuf>,
    known: Vec<PathBuf>,
}

impl Found {
    /// Takes the files that a document includes.
    fn take(&mut self, document: &DeTable<'_>, origin: &str, text: &str, folder: &Path) -> Verdict {
        let Some(given) = document.get(INCLUDE) else { return Ok(()) };
        let mut source = Source::new(origin, text);
        source.index(document)?;
        let refuse = |path: &str, value: &str, bound: &str, repair: &str| {
            Err(SceneError::Choice(source.fault(path, value, bound, repair)))
        };
        let names = match given.get_ref() {
            DeValue::Array(names) => names,
            _ => return refuse(INCLUDE, "no list", "a list of files", "write include = [\"steel.toml\"]"),
        };
        for (i, name) in names.iter().enumerate() {
            let at = format!("{INCLUDE}[{i}]");
            let DeValue::String(name) = name.get_ref() else {
                return refuse(&at, "no text", "the name of a file", "write it in quotes");
            };
            let file = Path::new(origin).parent().unwrap_or(Path::new("")).join(&**name);
            let (path, shown) = (path_of(&file), file.display().to_string());
            if self.open.contains(&path) {
                let bound = "files that do not include themselves, by whatever way";
                return refuse(&at, &shown, bound, "take it out of one of the files");
            }
            // What two files include is there once.
            if self.known.contains(&path) {
                continue;
            }
            if self.files.len() >= MOST {
                return refuse(&at, "one file more", &format!("at most {MOST} files"), "join some of them");
            }
            let own = read_text(&file);
            let own = own.map_err(|error| {
                let repair = "name a TOML file by its path from the folder of the file that includes it";
                let bound = format!("a file that can be read: {error}");
                SceneError::Choice(source.fault(&at, &shown, &bound, repair))
            })?;
            let way = folder.join(Path::new(&**name).parent().unwrap_or(Path::new("")));
            self.known.push(path.clone());
            let document = DeTable::parse(&own).map_err(|error| Source::new(&shown, &own).refusal(&error))?;
            self.files.push(Included { origin: shown.clone(), text: own.clone(), folder: way.clone() });
            self.open.push(path);
            self.take(document.get_ref(), &shown, &own, &way)?;
            self.open.pop();
        }
        Ok(())
    }
}

/// Puts the tables of files under those of a document; `whole` holds the texts of files from these places on.
///
/// # Errors
/// [`SceneError`] for a file in other units than the scene.
pub(super) fn merge<'i>(
    document: &mut DeTable<'i>,
    whole: &'i str,
    files: &[Included],
    source: &Source,
) -> Verdict {
    let mut start = whole.len() - files.iter().map(|file| file.text.len() + 1).sum::<usize>();
    for file in files {
        start += 1;
        let text = &whole[start..start + file.text.len()];
        let parsed = DeTable::parse(text).map_err(|error| source.refusal(&error))?;
        let DeValue::Table(mut table) = moved(parsed_value(parsed), start).into_inner() else { continue };
        start += file.text.len();
        table.remove(INCLUDE);
        check_units(document, &table, source)?;
        table.iter_mut().for_each(|(key, value)| relocate(key.get_ref(), value, &file.folder));
        if file.folder != Path::new("") {
            records::relocate(&mut table, &file.folder);
        }
        under(document, table, "");
    }
    Ok(())
}

fn parsed_value(parsed: Spanned<DeTable<'_>>) -> Spanned<DeValue<'_>> {
    let span = parsed.span();
    Spanned::new(span, DeValue::Table(parsed.into_inner()))
}

/// Numbers of a file in other units would be wrong here.
fn check_units(document: &DeTable<'_>, table: &DeTable<'_>, source: &Source) -> Verdict {
    let (Some(own), Some(other)) = (document.get("units"), table.get("units")) else { return Ok(()) };
    let (DeValue::Table(known), DeValue::Table(given)) = (own.get_ref(), other.get_ref()) else {
        return Ok(());
    };
    let text = |value: &Spanned<DeValue<'_>>| value.get_ref().as_str().map(str::to_owned);
    if given.iter().all(|(key, value)| known.get(&**key.get_ref()).and_then(text) == text(value)) {
        return Ok(());
    }
    let mut fault = source.fault(
        "units",
        "other units in a file that is included",
        "the units of the scene",
        "write the file in the units of the scene, or take its units out if its numbers are in those",
    );
    fault.place = source.at(Some(other.span()));
    Err(SceneError::Choice(fault))
}

/// Names the files of an included one from the folder of the scene.
fn relocate(key: &str, value: &mut Spanned<DeValue<'_>>, folder: &Path) {
    match value.get_mut() {
        DeValue::String(file) if key == FILE && folder != Path::new("") => {
            *file = Cow::Owned(folder.join(&**file).to_string_lossy().into_owned());
        }
        DeValue::Table(table) => {
            table.iter_mut().for_each(|(key, value)| relocate(key.get_ref(), value, folder))
        }
        DeValue::Array(items) => items.iter_mut().for_each(|item| relocate("", item, folder)),
        _ => {}
    }
}

/// Puts a table under another, which keeps what it has; lists of tables come after its own.
fn under<'i>(own: &mut DeTable<'i>, mut other: DeTable<'i>, place: &str) {
    takes_over(place, own, &mut other);
    for (key, value) in other {
        let word = key.get_ref().to_string();
        match (own.get_mut(&*word).map(Spanned::get_mut), value.get_ref()) {
            (None, _) => {
                own.insert(key, value);
            }
            (Some(DeValue::Table(inner)), DeValue::Table(_)) if place != SETS => {
                if let DeValue::Table(table) = value.into_inner() {
                    under(inner, table, &word);
                }
            }
            (Some(DeValue::Array(items)), DeValue::Array(more)) if of_tables(items) && of_tables(more) => {
                if let DeValue::Array(more) = value.into_inner() {
                    more.into_iter().for_each(|item| items.push(item));
                }
            }
            _ => {}
        }
    }
}

fn of_tables(items: &DeArray<'_>) -> bool {
    items.iter().all(|item| matches!(item.get_ref(), DeValue::Table(_)))
}

/// A document as text: values as they are, one table a heading, without `include`.
pub(super) fn written(document: &DeTable<'_>) -> String {
    let (mut plain, mut tables) = (String::new(), String::new());
    for (key, value) in document.iter().filter(|(key, _)| key.get_ref() != INCLUDE) {
        let name = toml_edit::Key::new(&**key.get_ref());
        let name = name.display_repr();
        let lines = |table: &DeTable<'_>| -> String {
            table.iter().map(|pair| format!("{}\n", line(pair))).collect()
        };
        match value.get_ref() {
            DeValue::Table(table) => tables.push_str(&format!("\n[{name}]\n{}", lines(table))),
            DeValue::Array(items) if !items.is_empty() && of_tables(items) => {
                for item in items {
                    let DeValue::Table(table) = item.get_ref() else { continue };
                    tables.push_str(&format!("\n[[{name}]]\n{}", lines(table)));
                }
            }
            other => plain.push_str(&format!("{name} = {}\n", inline(other))),
        }
    }
    plain + &tables
}

fn line((key, value): (&Spanned<Cow<'_, str>>, &Spanned<DeValue<'_>>)) -> String {
    format!("{} = {}", toml_edit::Key::new(&**key.get_ref()).display_repr(), inline(value.get_ref()))
}

/// A value in one line.
fn inline(value: &DeValue<'_>) -> String {
    match value {
        DeValue::String(text) => toml_edit::Value::from(&**text).to_string(),
        DeValue::Integer(number) => number.to_string(),
        DeValue::Float(number) => number.as_str().into(),
        DeValue::Boolean(answer) => answer.to_string(),
        DeValue::Datetime(time) => time.to_string(),
        DeValue::Array(items) => {
            let items: Vec<String> = items.iter().map(|item| inline(item.get_ref())).collect();
            format!("[{}]", items.join(", "))
        }
        DeValue::Table(table) => {
            let pairs: Vec<String> = table.iter().map(line).collect();
            if pairs.is_empty() { "{}".into() } else { format!("{{ {} }}", pairs.join(", ")) }
        }
    }
}
