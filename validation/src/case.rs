//! A case: scenes to run, and how their results are judged and drawn.

use std::fmt;
use std::sync::Arc;

use benchmarks_ref::fe_shell::cases::{CaseError, Solved};

use crate::JudgeError;
use crate::outcome::Outcome;
use crate::record::Metric;
use crate::report::Figure;

/// One benchmark: what is run, what it is held against.
pub struct Case {
    /// Name, as in `--case NAME`.
    pub name: &'static str,
    /// The problem in one line.
    pub title: &'static str,
    /// What is compared with what, and what this problem tells that the others do not.
    pub about: &'static str,
    /// Where problem and reference were published.
    pub citation: &'static str,
    /// What is run.
    pub variants: Vec<Variant>,
    /// Metrics of one run.
    pub each: fn(&Run) -> Result<Vec<Metric>, JudgeError>,
    /// Metrics that need several runs.
    pub together: fn(&Runs) -> Result<Vec<Booked>, JudgeError>,
    /// The one figure by which answers are compared; none where a case has no error of its own.
    pub headline: Option<Headline>,
    /// What the report shows, in this order.
    pub figures: fn(&Runs) -> Result<Vec<Figure>, JudgeError>,
}

/// A metric with the number of the run in whose record it stands.
pub type Booked = (usize, Metric);

/// The figure by which the answers to one problem are compared: explicit, static, finite elements, published.
#[derive(Clone, Copy)]
pub struct Headline {
    /// Name of the metric.
    pub metric: &'static str,
    /// Errors below this are not told apart, in the unit of the error: what the reference is known to.
    pub floor: f64,
    /// Published answers with their error, in the same unit.
    pub published: fn() -> Result<Vec<Published>, JudgeError>,
}

/// A published answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Published {
    /// Who found it.
    pub source: &'static str,
    /// How far it is off; none where it is itself the reference.
    pub error: Option<f64>,
}

/// One run of a case: a scene with some values replaced, or a study.
#[derive(Clone, Debug)]
pub struct Variant {
    /// Formulation, and what else sets the run apart; with [`Variant::grid`] unique in the case.
    pub method: String,
    /// Number of particles or nodes along u and v, as in `50×5`, and what else is set in the problem, as in `21×21 clamped`.
    pub grid: String,
    /// What is run.
    pub source: Problem,
    /// Whether the run belongs to the quick set.
    pub quick: bool,
    /// Whether every load level has to come to rest; false for methods known to flutter.
    pub settles: bool,
    /// Whether it runs by itself, when all others are done: its times are the result.
    pub alone: bool,
}

/// A run that is no scene; an error says why there is no outcome.
pub type Study = Arc<dyn Fn() -> Result<Outcome, String> + Send + Sync>;

/// What a variant runs.
#[derive(Clone)]
pub enum Problem {
    /// A scene.
    Scene {
        /// Its text, embedded.
        text: &'static str,
        /// Values replaced, as in `coque run --set`.
        set: Vec<(String, String)>,
    },
    /// Anything else that leaves an outcome behind: the finite-element shell, a study on a bare shell.
    Study(Study),
}

impl fmt::Debug for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Scene { set, .. } => f.debug_struct("Scene").field("set", set).finish_non_exhaustive(),
            Self::Study(_) => f.write_str("Study"),
        }
    }
}

impl Variant {
    /// A scene as it is in the file, with `counts` particles along u and v of its `geometry`.
    pub fn new(method: &str, scene: &'static str, geometry: &str, counts: [usize; 2]) -> Self {
        let [u, v] = counts;
        let particles = (format!("geometry.{geometry}.particles"), format!("[{u}, {v}]"));
        Self {
            method: method.into(),
            grid: format!("{u}×{v}"),
            source: Problem::Scene { text: scene, set: vec![particles] },
            quick: false,
            settles: true,
            alone: false,
        }
    }

    /// A case of the finite-element shell on a mesh with `counts` nodes along u and v.
    pub fn elements(
        method: &str,
        counts: [usize; 2],
        solve: impl Fn() -> Result<Solved, CaseError> + Send + Sync + 'static,
    ) -> Self {
        let [u, v] = counts;
        let solve = move || solve().map(Outcome::from).map_err(|cause| cause.to_string());
        Self::study(method, &format!("{u}×{v}"), solve)
    }

    /// A run that is no scene.
    pub fn study(
        method: &str,
        grid: &str,
        run: impl Fn() -> Result<Outcome, String> + Send + Sync + 'static,
    ) -> Self {
        let (method, grid) = (method.into(), grid.into());
        Self {
            method,
            grid,
            source: Problem::Study(Arc::new(run)),
            quick: false,
            settles: false,
            alone: false,
        }
    }

    /// Replaces a value of the scene.
    #[must_use]
    pub fn set(mut self, path: &str, value: impl ToString) -> Self {
        if let Problem::Scene { set, .. } = &mut self.source {
            set.push((path.into(), value.to_string()));
        }
        self
    }

    /// Adds what sets a run apart beside its lattice: a load, a thickness.
    #[must_use]
    pub fn on(mut self, what: &str) -> Self {
        self.grid = format!("{} {what}", self.grid);
        self
    }

    /// Puts the run into the quick set, which is judged with every commit.
    #[must_use]
    pub fn quick(mut self) -> Self {
        self.quick = true;
        self
    }

    /// Runs it by itself, when all others are done.
    #[must_use]
    pub fn alone(mut self) -> Self {
        self.alone = true;
        self
    }

    /// Does not ask that load levels come to rest.
    #[must_use]
    pub fn restless(mut self) -> Self {
        self.settles = false;
        self
    }
}

/// A variant with its outcome.
#[derive(Clone, Debug)]
pub struct Run {
    /// What was run.
    pub variant: Variant,
    /// What came out.
    pub outcome: Outcome,
}

impl Run {
    /// Whether the method and the grid are these.
    pub fn is(&self, method: &str, grid: &str) -> bool {
        self.variant.method == method && self.variant.grid == grid
    }

    /// A column of the curve.
    ///
    /// # Errors
    /// [`JudgeError::NoColumn`] if the scene does not record it.
    pub fn column(&self, name: &str) -> Result<Vec<f64>, JudgeError> {
        self.outcome.curve.column(name).ok_or_else(|| JudgeError::NoColumn {
            name: name.into(),
            known: self
                .outcome
                .curve
                .columns
                .iter()
                .map(|column| column.name.as_str())
                .collect::<Vec<_>>()
                .join(", "),
        })
    }

    /// The value of a column at a load level; none if the run did not get there.
    ///
    /// # Errors
    /// [`JudgeError::NoColumn`].
    pub fn at(&self, column: &str, level: f64) -> Result<Option<f64>, JudgeError> {
        let (levels, values) = (self.column("level")?, self.column(column)?);
        Ok(levels.iter().position(|known| (known - level).abs() < 1e-9).map(|row| values[row]))
    }

    /// Whether the run reached its end.
    pub fn done(&self) -> bool {
        self.outcome.failure.is_none()
    }
}

/// The runs of one case that were chosen, in the order of its variants.
#[derive(Clone, Debug)]
pub struct Runs(pub Vec<Run>);

impl Runs {
    /// The number of a run, if it was chosen.
    pub fn find(&self, method: &str, grid: &str) -> Option<usize> {
        self.0.iter().position(|run| run.is(method, grid))
    }

    /// A run, if it was chosen.
    pub fn get(&self, method: &str, grid: &str) -> Option<&Run> {
        self.find(method, grid).map(|at| &self.0[at])
    }
}
