//! The run: hands a model to its analysis; what was recorded is kept however the run ends.

pub(crate) mod checkpoint;
pub(crate) mod estimate;
mod file;
pub(crate) mod memory;

use std::fmt;
use std::ops::ControlFlow;
use std::time::Instant;

use explicit_dynamics::MarchError;
use implicit_statics::EquilibriumError;
use serde::{Deserialize, Serialize};
use sph_core::{Cell, Vec3};
use sph_shell::{Shell, StaticShell};

use crate::analyses::linear::linear;
use crate::analyses::march::march;
use crate::analyses::modes::{buckling, modal};
use crate::analyses::path::{arc_length, levels};
use crate::analyses::stability;
use crate::bodies::probe::columns;
use crate::bodies::shell::build::Model;
use crate::bodies::shell::doubts::doubts_of_shapes;
use crate::fields::{FieldError, FieldSink, Frames};
use crate::results::curve::Curve;
use crate::results::summary::{CountSummary, CriticalSummary, Energies, LevelSummary, Summary};
use crate::run::checkpoint::{Checkpoint, CheckpointError, Checkpoints, Place};
use crate::scene::Analysis;
use crate::scene::units::Quantity;
use crate::{Doubt, Warning};

/// How a run is going.
#[derive(Clone, Copy, Debug, Default)]
pub struct ProgressReport {
    /// Part that is done, from 0 to 1; a guess where levels may settle early.
    pub done: f64,
    /// Time \[T\]; zero without time.
    pub time: f64,
    /// Load level.
    pub level: f64,
    /// Steps done; without time the points found.
    pub steps: u64,
    /// Kinetic energy \[F L\].
    pub kinetic: f64,
    /// Internal energy when it was last evaluated \[F L\].
    pub internal: f64,
}

/// Told how a run is going, between any two steps in time, at every point of a path without time.
pub trait Progress: Send {
    /// `Break` ends the run in good order.
    fn update(&mut self, news: &ProgressReport) -> ControlFlow<()>;

    /// Told the curve as a run begins, and again whenever it has grown.
    fn recorded(&mut self, _curve: &Curve) {}

    /// Told what the run cannot do but goes on without.
    fn warn(&mut self, _message: &str) {}
}

/// Tells nobody.
#[derive(Clone, Copy, Debug, Default)]
pub struct Silent;

impl Progress for Silent {
    fn update(&mut self, _: &ProgressReport) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }
}

/// What a run is given beside its model.
pub struct RunOptions<'a> {
    /// Who is told how it goes, and may end it.
    pub progress: &'a mut dyn Progress,
    /// Where its checkpoints go, if it is to write any.
    pub checkpoints: Option<&'a mut Checkpoints>,
    /// Who takes every N-th frame (`output.fields.every` of the scene, else each), if anyone does.
    pub fields: Option<&'a mut dyn FieldSink>,
    /// Where it goes on from, if not from its start.
    pub from: Option<Checkpoint>,
}

/// What a run leaves behind.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// One row per record.
    pub curve: Curve,
    /// What it was and what it cost.
    pub summary: Summary,
    /// How it ended.
    pub ended: Ended,
    /// Deformed shapes: the start and every settled level of a quasi-static or static run, every point of a path,
    /// a linear answer and every mode scaled to a tenth of the extent, else the last record.
    pub shapes: Vec<Shape>,
    /// Cells between the particles, for pictures.
    pub cells: Vec<Cell>,
}

/// How a run ended.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Ended {
    /// It reached its end.
    #[default]
    Done,
    /// It did not; curve and shapes hold what came before.
    Diverged(Failure),
    /// It was ended from outside; curve and shapes hold what came before.
    Interrupted {
        /// Time \[T\]; zero without time.
        time: f64,
        /// Load level.
        level: f64,
    },
}

impl fmt::Display for Ended {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Done => f.write_str("done"),
            Self::Diverged(failure) => failure.fmt(f),
            Self::Interrupted { time, level } if *time > 0.0 => {
                write!(f, "interrupted at time {time:.6e}, level {level:.6}")
            }
            Self::Interrupted { level, .. } => write!(f, "interrupted at level {level:.6}"),
        }
    }
}

/// Why a run did not reach its end.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Failure {
    /// The march in time failed.
    #[error(transparent)]
    March(#[from] MarchError),
    /// A balance was not found.
    #[error("no balance after {points} points, the last at level {level}: {cause}{}{}", causes(.cause), forces(.unit))]
    Balance {
        /// Points found.
        points: u64,
        /// Level of the last one, as in the curve.
        level: f64,
        /// What happened.
        cause: EquilibriumError,
        /// Unit of the load levels that the cause names, where they are forces.
        unit: Option<String>,
    },
    /// A path was still under way.
    #[error("the path is still under way after {steps} steps, at level {level}; {repair}")]
    Steps {
        /// Steps made.
        steps: usize,
        /// Level of the last point.
        level: f64,
        /// What to do about it.
        repair: &'static str,
    },
    /// A frame of fields could not be written.
    #[error(transparent)]
    Fields(#[from] FieldError),
}

impl Failure {
    /// Whether the scene asked for what cannot be done, or the disk has no room: nothing diverged.
    pub fn is_input(&self) -> bool {
        match self {
            Self::Fields(_) | Self::March(MarchError::Option { .. }) => true,
            Self::Balance { cause, .. } => matches!(cause, EquilibriumError::Option { .. }),
            _ => false,
        }
    }
}

/// Says what a load level is where it is a force.
fn forces(unit: &Option<String>) -> String {
    match unit.as_deref() {
        None => String::new(),
        Some("-") => "; load levels there are forces".into(),
        Some(unit) => format!("; load levels there are forces in {unit}"),
    }
}

/// The causes behind an error, in brackets.
fn causes(error: &EquilibriumError) -> String {
    let first = std::error::Error::source(error);
    std::iter::successors(first, |cause| cause.source()).map(|cause| format!(" ({cause})")).collect()
}

/// A deformed shape.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Shape {
    /// Time \[T\].
    pub time: f64,
    /// Load level.
    pub level: f64,
    /// Positions of the particles \[L\].
    pub positions: Vec<Vec3>,
}

/// Positions kept in all shapes together: half a gigabyte.
const MOST_POSITIONS: usize = 20_000_000;

/// What an analysis leaves behind, for the outcome.
#[derive(Default)]
pub(crate) struct Findings<'a> {
    pub(crate) curve: Curve,
    pub(crate) shapes: Vec<Shape>,
    pub(crate) ended: Ended,
    pub(crate) steps: u64,
    pub(crate) stable_step: f64,
    pub(crate) safety: f64,
    pub(crate) energies: Energies,
    pub(crate) levels: Vec<LevelSummary>,
    pub(crate) newton_iterations: u64,
    pub(crate) critical: Vec<CriticalSummary>,
    pub(crate) warnings: Vec<Warning>,
    pub(crate) counted: Option<CountSummary>,
    /// Unit of the force that is the level of paths, where a prescribed motion drives them.
    pub(crate) force_unit: Option<String>,
    /// Wall time of earlier sittings \[s\].
    pub(crate) seconds: f64,
    /// Where frames of fields go, if anywhere.
    pub(crate) frames: Option<Frames<'a>>,
}

impl Findings<'_> {
    /// Keeps the present shape, as long as there is room, and offers it as a frame; `Break` if that cannot go on.
    ///
    /// The forces of the shell must be those of its state.
    pub(crate) fn keep_shape(&mut self, shell: &Shell, time: f64, level: f64) -> ControlFlow<()> {
        self.keep_positions((0..shell.len()).map(|a| shell.position(a)).collect(), time, level);
        self.frames.as_mut().map_or(ControlFlow::Continue(()), |frames| frames.offer(shell, time, level))
    }

    /// Warns of loads whose stiffness is not symmetric, where stability is told from the symmetric part.
    pub(crate) fn warn_of_skew_loads(&mut self, system: &StaticShell) {
        let share = system.skew_load_share();
        if share > 0.0 {
            let message = format!(
                "the loads have no potential: entries of up to {share:.2} of the largest in their stiffness are skew \
                 (pressure over free edges, couples about moving edges) and left out of the tangent; equilibria are \
                 exact, but critical levels and negative pivots are those of the symmetric part, and flutter is not \
                 looked for: check with [analysis.explicit.transient]"
            );
            self.warnings.push(Warning::new(Doubt::NoPotential, message));
        }
    }

    pub(crate) fn keep_positions(&mut self, positions: Vec<Vec3>, time: f64, level: f64) {
        if (self.shapes.len() + 1) * positions.len() <= MOST_POSITIONS {
            self.shapes.push(Shape { time, level, positions });
        }
    }
}

impl Model {
    /// Runs to the end, or to divergence. With more than one thread the run has a pool of its own.
    pub fn run(self, progress: &mut dyn Progress) -> Outcome {
        let found = self.nothing_yet(None);
        progress.recorded(&found.curve);
        self.in_pool(RunOptions { progress, checkpoints: None, fields: None, from: None }, found, None)
    }

    /// The same with options: keeps checkpoints, shows frames, goes on from a checkpoint.
    ///
    /// # Errors
    /// [`CheckpointError::Surface`] and [`CheckpointError::Model`] for the checkpoint of another model.
    pub fn run_with(mut self, mut options: RunOptions<'_>) -> Result<Outcome, CheckpointError> {
        let mut found = self.nothing_yet(options.fields.take());
        if let Some(checkpoints) = &mut options.checkpoints {
            checkpoints.of(&self);
        }
        let from = options.from.take().map(|from| from.put_into(&mut self, &mut found)).transpose()?;
        options.progress.recorded(&found.curve);
        Ok(self.in_pool(options, found, from))
    }

    fn nothing_yet<'a>(&self, sink: Option<&'a mut dyn FieldSink>) -> Findings<'a> {
        let curve = Curve { columns: columns(self), rows: Vec::new() };
        let force_unit = self.driven.map(|_| self.scene.units.symbol(Quantity::Force));
        let driven = self.driven.map(|driven| driven.particle);
        let frames = sink.map(|sink| Frames::new(sink, &self.scene, driven));
        Findings { curve, frames, force_unit, ..Findings::default() }
    }

    fn in_pool(self, mut options: RunOptions<'_>, found: Findings<'_>, from: Option<Place>) -> Outcome {
        let threads = self.threads;
        match rayon::ThreadPoolBuilder::new().num_threads(threads).build() {
            Ok(pool) if threads > 1 => pool.install(|| self.analyse(&mut options, found, from)),
            _ => self.analyse(&mut options, found, from),
        }
    }

    fn analyse(self, options: &mut RunOptions<'_>, mut found: Findings<'_>, from: Option<Place>) -> Outcome {
        let described = self.describe();
        let Self { mut shell, scene, gauges, driven, threads, mut warnings, .. } = self;
        let (loss, area) = (shell.chord_loss(), shell.reference().cloud.areas.iter().sum());
        // A checkpoint brings those with which its run began.
        warnings.retain(|warning| !found.warnings.contains(warning));
        found.warnings.splice(0..0, warnings);
        let (cells, spacing) = (shell.reference().cloud.cells.clone(), shell.reference().cloud.spacing());
        let started = Instant::now();
        match &scene.analysis {
            Analysis::Explicit(explicit) => march(explicit, &mut shell, gauges, &mut found, options, from),
            Analysis::Linear(_) => {
                let progress = &mut *options.progress;
                linear(&mut StaticShell::new(shell), driven, gauges, &mut found, progress);
            }
            Analysis::Static(path) => {
                let mut system = StaticShell::new(shell);
                found.warn_of_skew_loads(&system);
                levels(path, &mut system, driven, gauges, &mut found, (options, from));
            }
            Analysis::ArcLength(path) => {
                let progress = &mut *options.progress;
                let mut system = StaticShell::new(shell);
                found.warn_of_skew_loads(&system);
                arc_length(path, &mut system, driven, gauges, &mut found, progress);
            }
            // Refused when the model is built, until it is.
            Analysis::Relaxation(_) => {}
            Analysis::Modal(wanted) => modal(wanted.modes, shell, &mut found, &mut *options.progress),
            Analysis::Buckling(wanted) => buckling(wanted, shell, &mut found, &mut *options.progress),
        }
        let mut frames = 0;
        if let Some(shown) = found.frames.take() {
            frames = shown.taken;
            if let Some(failure) = shown.failure {
                found.ended = Ended::Diverged(failure);
            }
        }
        // Modes and linear answers are drawn larger than they are.
        if matches!(scene.analysis, Analysis::Explicit(_) | Analysis::Static(_) | Analysis::ArcLength(_)) {
            let mut told = doubts_of_shapes(&cells, loss, area, &found.shapes);
            told.retain(|warning| found.warnings.iter().all(|known| known.doubt != warning.doubt));
            found.warnings.extend(told);
        }
        let wall_seconds = found.seconds + started.elapsed().as_secs_f64();
        let marched = if matches!(scene.analysis, Analysis::Explicit(_)) { found.steps } else { 0 };
        let Findings { curve, shapes, ended, steps, stable_step, safety, energies, levels, .. } = found;
        let mut left_out = described.left_out;
        if let Some(line) = stability::left_out(&scene, &levels).filter(|line| !left_out.contains(line)) {
            left_out.push(line);
        }
        let summary = Summary {
            title: scene.title.clone(),
            replaced: Vec::new(),
            analysis: scene.analysis.word().into(),
            method: scene.shell().formulation.describe(),
            particles: described.particles,
            points: described.points,
            dof: described.freedoms,
            spacing,
            steps,
            newton_iterations: found.newton_iterations,
            critical: found.critical,
            threads,
            stable_step,
            safety,
            wall_seconds,
            particle_steps_per_second: described.particles as f64 * marched as f64 / wall_seconds,
            energies,
            levels,
            warnings: found.warnings,
            counted: found.counted,
            frames,
            modelled: described.modelled,
            left_out,
            ended: ended.to_string(),
        };
        Outcome { curve, summary, ended, shapes, cells }
    }
}
