//! The error of every number of a run, as runs of the same scene on other lattices tell it: what is printed, drawn and written of it.

use std::collections::BTreeMap;

use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

use super::curve::{Column, Curve};

/// What the answers on several lattices tell of one number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// They approach it as a power of the spacing.
    Converging,
    /// The same, with a finer lattice among them that was run for this number.
    Sharpened,
    /// There are two lattices only: the second order is taken, with three times the error it gives.
    TwoLattices,
    /// They go back and forth: the bar is one and a half times their greatest difference.
    NotYet,
    /// They differ by round-off only.
    Exact,
    /// Their differences do not fall as the lattice is refined: no finite value is expected.
    Grows,
    /// The other lattices have no such number.
    Unpaired,
}

impl Verdict {
    /// In words.
    pub fn words(self) -> &'static str {
        match self {
            Self::Converging => "converging",
            Self::Sharpened => "converging, sharpened by a finer lattice",
            Self::TwoLattices => "two lattices, order taken",
            Self::NotYet => "not converging yet",
            Self::Exact => "exact but for round-off",
            Self::Grows => "grows with refinement",
            Self::Unpaired => "not found on the other lattices",
        }
    }
}

/// A number with its error.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ErrorBar {
    /// The number, in the unit of its column.
    pub value: f64,
    /// Bound of its error, in the same unit; none where none is known.
    pub bar: Option<f64>,
    /// Order of convergence that was seen, from one half to two; none where none was.
    pub order: Option<f64>,
    /// What the lattices tell.
    pub verdict: Verdict,
    /// The number without its error, where a finer lattice shows that; in the same unit.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub corrected: Option<f64>,
}

impl ErrorBar {
    /// The error of the number without the safety of its bar, where the lattices show an order; in its unit.
    pub fn convergence(&self) -> Option<f64> {
        match self.verdict {
            Verdict::Converging => self.bar.map(|bar| bar / SAFETY),
            Verdict::Sharpened => self.corrected.map(|corrected| (self.value - corrected).abs()),
            _ => None,
        }
    }
}

/// The factor of a bar on the error that three lattices show.
pub(crate) const SAFETY: f64 = 1.6;

/// The errors of a column, a row each.
#[derive(Clone, Debug, PartialEq)]
pub struct ColumnErrors {
    /// The column.
    pub column: Column,
    /// Its numbers with their errors, in the order of the rows.
    pub bars: Vec<ErrorBar>,
}

/// A critical point of a path with the error of its level.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CriticalError {
    /// What it is, as in the summary.
    pub kind: String,
    /// Its level.
    #[serde(flatten)]
    pub bar: ErrorBar,
}

/// A lattice that the scene was run on.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LatticeRun {
    /// The lattice in words.
    pub lattice: String,
    /// Spacing over that of the scene \[–\].
    pub spacing: f64,
    /// Wall time of building and running it \[s\]; of the scene itself that of its run.
    pub seconds: f64,
    /// "done", or why it ended early.
    pub ended: String,
}

/// What one number of the method, changed, changes of the answers.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Probed {
    /// What was changed, in words.
    pub changed: String,
    /// The lattice that it was run on.
    pub lattice: String,
    /// Wall time \[s\].
    pub seconds: f64,
    /// What it changes of the columns.
    pub columns: Vec<ProbedColumn>,
}

/// What a probe changes of a column.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ProbedColumn {
    /// The column.
    pub name: String,
    /// Its unit.
    pub unit: String,
    /// Change of its last number, with its sign.
    pub last: Option<f64>,
    /// Greatest change of its numbers.
    pub greatest: f64,
}

/// The errors of a run, and what they rest on.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Errors {
    /// Errors of the columns that have them.
    pub columns: Vec<ColumnErrors>,
    /// Errors of the critical points of a path.
    pub critical: Vec<CriticalError>,
    /// Lattices, the scene's own first.
    pub lattices: Vec<LatticeRun>,
    /// What the bars hold.
    pub holds: Vec<String>,
    /// What they do not hold.
    pub lacks: Vec<String>,
    /// What numbers of the method change of the answers, where that was asked for.
    pub probes: Vec<Probed>,
    /// Where there is no bar, and why.
    pub without: Vec<String>,
}

/// The name of the column that has the bars of one.
pub(crate) fn bar_of(column: &str) -> String {
    format!("{column} ±")
}

/// Most rows of one column that a summary lists one by one.
const LISTED: usize = 200;

impl Errors {
    /// No bars, for a reason.
    pub fn none(why: impl Into<String>) -> Self {
        Self { without: vec![why.into()], ..Self::default() }
    }

    /// Time of the runs on other lattices over that of the run \[–\]; none where there are none.
    pub fn cost(&self) -> Option<f64> {
        let (own, others) = self.lattices.split_first()?;
        let spent: f64 = others.iter().map(|run| run.seconds).sum();
        (!others.is_empty() && own.seconds > 0.0).then(|| spent / own.seconds)
    }

    /// The curve with the bar of each column beside it; `NaN` where there is none.
    pub fn beside(&self, curve: &Curve) -> Curve {
        let mut whole = Curve { columns: Vec::new(), rows: vec![Vec::new(); curve.rows.len()] };
        for (at, column) in curve.columns.iter().enumerate() {
            whole.columns.push(column.clone());
            whole.rows.iter_mut().zip(&curve.rows).for_each(|(to, row)| to.push(row[at]));
            if let Some(found) = self.of(&column.name) {
                whole.columns.push(Column { name: bar_of(&column.name), unit: column.unit.clone() });
                let bars = found.bars.iter().map(|bar| bar.bar.unwrap_or(f64::NAN));
                whole.rows.iter_mut().zip(bars).for_each(|(to, bar)| to.push(bar));
            }
        }
        whole
    }

    /// The errors of a column.
    pub fn of(&self, column: &str) -> Option<&ColumnErrors> {
        self.columns.iter().find(|found| found.column.name == column)
    }
}

/// A column in the summary: its last number, with what all its numbers rest on.
#[derive(Serialize)]
struct Entry<'a> {
    #[serde(flatten)]
    last: ErrorBar,
    unit: &'a str,
    lattices: usize,
    seconds: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    rows: Option<&'a [ErrorBar]>,
}

/// What the bars rest on, in the summary.
#[derive(Serialize)]
struct Basis<'a> {
    lattices: &'a [LatticeRun],
    critical: &'a [CriticalError],
    holds: &'a [String],
    not_in_it: &'a [String],
    #[serde(skip_serializing_if = "<[Probed]>::is_empty")]
    probes: &'a [Probed],
    without_bar: &'a [String],
}

impl Serialize for Errors {
    /// As two keys: `errors`, by column, and `error_basis`.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let seconds: f64 = self.lattices.iter().skip(1).map(|run| run.seconds).sum();
        let count = self.lattices.len();
        let entries = self.columns.iter().filter_map(|found| {
            let last = *found.bars.last()?;
            let rows = (found.bars.len() <= LISTED).then_some(&found.bars[..]);
            let entry = Entry { last, unit: &found.column.unit, lattices: count, seconds, rows };
            Some((found.column.name.as_str(), entry))
        });
        let columns: BTreeMap<&str, Entry<'_>> = entries.collect();
        let Self { lattices, critical, holds, lacks, probes, without, .. } = self;
        let mut map = serializer.serialize_map(Some(2))?;
        map.serialize_entry("errors", &columns)?;
        let basis = Basis { lattices, critical, holds, not_in_it: lacks, probes, without_bar: without };
        map.serialize_entry("error_basis", &basis)?;
        map.end()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bar_stands_beside_its_column_and_reads_back() {
        let column = |name: &str| Column { name: name.into(), unit: "mm".into() };
        let curve =
            Curve { columns: vec![column("level"), column("w")], rows: vec![vec![0.5, 1.0], vec![1.0, 2.0]] };
        let bar =
            |value, bar| ErrorBar { value, bar, order: None, verdict: Verdict::Converging, corrected: None };
        let bars = vec![bar(1.0, Some(0.01)), bar(2.0, None)];
        let errors =
            Errors { columns: vec![ColumnErrors { column: column("w"), bars }], ..Errors::default() };
        let mut text = Vec::new();
        errors.beside(&curve).write_csv(&mut text).unwrap();
        let text = String::from_utf8(text).unwrap();
        assert_eq!(text, "level [mm],w [mm],w ± [mm]\n0.5,1.0,0.01\n1.0,2.0,NaN\n");
        assert_eq!(text.parse::<Curve>().unwrap().column("w ±").unwrap()[0], 0.01);
    }
}
