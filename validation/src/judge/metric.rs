//! A measured number, what it is held against, and the verdict.

use serde::{Deserialize, Serialize};

use super::measure::largest;
use crate::format::short;
use crate::metric_names::REST;

/// A measured number, what it is held against, and the verdict.
///
/// `value`, `reference`, `error` and `tolerance` share one unit. Without a reference the value is itself an error. A metric
/// has either a tolerance or the verdict [`Verdict::Shown`], and in both cases a reason.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Metric {
    /// What is measured.
    pub name: String,
    /// The measured value; none if the run did not get that far.
    pub value: Option<f64>,
    /// Unit of all four numbers.
    pub unit: String,
    /// What it should be.
    pub reference: Option<f64>,
    /// How far it is off; never negative.
    pub error: Option<f64>,
    /// How far it may be off; none if it is only shown.
    pub tolerance: Option<f64>,
    /// Whether the error keeps to the tolerance; true where there is none.
    pub pass: bool,
    /// The same in a word, which tells what is kept from what is not asked.
    pub verdict: Verdict,
    /// Where the tolerance comes from, or why there is none.
    pub reason: String,
    /// Errors with their signs, each behind its place along a path, where the value is the greatest of them.
    #[serde(skip)]
    pub signed: Vec<[f64; 2]>,
}

/// What is said of a metric, or of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// The error keeps to its tolerance.
    Pass,
    /// It does not, or there is none because the run did not get that far.
    Missed,
    /// There is no tolerance: nothing is asked.
    Shown,
}

impl Verdict {
    /// The word in table and report; what is missed has to be seen.
    pub fn word(self) -> &'static str {
        match self {
            Self::Pass => "pass",
            Self::Missed => "MISSED",
            Self::Shown => "shown",
        }
    }
}

/// A measured number before the verdict: it becomes a metric by a tolerance or by a reason to have none.
#[derive(Clone, Debug, PartialEq)]
#[must_use = "a number without a verdict is in no record"]
pub struct Found {
    name: String,
    value: Option<f64>,
    unit: String,
    reference: Option<f64>,
    error: Option<f64>,
    signed: Vec<[f64; 2]>,
}

/// How many times the error measured when a case was reviewed is the most that it may have.
///
/// Wide enough for a change of compiler, library or stop criterion, narrow enough that a piece of mechanics cannot go.
const TIMES: f64 = 3.0;

impl Metric {
    /// A value that is itself an error, such as a distance from the exact solution.
    pub fn error(name: impl Into<String>, value: Option<f64>, unit: &str) -> Found {
        Found::new(name.into(), value, unit, None, value.map(f64::abs))
    }

    /// The greatest of errors with their signs, each behind its place along a path; none where there are none or one is no number.
    pub fn greatest(
        name: impl Into<String>,
        errors: impl IntoIterator<Item = (f64, Option<f64>)>,
        unit: &str,
    ) -> Found {
        let errors: Vec<(f64, Option<f64>)> = errors.into_iter().collect();
        let value = largest(errors.iter().map(|(_, error)| error.map(f64::abs)));
        let signed = errors.iter().filter_map(|(at, error)| error.map(|error| [*at, error])).collect();
        Found { signed, ..Self::error(name, value, unit) }
    }

    /// A value held against a reference of the same unit.
    pub fn compared(name: impl Into<String>, value: Option<f64>, unit: &str, reference: f64) -> Found {
        Found::new(name.into(), value, unit, Some(reference), value.map(|value| (value - reference).abs()))
    }

    /// A value that should reach a reference; more is no error.
    pub fn at_least(name: impl Into<String>, value: Option<f64>, unit: &str, reference: f64) -> Found {
        let shortfall = value.map(|value| if value > reference { 0.0 } else { reference - value });
        Found::new(name.into(), value, unit, Some(reference), shortfall)
    }
}

impl Metric {
    /// The part of its tolerance that the error uses; negative where there is none to use.
    pub fn share(&self) -> f64 {
        match (self.error, self.tolerance) {
            _ if self.name == REST && self.pass => -2.0,
            (_, None) => -1.0,
            (Some(error), Some(tolerance)) if tolerance > 0.0 => error / tolerance,
            (Some(0.0), Some(_)) => 0.0,
            (_, Some(_)) => f64::INFINITY,
        }
    }
}

impl Found {
    fn new(name: String, value: Option<f64>, unit: &str, reference: Option<f64>, error: Option<f64>) -> Self {
        // JSON knows no infinities: what is not a number counts as not reached.
        let finite = |x: Option<f64>| x.filter(|x| x.is_finite());
        let (value, error) = (finite(value), finite(error));
        Self { name, value, unit: unit.into(), reference, error, signed: Vec::new() }
    }

    fn with(self, tolerance: Option<f64>, verdict: Verdict, reason: String) -> Metric {
        let Self { name, value, unit, reference, error, signed } = self;
        let pass = verdict != Verdict::Missed;
        Metric { name, value, unit, reference, error, tolerance, pass, verdict, reason, signed }
    }

    /// Judges: the error has to be there and at most `tolerance`, for a reason.
    pub fn within(self, tolerance: f64, reason: impl Into<String>) -> Metric {
        let kept = self.error.is_some_and(|error| error <= tolerance);
        self.with(Some(tolerance), if kept { Verdict::Pass } else { Verdict::Missed }, reason.into())
    }

    /// Judges by the error `measured` when the case was last reviewed: three times that may it be, whatever of mechanics
    /// the error stands for is said in `reason`.
    ///
    /// Of a value with a reference, `measured` is in percent of the reference; else in the unit of the value.
    pub fn near(self, measured: f64, reason: &str) -> Metric {
        let (tolerance, unit) = match self.reference {
            Some(reference) => (0.01 * reference.abs() * most(measured), "%"),
            None => (most(measured), self.unit.trim_end_matches('-')),
        };
        let known = format!("{} {unit}", short(measured));
        let reason = format!("measured {}, three times that: {reason}", known.trim_end());
        self.within(tolerance, reason)
    }

    /// Gives no verdict and says why.
    pub fn shown(self, reason: impl Into<String>) -> Metric {
        self.with(None, Verdict::Shown, reason.into())
    }
}

/// Three times an error, up to the next number of two significant digits.
fn most(measured: f64) -> f64 {
    let most = TIMES * measured.abs();
    if most == 0.0 {
        return 0.0;
    }
    let power = libm::log10(most).floor() as i32 - 1;
    // A hair less, for numbers that have two digits already.
    let digits = (most / 10_f64.powi(power) - 1e-9).ceil();
    // Through text: the number that is nearest to these digits, whatever powers of ten do.
    format!("{digits}e{power}").parse().unwrap_or(most)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_measured_error_may_grow_three_times_and_no_more() {
        for (measured, tolerance) in [
            (0.012, 0.036),
            (0.0117, 0.036),
            (0.28, 0.84),
            (1.0, 3.0),
            (4.0, 12.0),
            (3.5, 11.0),
            (1e-9, 3e-9),
            (0.0, 0.0),
        ] {
            assert_eq!(most(measured), tolerance);
        }
        let tip = |error| Metric::error("tip", Some(error), "% of L").near(0.012, "curvature along arcs");
        assert_eq!(tip(0.012).tolerance, Some(0.036));
        assert_eq!(tip(0.012).reason, "measured 0.012 % of L, three times that: curvature along arcs");
        assert!(tip(0.036).pass && !tip(0.037).pass && !tip(0.28).pass);
        // In percent of the reference.
        let load = |value| Metric::compared("P", Some(value), "kN", -2.0).near(0.5, "made up");
        assert!(load(-1.98).pass && load(-2.03).pass && !load(-2.031).pass && !load(2.0).pass);
        assert!(load(2.0).reason.starts_with("measured 0.5 %, three times"), "{}", load(2.0).reason);
        assert!(!Metric::error("tip", None, "%").near(1e9, "made up").pass);
    }

    #[test]
    fn what_is_only_shown_says_so() {
        let shown = Metric::error("wall", Some(3.0), "s").shown("times follow the machine");
        assert_eq!((shown.verdict, shown.pass, shown.tolerance), (Verdict::Shown, true, None));
        let (kept, missed) = (Metric::error("a", Some(0.1), "-"), Metric::error("a", Some(0.3), "-"));
        assert_eq!(kept.within(0.2, "made up").verdict, Verdict::Pass);
        assert_eq!(missed.within(0.2, "made up").verdict.word(), "MISSED");
    }

    #[test]
    fn the_greatest_error_keeps_signs_and_places() {
        let found = |errors: [(f64, Option<f64>); 2]| Metric::greatest("P", errors, "%").shown("made up");
        let metric = found([(0.5, Some(0.2)), (1.0, Some(-0.3))]);
        assert_eq!((metric.value, metric.error), (Some(0.3), Some(0.3)));
        assert_eq!(metric.signed, [[0.5, 0.2], [1.0, -0.3]]);
        assert_eq!(found([(0.5, Some(0.2)), (1.0, None)]).value, None);
    }

    #[test]
    fn more_than_enough_is_no_error() {
        assert_eq!(Metric::at_least("order", Some(2.4), "-", 2.0).error, Some(0.0));
        let short = Metric::at_least("order", Some(1.7), "-", 2.0).within(0.2, "made up");
        assert!(!short.pass && (short.error.unwrap() - 0.3).abs() < 1e-12);
        assert!(!Metric::at_least("order", Some(f64::NAN), "-", 2.0).within(0.2, "made up").pass);
    }
}
