//! What a reviewer should see of the quick set: counts, metrics and curves, to the digits that mean something.
//!
//! A snapshot records, it does not judge: see `tolerances.rs`. Times and numbers of steps are left out: they follow the
//! machine, and round-off where a stop criterion falls on its edge.

use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};

use serde_json::{Value, json};
use validation::judge::{Metric, Table};
use validation::{CaseResult, Record, Run};

use crate::Faults;

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

fn curve(table: &Table) -> Value {
    let count = table.rows.len();
    let kept: Vec<usize> = match count {
        0..=ROWS => (0..count).collect(),
        _ => (0..ROWS).map(|i| i * (count - 1) / (ROWS - 1)).collect(),
    };
    let columns = table.columns.iter().enumerate().filter(|(_, title)| {
        let name = title.split(' ').next().unwrap_or_default();
        !LEFT_OUT.contains(&name)
    });
    let column = |(at, title): (usize, &String)| {
        let largest = table.rows.iter().map(|row| row[at].abs()).fold(0.0, f64::max);
        let shown =
            |value: f64| if value.abs() <= FLOOR * largest { 0.0 } else { rounded(value, VALUE_DIGITS) };
        let values: Vec<String> = kept.iter().map(|&row| shown(table.rows[row][at]).to_string()).collect();
        (title.clone(), json!(values.join("  ")))
    };
    Value::Object(columns.map(column).collect())
}

fn record((run, record): (&Run, &Record)) -> Value {
    json!({
        "method": record.method,
        "grid": run.variant.grid,
        "particles": record.particles,
        "dof": record.dof,
        "spacing": rounded(record.spacing, VALUE_DIGITS),
        "metrics": record.metrics.iter().map(|m| (&m.name, metric(m))).collect::<BTreeMap<_, _>>(),
        "curve": curve(&record.curve),
    })
}

/// Cases that differ from their snapshots; each difference is printed and left as `.snap.new` beside the snapshot.
pub fn changed(results: &[CaseResult]) -> Faults {
    let agrees = |result: &CaseResult| {
        let records: Vec<Value> = result.runs.iter().zip(&result.records).map(record).collect();
        insta::with_settings!({ omit_expression => true, prepend_module_to_snapshot => false }, {
            insta::assert_json_snapshot!(result.case.name, records);
        });
    };
    // A snapshot that differs panics: caught, so that one run shows them all.
    let differs = |result: &&CaseResult| catch_unwind(AssertUnwindSafe(|| agrees(result))).is_err();
    results
        .iter()
        .filter(differs)
        .map(|result| format!("{}: see the difference above", result.case.name))
        .collect()
}

#[test]
fn rounding_keeps_digits_and_signs() {
    assert_eq!(rounded(2.221_94, 4), 2.222);
    assert_eq!(rounded(-0.000_123_456, 2), -0.00012);
    assert_eq!(rounded(0.0, 4), 0.0);
    let table = Table {
        columns: vec!["time [s]".into(), "W [m]".into()],
        rows: (0..101).map(|i| vec![0.1, f64::from(i) * 1.000_04 - 1e-6]).collect(),
    };
    let expected = "{\"W [m]\":\"0  12  25  37  50  62  75  87  100\"}";
    assert_eq!(curve(&table).to_string(), expected);
}
