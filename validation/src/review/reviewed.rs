//! What a reviewer sees of a run, and what is stored of it: counts, metrics and curves, to the digits that mean something.
//!
//! Times and numbers of steps are left out: they follow the machine, and round-off where a stop criterion falls on its
//! edge.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::judge::{Metric, Table};
use crate::{Record, Run};

/// Significant digits of values; rest is asked for to about 1e-5 of the displacements.
const VALUE_DIGITS: usize = 4;
/// Significant digits of errors, which are small differences of values.
const ERROR_DIGITS: usize = 2;
/// Part of the largest value of a column below which there is only round-off and unfinished rest.
const FLOOR: f64 = 1e-4;
/// Rows of a curve that are kept, evenly spaced, with the first and the last.
const ROWS: usize = 9;
/// Columns that depend on the number of steps, or are rounding.
const LEFT_OUT: [&str; 5] = ["time", "kinetic", "external", "dissipated", "residual"];

/// A run as it was reviewed: the snapshot of a case is a list of these.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Reviewed {
    /// Values of each column at the rows that are kept, by the title of the column, with two blanks between them.
    pub curve: BTreeMap<String, String>,
    /// Degrees of freedom that no support holds.
    pub dof: usize,
    /// Particles or nodes along u and v, and what else is set in the problem.
    pub grid: String,
    /// Formulation, and what else sets this run apart.
    pub method: String,
    /// Value, unit and verdict by the name of the metric.
    pub metrics: BTreeMap<String, String>,
    /// Particles, or nodes of finite elements.
    pub particles: usize,
    /// Mean spacing of the particles, in the unit of length of the scene.
    pub spacing: f64,
}

impl Reviewed {
    /// What is to be reviewed of a run.
    pub fn of(run: &Run, record: &Record) -> Self {
        Self {
            curve: curve(&record.curve),
            dof: record.dof,
            grid: run.variant.grid.clone(),
            method: record.method.clone(),
            metrics: record.metrics.iter().map(|m| (m.name.to_string(), metric(m))).collect(),
            particles: record.particles,
            spacing: rounded(record.spacing, VALUE_DIGITS),
        }
    }

    /// The runs of a stored snapshot, whose head ends with a line of three dashes.
    ///
    /// # Errors
    /// What is wrong with the text.
    pub fn stored(text: &str) -> Result<Vec<Self>, String> {
        let body = text.splitn(3, "---\n").nth(2).ok_or("the head of the snapshot does not end")?;
        serde_json::from_str(body).map_err(|error| error.to_string())
    }

    /// A column of the curve; none where the snapshot has no such column.
    pub fn column(&self, title: &str) -> Option<Vec<f64>> {
        self.curve.get(title)?.split_whitespace().map(|value| value.parse().ok()).collect()
    }
}

/// Numbers of the rows that are kept of a curve with `count` rows.
pub fn kept(count: usize) -> Vec<usize> {
    match count {
        0..=ROWS => (0..count).collect(),
        _ => (0..ROWS).map(|i| i * (count - 1) / (ROWS - 1)).collect(),
    }
}

fn rounded(value: f64, digits: usize) -> f64 {
    // Through text: the number that is nearest to these digits, whatever powers of ten do.
    format!("{value:.*e}", digits - 1).parse().unwrap_or(f64::NAN)
}

/// One line: value, unit, verdict.
fn metric(metric: &Metric) -> String {
    // Below this a metric is round-off, and differs between machines.
    const ROUND_OFF: f64 = 1e-8;
    let digits = if metric.reference.is_some() { VALUE_DIGITS } else { ERROR_DIGITS };
    let value = match metric.value {
        None => "not reached".into(),
        Some(value) if value.abs() < ROUND_OFF => "0".into(),
        Some(value) => format!("{}", rounded(value, digits)),
    };
    let most = metric.tolerance.map(|most| format!(" (off by at most {})", rounded(most, VALUE_DIGITS)));
    format!("{value} {}, {}{}", metric.unit, metric.verdict.word(), most.unwrap_or_default())
}

fn curve(table: &Table) -> BTreeMap<String, String> {
    let rows = kept(table.rows.len());
    let columns = table.columns.iter().enumerate().filter(|(_, title)| {
        let name = title.split(' ').next().unwrap_or_default();
        !LEFT_OUT.contains(&name)
    });
    let column = |(at, title): (usize, &String)| {
        let largest = table.rows.iter().map(|row| row[at].abs()).fold(0.0, f64::max);
        let shown =
            |value: f64| if value.abs() <= FLOOR * largest { 0.0 } else { rounded(value, VALUE_DIGITS) };
        let values: Vec<String> = rows.iter().map(|&row| shown(table.rows[row][at]).to_string()).collect();
        (title.clone(), values.join("  "))
    };
    columns.map(column).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_keeps_digits_and_signs() {
        assert_eq!(rounded(2.221_94, 4), 2.222);
        assert_eq!(rounded(-0.000_123_456, 2), -0.00012);
        assert_eq!(rounded(0.0, 4), 0.0);
        let table = Table {
            columns: vec!["time [s]".into(), "W [m]".into()],
            rows: (0..101).map(|i| vec![0.1, f64::from(i) * 1.000_04 - 1e-6]).collect(),
        };
        let found = curve(&table);
        assert_eq!(found.len(), 1);
        assert_eq!(found["W [m]"], "0  12  25  37  50  62  75  87  100");
    }

    #[test]
    fn a_stored_snapshot_is_read_back() {
        let run = Reviewed {
            curve: BTreeMap::from([("W [m]".into(), "0  -0.5  1".into())]),
            dof: 3,
            grid: "2×2".into(),
            method: "none".into(),
            metrics: BTreeMap::from([("tip".into(), "1 m, shown".into())]),
            particles: 4,
            spacing: 0.5,
        };
        let body = serde_json::to_string(std::slice::from_ref(&run)).unwrap();
        let text = format!("---\nsource: somewhere.rs\n---\n{body}\n");
        assert_eq!(Reviewed::stored(&text).unwrap(), std::slice::from_ref(&run));
        assert_eq!(run.column("W [m]").unwrap(), [0.0, -0.5, 1.0]);
        assert_eq!(run.column("U [m]"), None);
        assert!(Reviewed::stored("no head").is_err());
    }
}
