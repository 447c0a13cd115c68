//! What a run left behind, whoever solved it: particles in time, particles without time, finite elements.

use benchmarks_ref::fe_shell::cases::Solved;
use coque::{Column, CriticalSummary, Curve, Ended, FluidFigures, Shape, Warning};

/// Who found the answer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Solver {
    /// Particles, marched in time.
    Explicit,
    /// The same particles and energy without time.
    #[default]
    Static,
    /// The same by dynamic relaxation.
    Relaxed,
    /// The independent finite-element shell.
    Elements,
}

impl Solver {
    /// Name in tables.
    pub fn words(self) -> &'static str {
        match self {
            Self::Explicit => "sph explicit",
            Self::Static => "sph static",
            Self::Relaxed => "sph relaxed",
            Self::Elements => "fe static",
        }
    }
}

/// What a run left behind; the default is that of no particles.
#[derive(Clone, Debug, Default)]
pub struct Outcome {
    /// Who found it.
    pub solver: Solver,
    /// One row per record.
    pub curve: Curve,
    /// Particles, or nodes.
    pub particles: usize,
    /// Mean spacing of the particles or nodes \[L\].
    pub spacing: f64,
    /// Degrees of freedom that no support holds.
    pub dof: usize,
    /// Time steps, or converged points of a path.
    pub steps: u64,
    /// Threads of the run.
    pub threads: usize,
    /// Wall time of the analysis \[s\].
    pub wall_seconds: f64,
    /// Particles times time steps per second \[1/s\]; zero without time.
    pub particle_steps_per_second: f64,
    /// Greatest stable step at rest \[T\]; zero without time.
    pub stable_step: f64,
    /// Load levels at which the motion had not died.
    pub unsettled: usize,
    /// Greatest error of the energy balance of a march over the energy turned over \[%\]; zero without time.
    pub balance: f64,
    /// Figures of a fluid at the end, if a scene has one.
    pub fluid: Option<FluidFigures>,
    /// Critical points met on a path without time.
    pub critical: Vec<CriticalSummary>,
    /// Why it did not reach its end.
    pub failure: Option<String>,
    /// What coque warned of; none of finite elements.
    pub warnings: Vec<Warning>,
    /// Deformed shapes; none of finite elements.
    pub shapes: Vec<Shape>,
    /// Cells between the particles, as their numbers, for pictures.
    pub faces: Vec<Vec<usize>>,
}

impl From<coque::Outcome> for Outcome {
    fn from(run: coque::Outcome) -> Self {
        let summary = run.summary;
        Self {
            solver: match summary.analysis.as_str() {
                "explicit" => Solver::Explicit,
                "relaxation" => Solver::Relaxed,
                _ => Solver::Static,
            },
            curve: run.curve,
            particles: summary.body.particles,
            spacing: summary.body.spacing,
            dof: summary.body.dof,
            steps: summary.record.steps,
            threads: summary.threads,
            wall_seconds: summary.record.wall_seconds,
            particle_steps_per_second: summary.particle_steps_per_second,
            stable_step: summary.record.stable_step,
            unsettled: summary.record.levels.iter().filter(|level| !level.settled).count(),
            balance: summary.record.balance.map_or(0.0, |balance| 100.0 * balance.share().abs()),
            fluid: summary.record.fluid,
            critical: summary.record.critical,
            failure: match run.ended {
                Ended::Done => None,
                ended => Some(ended.to_string()),
            },
            warnings: summary.record.warnings,
            shapes: run.shapes,
            faces: run
                .cells
                .iter()
                .map(|cell| cell.particles().iter().map(|&a| a as usize).collect())
                .collect(),
        }
    }
}

impl From<Solved> for Outcome {
    fn from(solved: Solved) -> Self {
        // Columns of the finite-element cases are written `name [unit]`.
        let column = |title: &&str| {
            let (name, unit) = title.split_once(" [").unwrap_or((title, "-]"));
            Column { name: name.into(), unit: unit.trim_end_matches(']').into() }
        };
        Self {
            solver: Solver::Elements,
            curve: Curve { columns: solved.columns.iter().map(column).collect(), rows: solved.rows },
            particles: solved.nodes,
            spacing: solved.spacing,
            dof: solved.unknowns,
            steps: solved.iterations as u64,
            threads: 1,
            wall_seconds: solved.seconds,
            ..Self::default()
        }
    }
}

impl Outcome {
    /// One row of figures with their units, found on one thread.
    pub fn row(solver: Solver, figures: &[(&str, &str, f64)]) -> Self {
        Self { solver, threads: 1, ..Self::default() }.showing(figures)
    }

    /// With one row of figures in place of its curve.
    #[must_use]
    pub fn showing(mut self, figures: &[(&str, &str, f64)]) -> Self {
        let column = |&(name, unit, _): &(&str, &str, f64)| Column { name: name.into(), unit: unit.into() };
        self.curve = Curve {
            columns: figures.iter().map(column).collect(),
            rows: vec![figures.iter().map(|figure| figure.2).collect()],
        };
        self
    }

    /// The words of the warnings, each once, in their order.
    pub fn warnings(&self) -> Vec<&'static str> {
        let mut words: Vec<&str> = self.warnings.iter().map(|warning| warning.kind.word()).collect();
        words.dedup();
        words
    }

    /// Wall time per point of the curve \[s\]; the state at rest, with which paths begin, is not counted.
    pub fn seconds_per_point(&self) -> f64 {
        let at_rest = self.curve.rows.len() > 1 && self.curve.rows[0].iter().all(|&value| value == 0.0);
        let points = self.curve.rows.len() - usize::from(at_rest);
        self.wall_seconds / points.max(1) as f64
    }
}
