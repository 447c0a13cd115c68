//! What the folder of a run says: its curve, its summary, and which row of the curve belongs to which frame.

use std::path::{Path, PathBuf};

use crate::{Curve, Extreme, listed, read_text};
use serde_json::Value;

/// Reads the curve.
pub fn read_curve(folder: &Path) -> Result<Curve, String> {
    let file = folder.join("curve.csv");
    let wrong = |error: &dyn std::fmt::Display| format!("cannot read {}: {error}\n", file.display());
    let text = read_text(&file).map_err(|e| wrong(&e))?;
    text.parse().map_err(|e| wrong(&e))
}

/// The summary; none while the run is under way, and of a run that was killed.
pub fn read_summary(folder: &Path) -> Option<Value> {
    serde_json::from_str(&read_text(&folder.join("summary.json")).ok()?).ok()
}

/// The title of the scene that ran into a folder; without a summary, the folder's name.
pub fn title(folder: &Path, summary: Option<&Value>) -> String {
    let name = || folder.file_name().unwrap_or(folder.as_os_str()).to_string_lossy().into_owned();
    summary.and_then(|summary| summary["title"].as_str()).map_or_else(name, String::from)
}

/// All lists of frames of a folder, by name.
pub fn frame_lists(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder.join("fields")).into_iter().flatten().flatten();
    let mut all: Vec<PathBuf> = entries
        .map(|entry| entry.path())
        .filter(|path| path.extension().is_some_and(|ending| ending == "pvd"))
        .collect();
    all.sort();
    all
}

/// Whether every body of a run has a frame.
pub fn has_frames(folder: &Path) -> bool {
    let lists = frame_lists(folder);
    !lists.is_empty() && lists.iter().all(|list| listed(list).is_ok_and(|frames| !frames.is_empty()))
}

/// What the frames of a run run along.
pub struct Along<'a> {
    curve: &'a Curve,
    /// The column of the curve; none where frames are counted like its rows.
    column: Option<usize>,
    /// Load cases and combinations in words, in the order of the rows; empty where there are none.
    cases: Vec<String>,
}

impl<'a> Along<'a> {
    /// The column that knows most of the places of the frames: the first one, else the level; else the number of the row.
    pub fn of(curve: &'a Curve, frames: &[f64]) -> Self {
        let level = curve.columns.iter().position(|column| column.name == "level");
        let columns = [Some(0), level].into_iter().flatten().filter(|&column| column < curve.columns.len());
        let known =
            |column: Option<usize>| frames.iter().filter(|&&at| row_of(curve, column, at).is_some()).count();
        let mut best = Self { curve, column: columns.clone().next(), cases: Vec::new() };
        for column in columns.map(Some).chain([None]) {
            if known(column) > known(best.column) {
                best.column = column;
            }
        }
        best
    }

    /// The same with the names of the load cases that a summary has.
    pub fn with_cases(mut self, summary: Option<&Value>) -> Self {
        let all = summary.and_then(|summary| summary["cases"].as_array());
        let words = |case: &Value| {
            let kind = if case["combines"] == true { "combination" } else { "case" };
            Some(format!("{kind} {}", case["name"].as_str()?))
        };
        self.cases = all.into_iter().flatten().filter_map(words).collect();
        self
    }

    /// Whether the frames are modes.
    pub fn are_modes(&self) -> bool {
        self.curve.columns.first().is_some_and(|column| column.name == "mode")
    }

    /// The row that belongs to a frame.
    pub fn row(&self, along: f64) -> Option<usize> {
        row_of(self.curve, self.column, along)
    }

    /// What a frame shows, in words: a mode with its frequency or level, a point of a path with its level, a time, a level.
    pub fn words(&self, along: f64) -> Option<String> {
        let said = |name: &str, value: f64| {
            let column = self.curve.columns.iter().find(|column| column.name == name)?;
            Some(match column.unit.as_str() {
                "-" => format!("{name} {}", short(value)),
                unit if name == "frequency" => format!("{} {unit}", short(value)),
                unit => format!("{name} {} {unit}", short(value)),
            })
        };
        let of = |name: &str| said(name, *self.curve.column(name)?.get(self.row(along)?)?);
        // Behind the cases stand their envelopes.
        let envelope = || {
            let behind = (along - self.cases.len() as f64 - 1.0) as usize;
            let extreme = (along > self.cases.len() as f64).then(|| Extreme::ALL.get(behind));
            Some(format!("envelope: {}", extreme??.word()))
        };
        let case = || self.row(along).and_then(|row| self.cases.get(row).cloned()).or_else(envelope);
        match self.column {
            _ if !self.cases.is_empty() => case(),
            _ if self.are_modes() => {
                let size = of("frequency").or_else(|| of("level"))?;
                Some(format!("mode {along}, {size}"))
            }
            None => Some(format!("point {along}, {}", of("level")?)),
            Some(column) => said(&self.curve.columns[column].name, along),
        }
    }
}

/// The row where a column has a number, or the row of that number.
fn row_of(curve: &Curve, column: Option<usize>, along: f64) -> Option<usize> {
    match column {
        Some(column) => curve.rows.iter().position(|row| row[column] == along),
        // A place between two whole numbers is no number of a row.
        None => Some(along as usize).filter(|&row| row < curve.rows.len() && row as f64 == along),
    }
}

/// A number with five digits.
pub fn short(x: f64) -> f64 {
    format!("{x:.4e}").parse().unwrap_or(x)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn said(text: &str, frames: &[f64]) -> (Vec<Option<usize>>, Option<String>) {
        let curve: Curve = text.parse().unwrap();
        let along = Along::of(&curve, frames);
        (frames.iter().map(|&at| along.row(at)).collect(), along.words(frames[frames.len() - 1]))
    }

    #[test]
    fn frames_know_their_rows_and_say_where_they_stand() {
        let march = "time [s],level [-]\n0.0,0.0\n4.0,0.5\n9.0,1.0\n";
        assert_eq!(said(march, &[0.0, 0.5, 1.0]), (vec![Some(0), Some(1), Some(2)], Some("level 1".into())));
        assert_eq!(said(march, &[0.0, 9.0]), (vec![Some(0), Some(2)], Some("time 9 s".into())));
        let path = "level [N],w [mm]\n0.0,0.0\n12.5,1.0\n11.0,2.0\n";
        assert_eq!(
            said(path, &[0.0, 1.0, 2.0]),
            (vec![Some(0), Some(1), Some(2)], Some("point 2, level 11 N".into()))
        );
        let modes = "mode [-],circular_frequency [rad/s],frequency [Hz]\n1.0,2.0,0.318312\n2.0,4.0,0.6366\n";
        assert_eq!(said(modes, &[1.0, 2.0]), (vec![Some(0), Some(1)], Some("mode 2, 0.6366 Hz".into())));
        let buckling = "mode [-],level [-],residual [-]\n1.0,4.0,1e-12\n";
        assert_eq!(said(buckling, &[1.0]).1, Some("mode 1, level 4".into()));
        let cases = "case [-],level [-]\n1.0,1.0\n2.0,1.0\n";
        assert_eq!(said(cases, &[1.0, 2.0]), (vec![Some(0), Some(1)], Some("case 2".into())));
        let summary =
            serde_json::json!({ "cases": [{ "name": "dead" }, { "name": "uls", "combines": true }] });
        let curve: Curve = cases.parse().unwrap();
        let named = Along::of(&curve, &[1.0, 2.0]).with_cases(Some(&summary));
        assert_eq!([1.0, 2.0].map(|at| named.words(at).unwrap()), ["case dead", "combination uls"]);
        // A run under way: the row of the last frame is not there yet.
        assert_eq!(said("time [s],level [-]\n0.0,1.0\n", &[0.0, 0.1]).0, [Some(0), None]);
    }
}
