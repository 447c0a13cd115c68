//! A variant: one run of a case, with all that is asked of it; and the runs that came of the variants of a case.

use std::fmt;
use std::sync::Arc;

use benchmarks_ref::fe_shell::cases::{CaseError, Solved};

use super::lattices::Lattices;
use super::metric::Metric;
use super::outcome::Outcome;
use crate::JudgeError;
use crate::methods::setting;

/// One run of a case: a scene with some values replaced, or a study.
#[derive(Clone)]
pub struct Variant {
    /// Formulation, and what else sets the run apart; with [`Variant::grid`] unique in the case.
    pub method: String,
    /// Number of particles or nodes along u and v, as in `50×5`, and what else is set in the problem, as in `21×21 clamped`.
    pub grid: String,
    /// What is run.
    pub source: Problem,
    /// What runs a study on other lattices; none of a scene, which has its own, and of what has none.
    pub lattices: Option<Lattices>,
    /// Which set of runs it belongs to.
    pub effort: Effort,
    /// Whether every load level has to come to rest; false for methods known to flutter.
    pub settles: bool,
    /// Whether it runs by itself, when all others are done: its times are the result.
    pub alone: bool,
    /// Whether it stands for its case in the overview: as fine as problems of its kind are usually solved.
    pub usual: bool,
    /// How far off the run is \[%\].
    pub off: Option<Off>,
    /// How far off it may be, and why.
    pub asked: Option<(Bound, &'static str)>,
    /// By how much it is known to miss that \[%\], and the cause.
    pub known: Option<(f64, &'static str)>,
    /// Further metrics of this run.
    pub judged: Option<Judged>,
}

/// A run that is no scene; an error says why there is no outcome.
pub type Study = Arc<dyn Fn() -> Result<Outcome, String> + Send + Sync>;
/// Measures how far off a run is \[%\]; the other runs of the case are at hand.
pub type Off = Arc<dyn Fn(&Run, &Runs) -> Result<Option<f64>, JudgeError> + Send + Sync>;
/// Judges a run; the other runs of the case are at hand.
pub type Judged = Arc<dyn Fn(&Run, &Runs) -> Result<Vec<Metric>, JudgeError> + Send + Sync>;

/// In a table of known misses: this run keeps to what is asked.
pub const MET: f64 = 0.0;
/// In a table of known misses: this run does not reach its end.
pub const LOST: f64 = f64::NAN;

/// How much a run costs, and so when it is made.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd)]
pub enum Effort {
    /// A second or two: judged with every commit.
    Quick,
    /// Up to ten seconds: judged where nothing else is asked for.
    #[default]
    Usual,
    /// Up to ten minutes: judged in the full set.
    Full,
    /// More than ten minutes: run by hand, its table kept in docs/.
    Heavy,
}

impl Effort {
    /// Whether a run of this effort is made where runs of the other are asked for: a set holds those that cost less, but
    /// for the heavy one, which stands alone.
    pub fn belongs_to(self, set: Self) -> bool {
        if set == Self::Heavy { self == set } else { self <= set }
    }
}

/// How far off a run may be.
#[derive(Clone, Debug)]
pub enum Bound {
    /// So much \[%\].
    Percent(f64),
    /// Twice the error of the run of the same method on this grid, or of what that may have, and half a percent.
    TwiceThatOf(String),
}

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

impl fmt::Debug for Variant {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Variant")
            .field("method", &self.method)
            .field("grid", &self.grid)
            .finish_non_exhaustive()
    }
}

impl Variant {
    /// A scene with the formulation of `method`, and `counts` particles along u and v of its `geometry`.
    pub fn new(method: &str, scene: &'static str, geometry: &str, counts: [usize; 2]) -> Self {
        let [u, v] = counts;
        let mut set = vec![(format!("geometry.{geometry}.particles"), format!("[{u}, {v}]"))];
        if let Some((path, value)) = setting(method).and_then(|setting| setting.set) {
            set.push((format!("formulation.{path}"), value.into()));
        }
        Self::of(method, format!("{u}×{v}"), Problem::Scene { text: scene, set }, true)
    }

    /// A scene as it stands; `grid` says what sets it apart.
    pub fn scene(method: &str, scene: &'static str, grid: impl Into<String>) -> Self {
        Self::of(method, grid.into(), Problem::Scene { text: scene, set: Vec::new() }, true)
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
        Self::of(method, grid.into(), Problem::Study(Arc::new(run)), false)
    }

    /// A study that runs on other lattices as well.
    pub fn study_on(method: &str, grid: &str, lattices: Lattices) -> Self {
        let (run, cells) = (lattices.run.clone(), lattices.cells);
        Self { lattices: Some(lattices), ..Self::study(method, grid, move || run(cells)) }
    }

    fn of(method: &str, grid: String, source: Problem, settles: bool) -> Self {
        Self {
            method: method.into(),
            grid,
            source,
            lattices: None,
            effort: Effort::Usual,
            settles,
            alone: false,
            usual: false,
            off: None,
            asked: None,
            known: None,
            judged: None,
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

    /// Solves the scene without time at some load levels.
    #[must_use]
    pub fn static_levels(self, levels: &[f64]) -> Self {
        self.set("analysis.static.levels", format!("{levels:?}"))
    }

    /// Relaxes the scene at some load levels, to a residual of so much of the load.
    #[must_use]
    pub fn relaxed(self, levels: &[f64], tolerance: f64) -> Self {
        self.set("analysis.relaxation", format!("{{ levels = {levels:?}, tolerance = {tolerance:e} }}"))
    }

    /// Names what sets a run apart, in place of its lattice.
    #[must_use]
    pub fn named(mut self, grid: impl Into<String>) -> Self {
        self.grid = grid.into();
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
    pub fn quick(self) -> Self {
        self.quick_if(true)
    }

    /// The same on a condition.
    #[must_use]
    pub fn quick_if(mut self, quick: bool) -> Self {
        self.effort = if quick { Effort::Quick } else { Effort::Usual };
        self
    }

    /// Leaves the run to the full set, on a condition.
    #[must_use]
    pub fn full_if(mut self, long: bool) -> Self {
        if long {
            self.effort = Effort::Full;
        }
        self
    }

    /// Leaves the run to the heavy set, which is run by hand.
    #[must_use]
    pub fn heavy(mut self) -> Self {
        self.effort = Effort::Heavy;
        self
    }

    /// Lets the run stand for its case in the overview, on a condition.
    #[must_use]
    pub fn usual_if(mut self, usual: bool) -> Self {
        self.usual = usual;
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
    pub fn unsettled(mut self) -> Self {
        self.settles = false;
        self
    }

    /// Measures how far off the run is \[%\].
    #[must_use]
    pub fn off(
        mut self,
        off: impl Fn(&Run, &Runs) -> Result<Option<f64>, JudgeError> + Send + Sync + 'static,
    ) -> Self {
        self.off = Some(Arc::new(off));
        self
    }

    /// Asks that the run be off by at most `bound` \[%\], for a reason.
    #[must_use]
    pub fn asked(mut self, bound: f64, reason: &'static str) -> Self {
        self.asked = Some((Bound::Percent(bound), reason));
        self
    }

    /// Asks that the run be off by at most twice what that of the same method on another grid is.
    #[must_use]
    pub fn asked_twice_that_of(mut self, grid: impl Into<String>, reason: &'static str) -> Self {
        self.asked = Some((Bound::TwiceThatOf(grid.into()), reason));
        self
    }

    /// Notes that the run is known to miss what is asked, by an error \[%\] or as [`LOST`], and why; of one that is
    /// [`MET`] nothing is noted.
    #[must_use]
    pub fn known(mut self, error: f64, cause: &'static str) -> Self {
        self.known = (error != MET).then_some((error, cause));
        self
    }

    /// Judges the run by further metrics.
    #[must_use]
    pub fn judged(
        mut self,
        judged: impl Fn(&Run, &Runs) -> Result<Vec<Metric>, JudgeError> + Send + Sync + 'static,
    ) -> Self {
        self.judged = Some(Arc::new(judged));
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
    /// Whether the method is this one.
    pub fn is(&self, method: &str) -> bool {
        self.variant.method == method
    }

    /// A column of the curve.
    ///
    /// # Errors
    /// [`JudgeError::NoColumn`] if the scene does not record it.
    pub fn column(&self, name: &str) -> Result<Vec<f64>, JudgeError> {
        self.outcome.curve.column(name).ok_or_else(|| {
            let known = self.outcome.curve.columns.iter().map(|column| column.name.as_str());
            JudgeError::NoColumn { name: name.into(), known: known.collect::<Vec<_>>().join(", ") }
        })
    }

    /// The last value of a column; none if the run did not reach its end.
    ///
    /// # Errors
    /// [`JudgeError::NoColumn`].
    pub fn last(&self, column: &str) -> Result<Option<f64>, JudgeError> {
        Ok(self.column(column)?.last().copied().filter(|_| self.done()))
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
pub struct Runs {
    /// The runs.
    pub chosen: Vec<Run>,
    /// Variants of the case that were not chosen.
    pub left_out: Vec<Variant>,
}

impl Runs {
    /// The runs.
    pub fn iter(&self) -> std::slice::Iter<'_, Run> {
        self.chosen.iter()
    }

    /// The number of a run, if the case has it and it was chosen.
    pub fn find(&self, method: &str, grid: &str) -> Option<usize> {
        self.iter().position(|run| run.is(method) && run.variant.grid == grid)
    }

    /// The number of a run of the case, if it was chosen.
    ///
    /// # Errors
    /// [`JudgeError::NoVariant`] if the case has no such variant: what asks for it would judge nothing.
    pub fn number(&self, method: &str, grid: &str) -> Result<Option<usize>, JudgeError> {
        let found = self.find(method, grid);
        let left_out =
            || self.left_out.iter().any(|variant| variant.method == method && variant.grid == grid);
        if found.is_none() && !left_out() {
            return Err(JudgeError::NoVariant { method: method.into(), grid: grid.into() });
        }
        Ok(found)
    }

    /// A run of the case, if it was chosen.
    ///
    /// # Errors
    /// [`JudgeError::NoVariant`].
    pub fn get(&self, method: &str, grid: &str) -> Result<Option<&Run>, JudgeError> {
        Ok(self.number(method, grid)?.map(|at| &self.chosen[at]))
    }
}
