//! The printed table: one line a run, and every missed tolerance with its reason.

use std::ops::Range;

use crate::figures::Numbers;
use crate::format::short;
use crate::judge::{CaseResult, Metric, Record, Verdict};
use crate::metric_names::REST;

/// Value, reference and tolerance in a few words: `2.2219 (2.222 ± 0.0111)`, `0.28 (≤ 0.4)`.
pub fn words(metric: &Metric) -> String {
    let value = metric.value.map_or_else(|| "not reached".into(), short);
    match (metric.reference, metric.tolerance) {
        (Some(reference), Some(tolerance)) => {
            format!("{value} ({} ± {})", short(reference), short(tolerance))
        }
        (Some(reference), None) => format!("{value} ({})", short(reference)),
        (None, Some(tolerance)) => format!("{value} (≤ {})", short(tolerance)),
        (None, None) => value,
    }
}

/// Unit with a blank before it; nothing for "-".
pub fn unit(metric: &Metric) -> String {
    if metric.unit == "-" { String::new() } else { format!(" {}", metric.unit) }
}

/// The whole table, then the misses.
pub fn table(results: &[CaseResult]) -> String {
    let head = ["case", "method", "grid", "particles", "wall s", "Mp-steps/s", "verdict", "metrics"];
    let mut lines = vec![head.map(String::from).to_vec()];
    for result in results {
        for (run, record) in result.runs.iter().zip(&result.records) {
            lines.push(vec![
                record.case.clone(),
                record.method.clone(),
                run.variant.grid.clone(),
                record.particles.to_string(),
                format!("{:.2}", record.wall_seconds),
                format!("{:.2}", record.particle_steps_per_second / 1e6),
                record.verdict().word().into(),
                metrics(record),
            ]);
        }
    }
    let mut text = aligned(&lines, 3..6);
    for result in results {
        for (run, record) in result.runs.iter().zip(&result.records) {
            for metric in record.metrics.iter().filter(|metric| !metric.pass) {
                text.push_str(&format!(
                    "\nMISSED  {}, {} {}: {} is {}{}\n        tolerance: {}\n",
                    record.case,
                    record.method,
                    run.variant.grid,
                    metric.name,
                    words(metric),
                    unit(metric),
                    metric.reason
                ));
            }
        }
    }
    text + "\n" + &counts(results) + "\n"
}

/// How many metrics are judged, how many of those are missed, how many are only shown.
pub fn counts(results: &[CaseResult]) -> String {
    let (mut judged, mut missed, mut shown) = (0, 0, 0);
    for metric in results.iter().flat_map(|result| &result.records).flat_map(|record| &record.metrics) {
        match metric.verdict {
            Verdict::Pass => judged += 1,
            Verdict::Missed => (judged, missed) = (judged + 1, missed + 1),
            Verdict::Shown => shown += 1,
        }
    }
    format!("{judged} metrics judged, {missed} of them missed; {shown} shown")
}

/// All metrics in one cell; the unit follows the last metric that has it.
fn metrics(record: &Record) -> String {
    let mut cell = String::new();
    let shown: Vec<&Metric> = record.metrics.iter().filter(|m| m.name != REST || !m.pass).collect();
    for (i, metric) in shown.iter().enumerate() {
        let flag = if metric.pass { "" } else { "!! " };
        let value = metric.value.map_or_else(|| "not reached".into(), short);
        cell.push_str(&format!("{flag}{} {value}", metric.name));
        match shown.get(i + 1) {
            Some(next) if next.unit == metric.unit => cell.push_str(" · "),
            Some(_) => cell.push_str(&format!("{} · ", unit(metric))),
            None => cell.push_str(&unit(metric)),
        }
    }
    cell
}

/// A small table with its title and what to see in it; the first column is words.
pub fn numbers(numbers: &Numbers) -> String {
    let lines: Vec<Vec<String>> = std::iter::once(&numbers.head).chain(&numbers.rows).cloned().collect();
    let table = aligned(&lines, 1..numbers.head.len());
    format!("{}\n\n{table}\n{}\n", numbers.title, numbers.caption)
}

/// Columns side by side; the columns of `numbers` to the right, the others to the left.
fn aligned(lines: &[Vec<String>], numbers: Range<usize>) -> String {
    let width = |column: usize| lines.iter().map(|line| line[column].chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..lines.first().map_or(0, Vec::len)).map(width).collect();
    let mut text = String::new();
    for line in lines {
        let cells = line.iter().zip(&widths).enumerate();
        let padded: Vec<String> = cells
            .map(|(column, (cell, &width))| match numbers.contains(&column) {
                true => format!("{cell:>width$}"),
                false => format!("{cell:<width$}"),
            })
            .collect();
        text.push_str(padded.join("  ").trim_end());
        text.push('\n');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_say_what_was_asked() {
        let compared = || Metric::compared("P", Some(2.25), "kN", 2.222);
        assert_eq!(words(&compared().shown("")), "2.25 (2.222)");
        assert_eq!(words(&compared().within(0.011, "")), "2.25 (2.222 ± 0.011)");
        assert_eq!(words(&Metric::error("tip", Some(0.28), "%").within(0.4, "")), "0.28 (≤ 0.4)");
        assert_eq!(words(&Metric::error("tip", None, "%").shown("")), "not reached");
    }
}
