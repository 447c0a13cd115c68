//! What a reviewer should see of the quick set, held against what was reviewed; differences are drawn on a page.
//!
//! A snapshot records, it does not judge: see `tolerances.rs`.

use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

use validation::CaseResult;
use validation::review::{Change, Reviewed, page};

use crate::Faults;

/// The page of differences, from the folder of the crate.
const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../target/review");
const SNAPSHOTS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/quick/snapshots");

/// Cases that differ from their snapshots; each difference is printed, left as `.snap.new` beside the snapshot, and drawn.
pub fn changed(results: &[CaseResult]) -> Faults {
    let agrees = |result: &CaseResult| {
        let runs = result.runs.iter().zip(&result.records);
        let runs: Vec<Reviewed> = runs.map(|(run, record)| Reviewed::of(run, record)).collect();
        insta::with_settings!({ omit_expression => true, prepend_module_to_snapshot => false }, {
            insta::assert_json_snapshot!(result.case.name, runs);
        });
    };
    // A snapshot that differs panics: caught, so that one run shows them all.
    let differs = |result: &&CaseResult| catch_unwind(AssertUnwindSafe(|| agrees(result))).is_err();
    let changed: Vec<&CaseResult> = results.iter().filter(differs).collect();
    let mut faults: Faults =
        changed.iter().map(|result| format!("{}: see the difference above", result.case.name)).collect();
    match drawn(&changed) {
        Ok(None) => {}
        Ok(Some(file)) => faults.push(format!("all differences are drawn in {file}")),
        Err(error) => faults.push(format!("the differences could not be drawn: {error}")),
    }
    faults
}

/// Writes the page of some cases that changed; takes away that of an earlier run where none did.
fn drawn(changed: &[&CaseResult]) -> Result<Option<String>, String> {
    let folder = Path::new(FOLDER);
    let reported = |error: &dyn std::fmt::Display| error.to_string();
    if changed.is_empty() {
        return match fs::remove_dir_all(folder) {
            Err(error) if error.kind() != std::io::ErrorKind::NotFound => Err(reported(&error)),
            _ => Ok(None),
        };
    }
    let changes: Result<Vec<Change<'_>>, String> = changed.iter().map(|&result| change(result)).collect();
    let page = page(&changes?).map_err(|error| reported(&error))?;
    fs::create_dir_all(folder).map_err(|error| reported(&error))?;
    let file = folder.canonicalize().map_err(|error| reported(&error))?.join(page.file);
    fs::write(&file, page.html).map_err(|error| reported(&error))?;
    Ok(Some(file.display().to_string()))
}

/// A case with what was reviewed of it; nothing of a new one.
fn change(result: &CaseResult) -> Result<Change<'_>, String> {
    let file = format!("{SNAPSHOTS}/{}.snap", result.case.name);
    let stored = match fs::read_to_string(&file) {
        Ok(text) => Reviewed::stored(&text).map_err(|error| format!("{file}: {error}"))?,
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => Vec::new(),
        Err(error) => return Err(format!("{file}: {error}")),
    };
    Ok(Change { result, stored })
}
