//! The run: marches a model and watches it; what was recorded is kept however the run ends.

use std::ops::ControlFlow;
use std::time::Instant;

use explicit_dynamics::{Clock, LevelReached, MarchError, Observer, Record, largest_eigenvalue, stable_step};
use sph_core::{Cell, Vec3};
use sph_shell::Shell;

use crate::build::Model;
use crate::curve::Curve;
use crate::probe::{Gauge, always};
use crate::scene::{Analysis, Damping, Explicit};
use crate::summary::{Energies, LevelSummary, Summary};

/// Told now and then how far a run is.
pub trait Progress: Send {
    /// `done` goes from 0 to 1.
    fn update(&mut self, done: f64, record: &Record);
}

/// Tells nobody.
#[derive(Clone, Copy, Debug, Default)]
pub struct Silent;

impl Progress for Silent {
    fn update(&mut self, _: f64, _: &Record) {}
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
    /// Deformed shapes: the start and every settled level of a quasi-static run, else the last record.
    pub shapes: Vec<Shape>,
    /// Cells between the particles, for pictures.
    pub cells: Vec<Cell>,
}

/// How a run ended.
#[derive(Clone, Debug, PartialEq)]
pub enum Ended {
    /// It reached its end.
    Done,
    /// It did not; curve and shapes hold what came before.
    Diverged(MarchError),
}

/// A deformed shape.
#[derive(Clone, Debug, PartialEq)]
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

/// Lanczos steps for the stable step that the summary reports.
const LANCZOS_STEPS: usize = 30;

impl Model {
    /// Marches to the end, or to divergence. With more than one thread the run has a pool of its own.
    pub fn run(self, progress: &mut dyn Progress) -> Outcome {
        let threads = self.threads;
        match rayon::ThreadPoolBuilder::new().num_threads(threads).build() {
            Ok(pool) if threads > 1 => pool.install(|| self.march(progress)),
            _ => self.march(progress),
        }
    }

    fn march(mut self, progress: &mut dyn Progress) -> Outcome {
        let described = self.describe();
        let Analysis::Explicit(explicit) = &self.scene.analysis;
        let started = Instant::now();
        let spectrum = largest_eigenvalue(&mut self.shell, LANCZOS_STEPS);
        let mut watcher = Watcher {
            curve: Curve { columns: always(&self.scene.units), rows: Vec::new() },
            gauges: std::mem::take(&mut self.gauges),
            keep_settled: explicit.quasi_static.is_some(),
            shapes: Vec::new(),
            last: None,
            levels: Vec::new(),
            progress,
        };
        watcher.curve.columns.extend(watcher.gauges.iter().map(|gauge| gauge.column(&self.scene.units)));
        let marched = march(explicit, &mut self.shell, &mut watcher);
        let wall_seconds = started.elapsed().as_secs_f64();
        let Watcher { curve, shapes, last, levels, .. } = watcher;
        let (steps, ended) = match marched {
            Ok(clock) => (clock.steps, Ended::Done),
            Err(error) => {
                let steps = match error {
                    MarchError::Diverged { step, .. } => step,
                    _ => 0,
                };
                (steps, Ended::Diverged(error))
            }
        };
        let cloud = &self.shell.reference().cloud;
        let summary = Summary {
            title: self.scene.title.clone(),
            method: self.scene.formulation.describe(),
            particles: described.particles,
            points: described.points,
            dof: described.freedoms,
            spacing: cloud.spacing(),
            steps,
            threads: self.threads,
            stable_step: stable_step(&spectrum, 1.0).unwrap_or(0.0),
            safety: explicit.safety,
            wall_seconds,
            particle_steps_per_second: described.particles as f64 * steps as f64 / wall_seconds,
            energies: last.map(energies).unwrap_or_default(),
            levels,
            modelled: described.modelled,
            left_out: described.left_out,
            ended: match &ended {
                Ended::Done => "done".into(),
                Ended::Diverged(error) => error.to_string(),
            },
        };
        Outcome { curve, summary, ended, shapes, cells: cloud.cells.clone() }
    }
}

fn march(explicit: &Explicit, shell: &mut Shell, watcher: &mut Watcher<'_>) -> Result<Clock, MarchError> {
    let safety = explicit.safety;
    match (&explicit.quasi_static, explicit.transient) {
        (Some(path), _) => explicit_dynamics::QuasiStatic {
            levels: path.levels.list(),
            period: path.period,
            ramp: path.ramp,
            hold: path.hold,
            damping: match path.damping {
                Damping::Ratio(ratio) => explicit_dynamics::Damping::Ratio(ratio),
                Damping::Kinetic => explicit_dynamics::Damping::Kinetic,
            },
            tolerance: path.tolerance,
            safety,
        }
        .march(shell, watcher),
        (None, transient) => {
            // Neither table cannot pass the checks; a duration of nought would be refused here too.
            let run = transient.unwrap_or(crate::scene::Transient {
                duration: 0.0,
                record_every: 0.0,
                damping: 0.0,
            });
            let run = explicit_dynamics::Transient {
                duration: run.duration,
                record_every: run.record_every,
                damping: run.damping,
                safety,
            };
            run.march(shell, watcher)
        }
    }
}

fn energies(record: Record) -> Energies {
    let energy = record.energy;
    Energies {
        kinetic: energy.kinetic,
        internal: energy.internal,
        external: energy.external,
        dissipated: energy.dissipated,
        balance_error: record.balance_error,
    }
}

/// Fills the curve and keeps shapes; the place where field output plugs in.
struct Watcher<'a> {
    curve: Curve,
    gauges: Vec<Gauge>,
    keep_settled: bool,
    shapes: Vec<Shape>,
    last: Option<Record>,
    levels: Vec<LevelSummary>,
    progress: &'a mut dyn Progress,
}

impl Observer<Shell> for Watcher<'_> {
    fn record(&mut self, shell: &mut Shell, record: &Record) -> ControlFlow<()> {
        let energy = record.energy;
        let mut row = vec![
            record.at.time,
            record.at.level,
            energy.kinetic,
            energy.internal,
            energy.external,
            energy.dissipated,
        ];
        row.extend(self.gauges.iter_mut().map(|gauge| gauge.read(shell)));
        self.curve.rows.push(row);
        self.last = Some(*record);
        if !self.keep_settled {
            self.shapes.clear();
        }
        if (record.settled || !self.keep_settled) && (self.shapes.len() + 1) * shell.len() <= MOST_POSITIONS {
            let positions = (0..shell.len()).map(|a| shell.position(a)).collect();
            self.shapes.push(Shape { time: record.at.time, level: record.at.level, positions });
        }
        ControlFlow::Continue(())
    }

    fn level(&mut self, reached: &LevelReached) {
        let LevelReached { level, settled, kinetic_over_internal, steps } = *reached;
        self.levels.push(LevelSummary { level, settled, kinetic_over_internal, steps });
    }

    fn progress(&mut self, done: f64, record: &Record) {
        self.progress.update(done, record);
    }
}
