//! The survival table: for every way to break a shell and every formulation, whether it held, how far off, what margin.

use super::overview::relative;
use crate::figures::Numbers;
use crate::format::short;
use crate::judge::{CaseResult, Record};
use crate::metric_names::KNOWN;

/// One row a problem, one column a method, in the order in which they appear.
///
/// A cell says what became of the run, its error, and how much of the tolerance is left.
pub fn survival(results: &[CaseResult]) -> Numbers {
    let mut methods: Vec<&str> = Vec::new();
    for run in results.iter().flat_map(|result| result.runs.iter()) {
        if !methods.contains(&run.variant.method.as_str()) {
            methods.push(&run.variant.method);
        }
    }
    let mut rows = Vec::new();
    for result in results {
        let mut grids: Vec<&str> = Vec::new();
        for run in result.runs.iter() {
            if !grids.contains(&run.variant.grid.as_str()) {
                grids.push(&run.variant.grid);
            }
        }
        for grid in grids {
            let mut row = vec![format!("{}: {grid}", result.case.name)];
            row.extend(methods.iter().map(|method| {
                let at = result.runs.find(method, grid);
                at.map(|at| cell(result, &result.records[at], at)).unwrap_or_default()
            }));
            rows.push(row);
        }
    }
    let head = std::iter::once("problem".to_owned()).chain(methods.iter().map(|m| (*m).to_owned())).collect();
    Numbers {
        title: "Survival".into(),
        caption: "● held, ○ ran but nothing is asked, ✗ missed what is asked, † diverged or was lost (known \
                  failures included), ⚠ coque warned of it. Then the error, and in \
                  brackets the part of the tolerance that is left. Empty: not run."
            .into(),
        head,
        rows,
    }
}

fn cell(result: &CaseResult, record: &Record, at: usize) -> String {
    let run = &result.runs.chosen[at];
    let metric = result.case.headline.and_then(|headline| record.metric(headline.metric));
    let held = record.passes() && record.metric(KNOWN).is_none();
    let sign = match (run.done(), held, record.metrics.iter().any(|m| m.tolerance.is_some())) {
        (false, ..) => "†",
        (_, false, _) => "✗",
        (_, true, true) => "●",
        (_, true, false) => "○",
    };
    let warned = if run.outcome.warnings.is_empty() { "" } else { " ⚠" };
    let Some(metric) = metric else { return format!("{sign}{warned}") };
    let (error, unit) = relative(metric);
    let error =
        error.map_or_else(|| "–".into(), |error| format!("{} {}", short(error), unit.trim_end_matches('-')));
    let margin = metric.error.zip(metric.tolerance).filter(|(_, tolerance)| *tolerance > 0.0);
    let left = margin.map(|(error, tolerance)| format!(" ({:.0} %)", 100.0 * (1.0 - error / tolerance)));
    format!("{sign}{warned} {}{}", error.trim_end(), left.unwrap_or_default())
}
