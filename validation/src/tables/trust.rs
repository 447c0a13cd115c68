//! Warnings against errors: who is warned of an exact number, and who is not of one that is off.

use std::fmt;

use coque::{Warning, WarningKind};

use super::overview::relative;
use crate::judge::{CaseResult, Problem, Record, Run};

/// Error \[%\] up to which a number that is warned of is exact: the warning has to say that it *may* be off.
const EXACT: f64 = 1.0;
/// Error \[%\] beyond which a number has to be warned of.
const OFF: f64 = 3.0;

/// What is reported as a fact about a run, not as a warning about its numbers.
const FACTS: [WarningKind; 4] =
    [WarningKind::Unstable, WarningKind::PassedCritical, WarningKind::NoWork, WarningKind::HeldLoad];

/// Whether a warning says no more than that a number may be off.
fn says_may(warning: &Warning) -> bool {
    FACTS.contains(&warning.kind) || warning.message.split_whitespace().any(|word| word == "may")
}

/// Runs of scenes that reached their end and whose headline has an error in percent, by what coque said of them. Studies on bare models
/// leave coque out, and with it its warnings.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Trust {
    /// All of them.
    pub runs: usize,
    /// Those that carry a warning.
    pub warned: usize,
    /// Of these, those off by more than one percent.
    pub warned_off: usize,
    /// Of the others, those whose warnings say that the number may be off.
    pub warned_may: usize,
    /// What is left: exact, and warned of.
    pub false_alarms: Vec<String>,
    /// Off by more than three percent, without a warning.
    pub silent: Vec<String>,
}

/// Counts the runs of all cases.
pub fn trust(results: &[CaseResult]) -> Trust {
    let mut out = Trust::default();
    for result in results {
        for (run, record) in result.runs.iter().zip(&result.records) {
            let Some(error) = error(result, run, record) else { continue };
            out.runs += 1;
            let name = || {
                let words = run.outcome.warnings().join(", ");
                format!("{} · {} · {}: {error:.2} % {words}", record.case, record.method, record.variant)
            };
            let warnings = &run.outcome.warnings;
            if warnings.is_empty() {
                if error > OFF {
                    out.silent.push(name());
                }
                continue;
            }
            out.warned += 1;
            if error > EXACT {
                out.warned_off += 1;
            } else if warnings.iter().all(says_may) {
                out.warned_may += 1;
            } else {
                out.false_alarms.push(name());
            }
        }
    }
    out
}

/// The error of the headline \[%\].
fn error(result: &CaseResult, run: &Run, record: &Record) -> Option<f64> {
    let headline = result.case.headline?;
    let (error, unit) = relative(record.metric(headline.metric)?);
    error.filter(|_| unit == "%" && run.done() && matches!(run.variant.source, Problem::Scene { .. }))
}

impl fmt::Display for Trust {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "warnings against errors: of {} runs with an error in percent {} are warned of, {} of them off by more than {EXACT} %, {} warned \
             that they may be",
            self.runs, self.warned, self.warned_off, self.warned_may
        )?;
        writeln!(f, "exact, and warned of: {}", self.false_alarms.len())?;
        self.false_alarms.iter().try_for_each(|name| writeln!(f, "  {name}"))?;
        writeln!(f, "off by more than {OFF} % without a word: {}", self.silent.len())?;
        self.silent.iter().try_for_each(|name| writeln!(f, "  {name}"))
    }
}
