//! The record of one run: what it was, what it cost, its metrics with their verdicts, its curve.

use coque::Warning;
use serde::{Deserialize, Serialize};

use super::case::Case;
use super::commit::commit;
use super::metric::{Metric, Verdict};
use super::outcome::Outcome;
use super::variant::Variant;
use crate::metric_names::REST;

/// A run with its verdicts; the JSON file is a list of these.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Record {
    /// Name of the case.
    pub case: String,
    /// Title of the case.
    pub title: String,
    /// Formulation, and what else sets this run apart from the others of the case.
    pub method: String,
    /// Particles or nodes along u and v, and what else is set in the problem: unique in the case together with the method.
    pub variant: String,
    /// Commit of the code that ran, `+` behind it where files differ from it; none outside a checkout.
    pub commit: Option<String>,
    /// Particles, or nodes of finite elements.
    pub particles: usize,
    /// Mean spacing of the particles, in the unit of length of the scene.
    pub spacing: f64,
    /// Degrees of freedom that no support holds.
    pub dof: usize,
    /// Time steps; without time the equilibria found on the way.
    pub steps: u64,
    /// Threads of the run.
    pub threads: usize,
    /// Time the march took \[s\], while other runs kept the other cores busy.
    pub wall_seconds: f64,
    /// Particles times steps per second \[1/s\].
    pub particle_steps_per_second: f64,
    /// Warnings that coque gave about its numbers.
    pub warnings: Vec<Warning>,
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

impl Record {
    /// The record of an outcome.
    pub fn new(case: &Case, variant: &Variant, outcome: &Outcome, metrics: Vec<Metric>) -> Self {
        Self {
            case: case.name.into(),
            title: case.title.into(),
            method: variant.method.clone(),
            variant: variant.grid.clone(),
            commit: commit(),
            particles: outcome.particles,
            spacing: outcome.spacing,
            dof: outcome.dof,
            steps: outcome.steps,
            threads: outcome.threads,
            wall_seconds: outcome.wall_seconds,
            particle_steps_per_second: outcome.particle_steps_per_second,
            warnings: outcome.warnings.clone(),
            metrics,
            curve: Table {
                columns: outcome.curve.columns.iter().map(coque::Column::title).collect(),
                rows: outcome.curve.rows.clone(),
            },
        }
    }

    /// The metric that uses most of its tolerance; the first one where nothing is asked.
    pub fn nearest(&self) -> Option<&Metric> {
        self.metrics.iter().rev().max_by(|a, b| a.share().total_cmp(&b.share()))
    }

    /// Whether every metric passes.
    pub fn passes(&self) -> bool {
        self.metrics.iter().all(|metric| metric.pass)
    }

    /// `Shown` where nothing is asked but that the shell come to rest.
    pub fn verdict(&self) -> Verdict {
        let asked = |metric: &Metric| metric.tolerance.is_some() && metric.name != REST;
        match (self.passes(), self.metrics.iter().any(asked)) {
            (false, _) => Verdict::Missed,
            (true, true) => Verdict::Pass,
            (true, false) => Verdict::Shown,
        }
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
            title: "Made up".into(),
            method: "none".into(),
            variant: "2×2".into(),
            commit: None,
            particles: 4,
            spacing: 0.1,
            dof: 20,
            steps: 7,
            threads: 1,
            wall_seconds: 0.5,
            particle_steps_per_second: 56.0,
            warnings: Vec::new(),
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
            let found = || Metric::compared("a", value, "N", 2.0);
            let shown = found().shown("made up");
            assert_eq!((shown.value, shown.error, shown.pass), (None, None, true));
            assert!(!found().within(1e9, "made up").pass);
        }
    }

    #[test]
    fn json_keeps_every_digit_and_has_the_agreed_keys() {
        let metrics = vec![
            Metric::compared("P", Some(2.25), "kN", 2.222).within(0.01, "made up"),
            Metric::error("tip", None, "%").shown("made up"),
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
            "case commit curve dof method metrics particle_steps_per_second particles spacing steps threads title variant \
             wall_seconds warnings"
        );
        assert_eq!(
            keys(&value[0]["metrics"][0]),
            "error name pass reason reference tolerance unit value verdict"
        );
        assert_eq!(keys(&value[0]["curve"]), "columns rows");
        assert!(value[0]["metrics"][1]["tolerance"].is_null());
        assert_eq!(value[0]["metrics"][0]["verdict"], "missed");
        assert_eq!(value[0]["metrics"][1]["verdict"], "shown");
    }
}
