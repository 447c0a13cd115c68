//! A run that is led event by event: the caller decides when it goes on, reads the body in between and may change it.

use std::ops::ControlFlow;
use std::time::Instant;

use explicit_dynamics::Instant as Moment;
use mesh_io::{FieldError, Sheet};

use super::cases::Cases;
use super::course::Course;
use super::preload::preload;
use super::{RunOptions, true_to_scale};
use crate::bodies::{Body, Mismatch, Model, Ready, StateArray};
use crate::fields::Frame;
use crate::results::curve::Curve;
use crate::run::Run;
use crate::run::checkpoint::{CheckpointError, Stage};
use crate::run::contact_watch::ContactWatch;
use crate::run::glue_watch;
use crate::run::outcome::{Ended, Failure, Outcome};
use crate::run::over_time::OverTime;
use crate::scene::Analysis;

/// A run under way: a model, how far its analysis has come, and what was found so far.
///
/// [`Simulation::advance`] goes on to the next event. Between two events the body may be read and its state replaced; a simulation that
/// is left alone gives the bits of [`Model::run`], which is a loop over its events.
///
/// | analysis | an event is |
/// |---|---|
/// | `explicit` | a step (two where one of them shows the period), and a record of the state before one |
/// | `static`, `relaxation` | a level found; the first has the row of the start as well |
/// | `linear` with load cases | a case or a combination |
/// | `heat` in time | a row of the curve |
/// | else `linear`, `arc-length`, `modal`, `harmonic`, `response-spectrum`, `random-vibration`, `buckling`, `heat` | all of it at once |
///
/// A preload is an event of its own. Wall time is counted from the beginning, with what the caller does in between.
///
/// ```
/// use coque::{Event, Scene, Simulation};
/// use coque::scene::Measured;
/// use sph_core::Vec3;
///
/// let text = r#"
/// title = "A plate let go"
/// units = { length = "m", force = "N", time = "s" }
/// geometry.plate = { lengths = [1.0, 0.2], particles = [11, 3] }
/// material.elastic = { young = 1e6, poisson = 0.3, density = 1.0 }
/// section.homogeneous = { thickness = 0.05 }
/// supports = [{ on = "u0", clamped = {} }]
/// loads = [{ on = "u1", force = { total = [0.0, 0.0, 1.0] } }]
/// analysis.explicit.transient = { duration = 0.2, record_every = 0.02 }
/// curve = [{ name = "w", of = "displacement", on = "u1", direction = [0.0, 0.0, 1.0] }]
/// "#;
/// let mut simulation = Simulation::new(Scene::parse(text, "plate.toml")?.build(1)?);
/// let mut highest = 0.0_f64;
/// while simulation.advance()? != Event::End {
///     let tip = simulation.body().configuration().rest.len() - 1;
///     highest = highest.max(simulation.body().read(Measured::Displacement, tip, &Vec3::z()));
///     if highest > 0.2 {
///         break;
///     }
/// }
/// let outcome = simulation.finish();
/// assert!(highest > 0.2 && outcome.curve.rows.len() > 1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Simulation<'a> {
    model: Model,
    run: Run<'a>,
    course: Course,
    /// Whether a preload may have to come first.
    preloads: bool,
    ended: Option<Ended>,
    pool: Option<rayon::ThreadPool>,
    started: Instant,
}

/// What has happened to a simulation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Event {
    /// A step in time is done, or the preload is applied: the body stands between two steps.
    Step,
    /// The curve has grown, and the body is in the state of its last row, its forces those of that state. In time the velocities are half
    /// a step ahead.
    Record,
    /// The run is over, [`Simulation::ended`] says how.
    End,
}

impl Simulation<'static> {
    /// From the start, without a report to anyone. With more than one thread it has a pool of its own.
    pub fn new(mut model: Model) -> Self {
        let run = model.nothing_yet(None, None, None);
        Self::begin(model, run, None)
    }
}

impl<'a> Simulation<'a> {
    /// The same with options: tells its progress, keeps checkpoints, shows frames, goes on from a checkpoint.
    ///
    /// # Errors
    /// [`CheckpointError::Surface`] and [`CheckpointError::Model`] for the checkpoint of another model.
    pub fn with_options(mut model: Model, options: RunOptions<'a>) -> Result<Self, CheckpointError> {
        let RunOptions { progress, mut checkpoints, fields, from } = options;
        if let Some(checkpoints) = &mut checkpoints {
            checkpoints.of(model.body.body(), &model.identity);
        }
        let mut run = model.nothing_yet(Some(progress), checkpoints, fields);
        let stage = match from {
            Some(from) => Some(run.go_on_from(from, model.body.body_mut(), &model.identity)?),
            None => None,
        };
        Ok(Self::begin(model, run, stage))
    }

    pub(super) fn begin(mut model: Model, mut run: Run<'a>, from: Option<Stage>) -> Self {
        run.show_curve();
        // A checkpoint brings those with which its run began.
        model.warnings.retain(|warning| !run.record.warnings.contains(warning));
        run.record.warnings.splice(0..0, std::mem::take(&mut model.warnings));
        let pool =
            (model.threads > 1).then(|| rayon::ThreadPoolBuilder::new().num_threads(model.threads).build());
        let particles = model.body.body().configuration().rest.len();
        let from = from.filter(|stage| !matches!(stage, Stage::Preload));
        Self {
            preloads: from.is_none(),
            course: match (model.cases.take(), model.shaken.take(), model.water.take(), &model.task.analysis)
            {
                (Some(scene), _, _, Analysis::Harmonic(_)) => Course::HarmonicCases(scene, model.threads),
                (Some(cases), ..) => Course::Cases(Box::new(Cases::new(*cases, model.threads))),
                (None, Some(scene), ..) => Course::Shaken(scene, model.threads),
                (None, None, Some(water), &Analysis::Modal(wanted)) => Course::WetModes(wanted, water),
                (None, None, ..) => Course::new(
                    &model.task.analysis,
                    (model.description.tangent, particles),
                    from,
                    std::mem::take(&mut model.increments),
                ),
            },
            run,
            ended: None,
            pool: pool.and_then(Result::ok),
            started: Instant::now(),
            model,
        }
    }

    /// Goes on to the next event. Behind a failure, as behind the end, there is nothing but [`Event::End`].
    ///
    /// With more than one thread every call is handed over to the pool and back; [`Simulation::run`] is handed over once.
    ///
    /// # Errors
    /// Why the run does not reach its end; curve and body hold what came before.
    pub fn advance(&mut self) -> Result<Event, Box<Failure>> {
        let rows = self.run.curve.rows.len();
        if self.ended.is_some() {
            return Ok(Event::End);
        }
        self.in_pool(Self::go_on);
        match &self.ended {
            Some(Ended::Diverged(failure)) => Err(Box::new(failure.clone())),
            _ if self.run.curve.rows.len() > rows => Ok(Event::Record),
            Some(_) => Ok(Event::End),
            None => Ok(Event::Step),
        }
    }

    /// Goes on to the end, or to a failure, which is in the outcome.
    pub fn run(mut self) -> Outcome {
        self.in_pool(|simulation| {
            while simulation.ended.is_none() {
                simulation.go_on();
            }
        });
        self.finish()
    }

    /// Ends it: what it leaves behind. One that has not come to its end is interrupted where it stands, with a checkpoint if it writes any.
    pub fn finish(mut self) -> Outcome {
        if self.ended.is_none() {
            self.in_pool(|simulation| {
                let Self { model, run, course, ended, .. } = simulation;
                *ended = Some(course.interrupt(&mut model.body, run));
            });
        }
        self.outcome()
    }

    /// The body. Forces are those of the last evaluation: of the last row at [`Event::Record`].
    pub fn body(&self) -> &dyn Body {
        self.model.body.body()
    }

    /// Puts the body into another state, from which the analysis goes on; in time between two steps, behind [`Event::Step`].
    ///
    /// # Errors
    /// [`Mismatch`], and nothing changed, for the state of another body.
    pub fn set_state(&mut self, state: &[StateArray<'_>]) -> Result<(), Mismatch> {
        self.model.body.body_mut().set_state(state)
    }

    /// The fields of the body as it is now, in memory: its surface, as [`crate::FieldFiles`] writes it. Linear answers and modes are
    /// no states that it is in.
    ///
    /// # Errors
    /// [`FieldError`] for a body that writes its fields out of their order; none is known.
    pub fn sheet(&self, stresses: bool) -> Result<Sheet, FieldError> {
        self.frame().sheet(stresses)
    }

    /// The body as it is now, for whoever evaluates its fields.
    pub fn frame(&self) -> Frame<'_> {
        let driven = self.model.driven.map(|driven| driven.particle);
        Frame::present(self.body(), &self.model.task, driven, self.stands_at())
    }

    /// Time \[T\], zero without time, and the load level: the present one in time, else the last one found.
    pub fn stands_at(&self) -> Moment {
        self.course.stands_at()
    }

    /// The curve so far.
    pub fn curve(&self) -> &Curve {
        &self.run.curve
    }

    /// How it ended; none while it is under way.
    pub fn ended(&self) -> Option<&Ended> {
        self.ended.as_ref()
    }

    /// Does the next part of the analysis.
    fn go_on(&mut self) {
        let Self { model, run, course, .. } = self;
        let flow = match &mut model.body {
            Ready::Static(body) if std::mem::take(&mut self.preloads) => {
                match preload(&model.task.analysis, body.as_mut(), run) {
                    Ok(true) => return,
                    Ok(false) => course.advance(&model.task.analysis, &mut model.body, run),
                    Err(ended) => ControlFlow::Break(*ended),
                }
            }
            _ => course.advance(&model.task.analysis, &mut model.body, run),
        };
        if let ControlFlow::Break(ended) = flow {
            let failure = run.frames.as_mut().and_then(|frames| frames.failure.take());
            self.ended = Some(failure.map_or(ended, |failure| Ended::Diverged(Failure::Fields(failure))));
        }
    }

    /// Works in the pool of the simulation, if it has one and does not do so already, and there in what surrounds the work.
    fn in_pool(&mut self, work: impl FnOnce(&mut Self) + Send) {
        match self.pool.take() {
            Some(pool) => {
                pool.install(|| self.surrounded(work));
                self.pool = Some(pool);
            }
            None => self.surrounded(work),
        }
    }

    fn surrounded(&mut self, work: impl FnOnce(&mut Self) + Send) {
        let Some(surrounding) = self.model.surrounding else { return work(self) };
        let mut work = Some(work);
        surrounding(&mut || {
            if let Some(work) = work.take() {
                work(self);
            }
        });
    }

    fn outcome(self) -> Outcome {
        let at = self.course.stands_at();
        let Self { model, mut run, ended, started, .. } = self;
        let ended = ended.unwrap_or_default();
        run.contact.look(model.body.body(), [at.time, at.level], &mut run.record);
        let Run { curve, mut shapes, latest, states, mut record, supports, cases, vibration, frames, .. } =
            run;
        if let Ready::Static(body) = &model.body {
            record.warnings.extend(body.warnings());
        }
        if let Some(frames) = frames {
            record.frames = frames.taken;
        }
        let found = model.body.body().diagnostics();
        record.fluid = found.fluid;
        record.warnings.extend(found.warnings);
        ContactWatch::judge(&mut record);
        let internal = curve.column("internal").unwrap_or_default();
        glue_watch::judge(&mut record, internal.into_iter().fold(0.0, f64::max));
        shapes.extend(latest);
        let cells = model.body.body().configuration().cells.to_vec();
        // Modes and linear answers are drawn larger than they are.
        if let (Some(judge), true) = (&model.judge, true_to_scale(&model.task.analysis)) {
            let mut reported = judge(&cells, &shapes);
            reported.retain(|warning| record.warnings.iter().all(|known| known.kind != warning.kind));
            record.warnings.extend(reported);
        }
        record.wall_seconds += started.elapsed().as_secs_f64();
        let over_time = model.task.output.over_time.then(|| {
            let first = model.task.analysis.columns().count();
            OverTime::of(&curve, first)
        });
        let mut summary = model.summary(record, supports, cases, &ended);
        summary.vibration = vibration;
        summary.over_time = over_time.unwrap_or_default();
        let states = states.unwrap_or_default();
        Outcome { curve, summary, ended, shapes, states, cells }
    }
}
