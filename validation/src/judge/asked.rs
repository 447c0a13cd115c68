//! What is asked of a run: that it come to rest, stay within its bound or its known miss, and warn where it is far off.

use super::metric::Metric;
use super::outcome::Solver;
use super::variant::{Bound, Run, Runs};
use crate::JudgeError;
use crate::metric_names::{ERROR, KNOWN, REST, SILENT};

/// Part of a known error by which it may change before it has to be looked at again.
const DRIFT: f64 = 0.1;
/// Error \[%\] beyond which a run has to carry a warning: what asks least of a hard case asks two percent.
const SILENCE: f64 = 2.0;
/// What disorder may add to twice the error of a lattice \[%\].
const DISORDER: f64 = 0.5;

/// Asks that a quasi-static run came to rest at every level.
pub fn rest(run: &Run) -> Option<Metric> {
    let unsettled = run.outcome.unsettled as f64;
    let reason = "a load that is read while the shell still moves is dragged by the damping";
    let found = Metric::error(REST, run.done().then_some(unsettled), "-");
    (run.variant.settles && run.outcome.solver == Solver::Explicit).then(|| found.within(0.0, reason))
}

/// Asks that the error of a run stay within its bound or, where it is known to miss that, that it stay what it is.
///
/// # Errors
/// [`JudgeError`] of what measures the error.
pub fn asked(run: &Run, runs: &Runs) -> Result<Vec<Metric>, JudgeError> {
    let Some((_, reason)) = run.variant.asked else { return Ok(Vec::new()) };
    let (error, bound) = (off(run, runs)?, bound(run, runs)?);
    let metric = Metric::error(ERROR, error, "%");
    let Some((known, cause)) = run.variant.known else { return Ok(vec![metric.within(bound, reason)]) };
    let asserted = if known.is_nan() {
        Metric::compared(KNOWN, Some(f64::from(u8::from(!run.done()))), "-", 1.0).within(0.0, cause)
    } else {
        Metric::compared(KNOWN, error, "%", known).within(DRIFT * known.abs(), cause)
    };
    Ok(vec![metric.shown(format!("asked {bound} %: {reason}; known to miss it: {cause}")), asserted])
}

/// How far off a run is \[%\]; none if it did not reach its end.
fn off(run: &Run, runs: &Runs) -> Result<Option<f64>, JudgeError> {
    match &run.variant.off {
        Some(off) if run.done() => off(run, runs),
        _ => Ok(None),
    }
}

/// How far off a run may be \[%\].
fn bound(run: &Run, runs: &Runs) -> Result<f64, JudgeError> {
    match &run.variant.asked {
        None => Ok(0.0),
        Some((Bound::Percent(bound), _)) => Ok(*bound),
        Some((Bound::TwiceThatOf(grid), _)) => {
            let Some(other) = runs.get(&run.variant.method, grid)? else { return Ok(DISORDER) };
            let own = off(other, runs)?.map_or(0.0, f64::abs).min(bound(other, runs)?);
            Ok(2.0 * own + DISORDER)
        }
    }
}

/// Asks of a particle run that is off by more than two percent that it carry a warning.
///
/// Answers are judged that have an error in percent of a truth; runs that did not reach their end say so by themselves.
pub fn silent(run: &Run, metrics: &[Metric]) -> Option<Metric> {
    let error = metrics.iter().find(|metric| metric.name == ERROR && metric.unit == "%")?.error?;
    let asked = run.outcome.solver != Solver::Elements && run.done() && error > SILENCE;
    let silent = if run.outcome.warnings.is_empty() { error } else { 0.0 };
    let reason = format!("an answer more than {SILENCE} % off carries a warning");
    asked.then(|| Metric::error(SILENT, Some(silent), "%").within(SILENCE, reason))
}

#[cfg(test)]
mod tests {
    use coque::{Warning, WarningKind};

    use super::*;
    use crate::{Outcome, Variant};

    fn run(outcome: Outcome) -> Run {
        Run { variant: Variant::study("cell", "made up", || Err("not run".into())), outcome }
    }

    #[test]
    fn an_answer_far_off_must_carry_a_warning() {
        let error = |percent: f64| [Metric::error(ERROR, Some(percent), "%").shown("made up")];
        let verdict = |run: &Run, percent: f64| silent(run, &error(percent)).map(|metric| metric.pass);
        let quiet = run(Outcome::default());
        assert_eq!(verdict(&quiet, 1.9), None);
        assert_eq!(verdict(&quiet, -5.0), Some(false));
        let warnings = vec![Warning::new(WarningKind::UnevenCells, "made up")];
        assert_eq!(verdict(&run(Outcome { warnings, ..Outcome::default() }), -5.0), Some(true));
        let elements = Outcome { solver: Solver::Elements, ..Outcome::default() };
        assert_eq!(verdict(&run(elements), 5.0), None);
    }

    #[test]
    fn a_known_miss_may_neither_grow_nor_vanish() {
        let judged = |off: f64, known: f64| {
            let mut run = run(Outcome::default());
            run.variant =
                run.variant.off(move |_, _| Ok(Some(off))).asked(1.0, "made up").known(known, "made up");
            let runs = Runs { chosen: vec![run.clone()], left_out: Vec::new() };
            asked(&run, &runs).unwrap().iter().all(|metric| metric.pass)
        };
        for (off, known, passes) in [
            (0.9, 0.0, true),
            (1.1, 0.0, false),
            (-3.0, -3.06, true),
            (-3.5, -3.06, false),
            (0.5, -3.06, false),
            (0.5, f64::NAN, false),
        ] {
            assert_eq!(judged(off, known), passes, "{off} {known}");
        }
    }

    #[test]
    fn disorder_is_held_against_what_the_lattice_finds_and_a_lattice_that_is_not_there_is_an_error() {
        let made =
            |grid: &str, off: f64| run(Outcome::default()).variant.named(grid).off(move |_, _| Ok(Some(off)));
        let of = |variant: Variant| Run { variant, outcome: Outcome::default() };
        let lattice = of(made("lattice", 0.2).asked(1.0, "made up"));
        let jitter = of(made("jitter", 0.9).asked_twice_that_of("lattice", "made up"));
        let runs = |chosen: &[&Run]| Runs {
            chosen: chosen.iter().map(|&run| run.clone()).collect(),
            left_out: Vec::new(),
        };
        assert_eq!(bound(&jitter, &runs(&[&lattice, &jitter])).unwrap(), 0.9);
        let error = bound(&jitter, &runs(&[&jitter])).unwrap_err().to_string();
        assert!(error.contains("no variant cell lattice"), "{error}");
    }
}
