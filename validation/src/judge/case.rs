//! A case: scenes to run, and how their results are judged and drawn.

use super::metric::Metric;
use super::peers::Peers;
use super::variant::{Run, Runs, Variant};
use crate::JudgeError;
use crate::figures::Figure;

/// One benchmark: what is run, what it is held against. What a case does not name, it does not have (`..Case::default()`).
pub struct Case {
    /// Name, as in `--case NAME`.
    pub name: &'static str,
    /// Its family: errors of one family are drawn against their costs in one figure.
    pub family: &'static str,
    /// The problem in one line.
    pub title: &'static str,
    /// What is compared with what, and what this problem tells that the others do not.
    pub about: &'static str,
    /// Where problem and reference were published.
    pub citation: &'static str,
    /// What is run.
    pub variants: Vec<Variant>,
    /// Metrics of one run that every run of the case has; those of single runs stand on the variants.
    pub each: fn(&Run) -> Result<Vec<Metric>, JudgeError>,
    /// Metrics that need several runs.
    pub together: fn(&Runs) -> Result<Vec<Recorded>, JudgeError>,
    /// The one figure by which answers are compared; none where a case has no error of its own.
    pub headline: Option<Headline>,
    /// Answers of other programs with what they cost, for the figures of error against cost.
    pub peers: fn() -> Result<Option<Peers>, JudgeError>,
    /// What the report shows, in this order.
    pub figures: fn(&Runs) -> Result<Vec<Figure>, JudgeError>,
}

impl Default for Case {
    fn default() -> Self {
        Self {
            name: "",
            family: "",
            title: "",
            about: "",
            citation: "",
            variants: Vec::new(),
            each: |_| Ok(Vec::new()),
            together: |_| Ok(Vec::new()),
            headline: None,
            peers: || Ok(None),
            figures: |_| Ok(Vec::new()),
        }
    }
}

/// A metric with the number of the run in whose record it stands.
pub type Recorded = (usize, Metric);

/// The figure by which the answers to one problem are compared: explicit, static, finite elements, published.
#[derive(Clone, Copy)]
pub struct Headline {
    /// Name of the metric.
    pub metric: &'static str,
    /// Errors below this are not distinguished, in the unit of the error: what the reference is known to.
    pub floor: f64,
    /// Published answers with their error, in the same unit.
    pub published: fn() -> Result<Vec<Published>, JudgeError>,
}

impl Headline {
    /// Without published answers.
    pub fn new(metric: &'static str, floor: f64) -> Self {
        Self { metric, floor, published: || Ok(Vec::new()) }
    }
}

/// A published answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Published {
    /// Who found it.
    pub source: &'static str,
    /// How far it is off; none where it is itself the reference.
    pub error: Option<f64>,
}
