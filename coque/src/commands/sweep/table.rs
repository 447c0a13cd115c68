//! The table of a sweep: a row a run.

use std::io::Write;

use serde::{Deserialize, Serialize};

use super::combinations::Values;
use crate::{Column, Warning};

/// What became of one run.
#[derive(Serialize, Deserialize)]
pub(super) struct Row {
    pub ended: String,
    /// Exit code of such a run.
    pub code: u8,
    pub seconds: f64,
    pub columns: Vec<Column>,
    /// The last row of its curve; all rows where they are modes or load cases.
    pub found: Vec<Vec<String>>,
    pub warnings: Vec<Warning>,
}

impl Row {
    /// Words of its warnings, each once.
    pub fn warnings(&self) -> String {
        let mut words: Vec<&str> = self.warnings.iter().map(|warning| warning.kind.word()).collect();
        words.sort_unstable();
        words.dedup();
        words.join(" ")
    }
}

/// The table: columns of curves are those of the first run that has any, found by name in the others.
pub(super) fn write_table(
    to: &mut impl Write,
    over: &[(String, String)],
    runs: &[Values],
    rows: &[Option<Row>],
) -> std::io::Result<()> {
    let mut columns: Vec<&Column> = Vec::new();
    for column in rows.iter().flatten().flat_map(|row| &row.columns) {
        if !columns.contains(&column) {
            columns.push(column);
        }
    }
    let titles = columns.iter().map(|column| column.title());
    let paths = over.iter().map(|(path, _)| quoted(path));
    let head: Vec<String> = std::iter::once("run".into())
        .chain(paths)
        .chain(["ended".into(), "warnings".into(), "wall [s]".into()])
        .chain(titles)
        .collect();
    writeln!(to, "{}", head.join(","))?;
    for (number, (values, row)) in runs.iter().zip(rows).enumerate() {
        let values = values.iter().map(|(_, value)| quoted(value));
        let mut cells: Vec<String> = std::iter::once((number + 1).to_string()).chain(values).collect();
        match row {
            None => cells.extend(["not run".into(), String::new(), String::new()]),
            Some(row) => {
                cells.extend([quoted(&row.ended), row.warnings(), format!("{:.3}", row.seconds)]);
            }
        }
        let known = row.as_ref().map_or(&[][..], |row| &row.columns);
        let places: Vec<_> = columns.iter().map(|column| known.iter().position(|k| k == *column)).collect();
        let none = vec![vec![]];
        let found = row.as_ref().map(|row| &row.found).filter(|found| !found.is_empty()).unwrap_or(&none);
        for values in found {
            let value = |place: &Option<usize>| values.get((*place)?).cloned();
            let values = places.iter().map(|place| value(place).unwrap_or_default());
            let line: Vec<String> = cells.iter().cloned().chain(values).collect();
            writeln!(to, "{}", line.join(","))?;
        }
    }
    Ok(())
}

/// A cell of the table: in quotes where it holds a comma, a quote or a line break.
fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\n']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text.into() }
}
