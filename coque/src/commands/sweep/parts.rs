//! Parts of a sweep, run by as many jobs of a cluster into one folder, and the table of all.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::str::FromStr;

use serde::{Deserialize, Serialize};

use super::combinations::{Values, combinations};
use super::table::Row;
use crate::{read_text, write_whole};

/// One part of so many.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct Only {
    /// Which, from one on.
    part: usize,
    of: usize,
}

impl FromStr for Only {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let number = |text: &str| text.parse::<usize>().ok();
        let both = text.split_once('/').and_then(|(part, of)| Some((number(part)?, number(of)?)));
        match both {
            // Zero is the last: jobs are counted from zero or from one.
            Some((part, of)) if of > 0 && part <= of => {
                Ok(Self { part: if part == 0 { of } else { part }, of })
            }
            _ => {
                Err("write K/N, as 3/100: the third of a hundred parts, K from 0 to N - 1 or from 1 to N"
                    .into())
            }
        }
    }
}

impl Only {
    /// Whether a run belongs to it, counted from zero.
    pub fn has(self, run: usize) -> bool {
        (run + 1) % self.of == self.part % self.of
    }

    fn file(self) -> String {
        format!("part-{}-of-{}.json", self.part, self.of)
    }
}

/// A part: what was run, and what became of it.
#[derive(Serialize, Deserialize)]
pub(super) struct Part {
    pub only: Only,
    /// The scene.
    pub text: String,
    pub over: Values,
    pub replaced: Values,
    /// Its runs, counted from zero.
    pub rows: Vec<(usize, Row)>,
}

impl Part {
    /// Writes it into the folder of the sweep.
    pub fn write(&self, out: &Path) -> Result<PathBuf, String> {
        let file = out.join(self.only.file());
        let refused = |error: String| format!("cannot write {}: {error}\n", file.display());
        fs::create_dir_all(out).map_err(|error| refused(error.to_string()))?;
        let text = serde_json::to_string(self).map_err(|error| refused(error.to_string()))?;
        write_whole(&file, |to| to.write_all(text.as_bytes())).map_err(|error| refused(error.to_string()))?;
        Ok(file)
    }

    fn read(file: &Path) -> Result<Self, String> {
        let refused = |error: String| format!("cannot read {}: {error}\n", file.display());
        let text = read_text(file).map_err(|error| refused(error.to_string()))?;
        serde_json::from_str(&text).map_err(|error| refused(error.to_string()))
    }
}

/// Files of parts in a folder, in the order of their names.
fn files(out: &Path) -> Result<Vec<PathBuf>, String> {
    let entries = fs::read_dir(out).map_err(|e| format!("cannot read {}: {e}\n", out.display()))?;
    let is_part = |path: &PathBuf| {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        name.starts_with("part-") && name.ends_with(".json")
    };
    let mut files: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).filter(is_part).collect();
    files.sort();
    Ok(files)
}

/// Takes out what parts of an earlier sweep left.
pub(super) fn clear(out: &Path) -> Result<(), String> {
    files(out)?.iter().try_for_each(|file| {
        fs::remove_file(file).map_err(|e| format!("cannot remove {}: {e}\n", file.display()))
    })
}

/// What was swept over, its combinations, and what became of each.
pub(super) type Collected = (Values, Vec<Values>, Vec<Option<Row>>);

/// All parts of a folder as one sweep.
///
/// # Errors
/// A sentence for a folder without parts, parts of different sweeps, and parts that are missing.
pub(super) fn collect(out: &Path) -> Result<Collected, String> {
    let found = files(out)?;
    let parts = found.iter().map(|file| Part::read(file)).collect::<Result<Vec<_>, _>>()?;
    let shown = out.display();
    let Some(first) = parts.first() else {
        return Err(format!(
            "no parts of a sweep are in {shown}; make them by `coque sweep … --out {shown} --only K/N`\n"
        ));
    };
    let sweep = |part: &Part| (part.only.of, part.text.clone(), part.over.clone(), part.replaced.clone());
    if let Some((file, _)) = found.iter().zip(&parts).find(|(_, part)| sweep(part) != sweep(first)) {
        return Err(format!(
            "{} is a part of another sweep than {}: another scene, other values or another number of parts; take out what is old\n",
            file.display(),
            found[0].display()
        ));
    }
    let (of, over) = (first.only.of, first.over.clone());
    let missing: Vec<String> = (1..=of)
        .filter(|&part| parts.iter().all(|known| known.only.part != part))
        .map(|part| part.to_string())
        .collect();
    if !missing.is_empty() {
        return Err(format!(
            "of {of} parts in {shown} these are missing: {}; run them by --only, or wait for them\n",
            missing.join(", ")
        ));
    }
    let runs = combinations(&over)?;
    let mut rows: Vec<Option<Row>> = runs.iter().map(|_| None).collect();
    for (number, row) in parts.into_iter().flat_map(|part| part.rows) {
        if let Some(place) = rows.get_mut(number) {
            *place = Some(row);
        }
    }
    Ok((over, runs, rows))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every run belongs to one part of any number, whether parts are counted from zero or from one.
    #[test]
    fn parts_divide_all_runs() {
        for of in 1..=7 {
            for from in [0, 1] {
                let parts: Vec<Only> =
                    (from..of + from).map(|part| format!("{part}/{of}").parse().unwrap()).collect();
                for run in 0..20 {
                    assert_eq!(parts.iter().filter(|part| part.has(run)).count(), 1, "{of} {run}");
                }
            }
        }
        for wrong in ["", "3", "4/3", "1/0", "-1/3", "a/b"] {
            assert!(wrong.parse::<Only>().is_err(), "{wrong}");
        }
    }
}
