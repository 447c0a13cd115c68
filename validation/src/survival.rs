//! The survival table: for every way to break a shell and every formulation, whether it held, how far off, what margin.

use crate::answers::relative;
use crate::case::Run;
use crate::cases::ERROR;
use crate::outcome::Solver;
use crate::record::{Metric, Record};
use crate::report::Numbers;
use crate::run::CaseResult;
use crate::table::short;

/// Name of the metric that asserts a failure as it is, with its cause.
pub const KNOWN: &str = "known failure";

/// Name of the metric that an answer fails which is far off and says nothing.
pub const SILENT: &str = "off without a warning";
/// Error \[%\] beyond which a run has to carry a warning: what asks least of a hard case asks two percent.
const SILENCE: f64 = 2.0;

/// Asks of a particle run that is off by more than two percent that it carry a warning.
///
/// Answers are judged that have an error in percent of a truth; runs that did not reach their end say so by themselves.
pub fn told(run: &Run, metrics: &[Metric]) -> Option<Metric> {
    let error = metrics.iter().find(|metric| metric.name == ERROR && metric.unit == "%")?.error?;
    let asked = run.outcome.solver != Solver::Elements && run.done() && error > SILENCE;
    let silent = if run.outcome.warnings.is_empty() { error } else { 0.0 };
    let reason = format!("an answer more than {SILENCE} % off carries a warning");
    asked.then(|| Metric::error(SILENT, Some(silent), "%").within(SILENCE, reason))
}

/// One row a problem, one column a method, in the order in which they appear.
///
/// A cell says what became of the run, its error, and how much of the tolerance is left.
pub fn survival(results: &[CaseResult]) -> Numbers {
    let mut methods: Vec<&str> = Vec::new();
    for run in results.iter().flat_map(|result| &result.runs.0) {
        if !methods.contains(&run.variant.method.as_str()) {
            methods.push(&run.variant.method);
        }
    }
    let mut rows = Vec::new();
    for result in results {
        let mut grids: Vec<&str> = Vec::new();
        for run in &result.runs.0 {
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
    let run = &result.runs.0[at];
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

#[cfg(test)]
mod tests {
    use coque::{Curve, Doubt, Warning};

    use super::*;
    use crate::case::Variant;
    use crate::outcome::Outcome;

    fn run(warnings: Vec<Warning>) -> Run {
        let variant = Variant::study("cell", "made up", || Err("not run".into()));
        let outcome = Outcome {
            solver: Solver::Static,
            curve: Curve { columns: Vec::new(), rows: Vec::new() },
            particles: 0,
            spacing: 0.0,
            dof: 0,
            steps: 0,
            threads: 1,
            wall_seconds: 0.0,
            particle_steps_per_second: 0.0,
            stable_step: 0.0,
            restless: 0,
            critical: Vec::new(),
            failure: None,
            warnings,
            shapes: Vec::new(),
            faces: Vec::new(),
        };
        Run { variant, outcome }
    }

    #[test]
    fn an_answer_far_off_must_carry_a_warning() {
        let error = |percent: f64| [Metric::error(ERROR, Some(percent), "%").shown("made up")];
        let verdict = |run: &Run, percent: f64| told(run, &error(percent)).map(|metric| metric.pass);
        let silent = run(Vec::new());
        assert_eq!(verdict(&silent, 1.9), None);
        assert_eq!(verdict(&silent, -5.0), Some(false));
        let warned = run(vec![Warning::new(Doubt::UnevenCells, "made up")]);
        assert_eq!(verdict(&warned, -5.0), Some(true));
        let elements = Run { outcome: Outcome { solver: Solver::Elements, ..silent.outcome }, ..silent };
        assert_eq!(verdict(&elements, 5.0), None);
    }
}
