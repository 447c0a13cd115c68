//! The record of one run: what it was, what it cost, its metrics with their verdicts, its curve.

use serde::{Deserialize, Serialize};

use crate::outcome::Outcome;

/// A run with its verdicts; the JSON file is a list of these.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Record {
    /// Name of the case.
    pub case: String,
    /// Formulation, and what else sets this run apart from the others of the case.
    pub method: String,
    /// Particles, or nodes of finite elements.
    pub particles: usize,
    /// Mean spacing of the particles, in the unit of length of the scene.
    pub spacing: f64,
    /// Freedoms that no support holds.
    pub dof: usize,
    /// Time steps; without time the equilibria found on the way.
    pub steps: u64,
    /// Threads of the run.
    pub threads: usize,
    /// Time the march took \[s\], while other runs kept the other cores busy.
    pub wall_seconds: f64,
    /// Particles times steps per second \[1/s\].
    pub particle_steps_per_second: f64,
    /// What was measured.
    pub metrics: Vec<Metric>,
    /// What was recorded.
    pub curve: Table,
}

/// Columns with names and units, one row per load level or record.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Table {
    /// Names with units, such as `W_tip [cm]`.
    pub columns: Vec<String>,
    /// Values.
    pub rows: Vec<Vec<f64>>,
}

/// A measured number, what it is held against, and the verdict.
///
/// `value`, `reference`, `error` and `tolerance` share one unit. Without a reference the value is itself an error.
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
    /// How far it may be off; none if it is only reported.
    pub tolerance: Option<f64>,
    /// Whether the error keeps to the tolerance; true where there is none.
    pub pass: bool,
    /// Where the tolerance, or the lack of one, comes from. Not written to JSON.
    #[serde(skip)]
    pub reason: String,
}

impl Metric {
    /// A value that is itself an error, such as a distance from the exact solution. Reported only, until
    /// [`Metric::within`] is called.
    pub fn error(name: impl Into<String>, value: Option<f64>, unit: &str) -> Self {
        Self::new(name.into(), value, unit, None, value.map(f64::abs))
    }

    /// A value held against a reference of the same unit. Reported only, until [`Metric::within`] is called.
    pub fn compared(name: impl Into<String>, value: Option<f64>, unit: &str, reference: f64) -> Self {
        Self::new(name.into(), value, unit, Some(reference), value.map(|value| (value - reference).abs()))
    }

    /// A value that should reach a reference; more is no error.
    pub fn at_least(name: impl Into<String>, value: Option<f64>, unit: &str, reference: f64) -> Self {
        let shortfall = value.map(|value| if value > reference { 0.0 } else { reference - value });
        Self::new(name.into(), value, unit, Some(reference), shortfall)
    }

    fn new(name: String, value: Option<f64>, unit: &str, reference: Option<f64>, error: Option<f64>) -> Self {
        // JSON knows no infinities: what is not a number counts as not reached.
        let finite = |x: Option<f64>| x.filter(|x| x.is_finite());
        Self {
            name,
            value: finite(value),
            unit: unit.into(),
            reference,
            error: finite(error),
            tolerance: None,
            pass: true,
            reason: String::new(),
        }
    }

    /// Judges: the error has to be there and at most `tolerance`, for a reason.
    #[must_use]
    pub fn within(mut self, tolerance: f64, reason: impl Into<String>) -> Self {
        self.tolerance = Some(tolerance);
        self.pass = self.error.is_some_and(|error| error <= tolerance);
        self.reason = reason.into();
        self
    }

    /// Judges as another metric does, or only reports as it does.
    #[must_use]
    pub fn within_if(self, judged: bool, tolerance: f64, reason: &str) -> Self {
        if judged { self.within(tolerance, reason) } else { self }
    }

    /// Says why the value is only reported.
    #[must_use]
    pub fn because(mut self, reason: impl Into<String>) -> Self {
        self.reason = reason.into();
        self
    }
}

impl Record {
    /// The record of an outcome.
    pub fn new(case: &str, method: &str, outcome: &Outcome, metrics: Vec<Metric>) -> Self {
        Self {
            case: case.into(),
            method: method.into(),
            particles: outcome.particles,
            spacing: outcome.spacing,
            dof: outcome.dof,
            steps: outcome.steps,
            threads: outcome.threads,
            wall_seconds: outcome.wall_seconds,
            particle_steps_per_second: outcome.particle_steps_per_second,
            metrics,
            curve: Table {
                columns: outcome.curve.columns.iter().map(coque::Column::title).collect(),
                rows: outcome.curve.rows.clone(),
            },
        }
    }

    /// Whether every metric passes.
    pub fn passes(&self) -> bool {
        self.metrics.iter().all(|metric| metric.pass)
    }

    /// A metric by its name.
    pub fn metric(&self, name: &str) -> Option<&Metric> {
        self.metrics.iter().find(|metric| metric.name == name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn record(metrics: Vec<Metric>) -> Record {
        Record {
            case: "made-up".into(),
            method: "none".into(),
            particles: 4,
            spacing: 0.1,
            dof: 20,
            steps: 7,
            threads: 1,
            wall_seconds: 0.5,
            particle_steps_per_second: 56.0,
            metrics,
            curve: Table { columns: vec!["level [-]".into()], rows: vec![vec![0.1 + 0.2], vec![1.0]] },
        }
    }

    #[test]
    fn a_missed_tolerance_fails_the_record() {
        let kept = Metric::error("a", Some(0.3), "%").within(0.3, "made up");
        let missed = Metric::error("b", Some(-0.31), "%").within(0.3, "made up");
        assert!(kept.pass && !missed.pass);
        assert!(record(vec![kept.clone()]).passes());
        assert!(!record(vec![kept, missed]).passes());
    }

    #[test]
    fn what_was_not_reached_fails_but_only_if_it_is_judged() {
        for value in [None, Some(f64::NAN), Some(f64::INFINITY)] {
            let metric = Metric::compared("a", value, "N", 2.0);
            assert_eq!((metric.value, metric.error, metric.pass), (None, None, true));
            assert!(!metric.within(1e9, "made up").pass);
        }
    }

    #[test]
    fn more_than_enough_is_no_error() {
        assert_eq!(Metric::at_least("order", Some(2.4), "-", 2.0).error, Some(0.0));
        let short = Metric::at_least("order", Some(1.7), "-", 2.0).within(0.2, "made up");
        assert!(!short.pass && (short.error.unwrap() - 0.3).abs() < 1e-12);
        assert!(!Metric::at_least("order", Some(f64::NAN), "-", 2.0).within(0.2, "made up").pass);
    }

    #[test]
    fn json_keeps_every_digit_and_has_the_agreed_keys() {
        let metrics = vec![
            Metric::compared("P", Some(2.25), "kN", 2.222).within(0.01, "not written"),
            Metric::error("tip", None, "%"),
        ];
        let first = record(metrics);
        let text = serde_json::to_string(&[&first]).unwrap();
        let read: Vec<Record> = serde_json::from_str(&text).unwrap();
        assert_eq!(serde_json::to_string(&read).unwrap(), text);
        assert_eq!(read[0].curve.rows[0][0].to_bits(), (0.1_f64 + 0.2).to_bits());
        let value: serde_json::Value = serde_json::from_str(&text).unwrap();
        let keys = |value: &serde_json::Value| {
            value.as_object().unwrap().keys().cloned().collect::<Vec<_>>().join(" ")
        };
        assert_eq!(
            keys(&value[0]),
            "case curve dof method metrics particle_steps_per_second particles spacing steps threads wall_seconds"
        );
        assert_eq!(keys(&value[0]["metrics"][0]), "error name pass reference tolerance unit value");
        assert_eq!(keys(&value[0]["curve"]), "columns rows");
        assert!(value[0]["metrics"][1]["tolerance"].is_null());
    }
}
