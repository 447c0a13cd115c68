//! The analyses, one file each, and the run that hands a body to one of them; what was recorded is kept however the
//! run ends.

mod breaking;
mod criticality;
mod estimate;
mod linear;
mod march;
mod modes;
mod one_solve;
mod path;
mod preload;
mod relaxation;
mod stability;

use std::time::Instant;

pub use estimate::Estimate;

use crate::bodies::{Description, DynamicBody, Model, Ready, Resultant, StaticBody, TangentCost};
use crate::fields::{FieldSink, Frames};
use crate::results::curve::Curve;
use crate::run::Run;
use crate::run::checkpoint::{Checkpoint, CheckpointError, Checkpoints, Stage};
use crate::run::impulses::Impulses;
use crate::run::outcome::{Ended, Failure, Outcome};
use crate::run::progress::Progress;
use crate::run::record::RunRecord;
use crate::run::summary::Summary;
use crate::scene::units::Quantity;
use crate::scene::{Analysis, Damping};

/// What a run is given beside its model.
pub struct RunOptions<'a> {
    /// Who receives the progress and may end it.
    pub progress: &'a mut dyn Progress,
    /// Where its checkpoints go, if it is to write any.
    pub checkpoints: Option<&'a mut Checkpoints>,
    /// Who takes every N-th frame (`output.fields.every` of the scene, else each), if anyone does.
    pub fields: Option<&'a mut dyn FieldSink>,
    /// Where it goes on from, if not from its start.
    pub from: Option<Checkpoint>,
}

impl Model {
    /// Runs to the end, or to divergence. With more than one thread the run has a pool of its own.
    pub fn run(mut self, progress: &mut dyn Progress) -> Outcome {
        let options = RunOptions { progress, checkpoints: None, fields: None, from: None };
        let run = self.nothing_yet(options.progress, None, None);
        self.in_pool(run, None)
    }

    /// The same with options: keeps checkpoints, shows frames, goes on from a checkpoint.
    ///
    /// # Errors
    /// [`CheckpointError::Surface`] and [`CheckpointError::Model`] for the checkpoint of another model.
    pub fn run_with(mut self, options: RunOptions<'_>) -> Result<Outcome, CheckpointError> {
        let RunOptions { progress, mut checkpoints, fields, from } = options;
        if let Some(checkpoints) = &mut checkpoints {
            checkpoints.of(self.body.body(), &self.identity);
        }
        let mut run = self.nothing_yet(progress, checkpoints, fields);
        let stage = match from {
            Some(from) => Some(run.go_on_from(from, self.body.body_mut(), &self.identity)?),
            None => None,
        };
        Ok(self.in_pool(run, stage))
    }

    fn nothing_yet<'a>(
        &mut self,
        progress: &'a mut dyn Progress,
        checkpoints: Option<&'a mut Checkpoints>,
        sink: Option<&'a mut dyn FieldSink>,
    ) -> Run<'a> {
        let driven = self.driven.map(|driven| driven.particle);
        let forces = self.probes.iter().filter(|probe| probe.of.has_mean()).count();
        Run {
            impulses: Impulses::new(forces),
            curve: Curve { columns: self.columns(), rows: Vec::new() },
            shapes: Vec::new(),
            latest: None,
            record: RunRecord::default(),
            probes: std::mem::take(&mut self.probes),
            driven: self.driven,
            force_unit: self.driven.map(|_| self.task.units.symbol(Quantity::Force)),
            supports: None,
            frames: sink.map(|sink| Frames::new(sink, &self.task, driven)),
            progress,
            checkpoints,
        }
    }

    fn in_pool(self, run: Run<'_>, from: Option<Stage>) -> Outcome {
        match rayon::ThreadPoolBuilder::new().num_threads(self.threads).build() {
            Ok(pool) if self.threads > 1 => pool.install(|| self.analyse(run, from)),
            _ => self.analyse(run, from),
        }
    }

    fn analyse(mut self, mut run: Run<'_>, from: Option<Stage>) -> Outcome {
        run.progress.recorded(&run.curve);
        // A checkpoint brings those with which its run began.
        self.warnings.retain(|warning| !run.record.warnings.contains(warning));
        run.record.warnings.splice(0..0, std::mem::take(&mut self.warnings));
        let cells = self.body.body().configuration().cells.to_vec();
        let started = Instant::now();
        let mut ended = match &mut self.body {
            Ready::Dynamic(body) => {
                marched(&self.task.analysis, body.as_mut(), self.description.tangent, &mut run, from)
            }
            Ready::Static(body) => {
                let ended = balanced(&self.task.analysis, body.as_mut(), &mut run, from);
                run.record.warnings.extend(body.warnings());
                ended
            }
        };
        if let Some(frames) = run.frames.take() {
            run.record.frames = frames.taken;
            if let Some(failure) = frames.failure {
                ended = Ended::Diverged(Failure::Fields(failure));
            }
        }
        let Run { curve, mut shapes, latest, mut record, supports, .. } = run;
        let found = self.body.body().diagnostics();
        record.fluid = found.fluid;
        record.warnings.extend(found.warnings);
        shapes.extend(latest);
        // Modes and linear answers are drawn larger than they are.
        if let (Some(judge), true) = (&self.judge, true_to_scale(&self.task.analysis)) {
            let mut reported = judge(&cells, &shapes);
            reported.retain(|warning| record.warnings.iter().all(|known| known.kind != warning.kind));
            record.warnings.extend(reported);
        }
        record.wall_seconds += started.elapsed().as_secs_f64();
        let summary = self.summary(record, supports, &ended);
        Outcome { curve, summary, ended, shapes, cells }
    }

    /// What the model holds and what it leaves out, by its body and by its analysis.
    pub fn describe(&self) -> Description {
        let mut described = self.description.clone();
        let (modelled, left_out) = with_analysis(&self.task.analysis, described.tangent);
        described.modelled.extend(modelled);
        described.left_out.extend(left_out);
        described
    }

    fn summary(self, record: RunRecord, supports: Option<Resultant>, ended: &Ended) -> Summary {
        let mut description = self.describe();
        let Self { task, threads, .. } = self;
        if let Analysis::Explicit(explicit) = &task.analysis {
            let line = stability::left_out(explicit, description.tangent, &record.levels);
            description.left_out.extend(line.filter(|line| !description.left_out.contains(line)));
        }
        let marched = if matches!(task.analysis, Analysis::Explicit(_)) { record.steps } else { 0 };
        Summary {
            title: task.title,
            replaced: Vec::new(),
            analysis: task.analysis.word().into(),
            supports,
            threads,
            particle_steps_per_second: description.particles as f64 * marched as f64 / record.wall_seconds,
            ended: ended.to_string(),
            body: description,
            record,
        }
    }
}

fn marched(
    analysis: &Analysis,
    body: &mut dyn DynamicBody,
    tangent: TangentCost,
    run: &mut Run<'_>,
    from: Option<Stage>,
) -> Ended {
    match analysis {
        Analysis::Explicit(explicit) => march::march(explicit, body, tangent, run, from),
        other => {
            Ended::Diverged(Failure::Kind { analysis: other.kind().name, wanted: "a body without time" })
        }
    }
}

fn balanced(analysis: &Analysis, body: &mut dyn StaticBody, run: &mut Run<'_>, from: Option<Stage>) -> Ended {
    let from = from.filter(|stage| !matches!(stage, Stage::Preload));
    if from.is_none()
        && let Err(ended) = preload::preload(analysis, body, run)
    {
        return *ended;
    }
    match analysis {
        Analysis::Explicit(_) => Ended::Diverged(Failure::Kind {
            analysis: analysis.kind().name,
            wanted: "a body that is marched",
        }),
        Analysis::Linear(wanted) => linear::linear(wanted, body, run),
        Analysis::Static(wanted) if wanted.one_solve => one_solve::one_solve(wanted, body, run, from),
        Analysis::Static(wanted) => path::levels(wanted, body, run, from),
        Analysis::ArcLength(wanted) => path::arc_length(wanted, body, run),
        Analysis::Relaxation(wanted) => relaxation::relaxation(wanted, body, run, from),
        Analysis::Modal(wanted) => modes::modal(wanted.modes, body, run),
        Analysis::Buckling(wanted) => modes::buckling(wanted, body, run),
    }
}

/// Whether shapes are those that the body takes, not enlarged for the eye.
fn true_to_scale(analysis: &Analysis) -> bool {
    !matches!(analysis, Analysis::Linear(_)) && !analysis.kind().gives_modes
}

/// What an analysis adds to what a body models and leaves out.
fn with_analysis(analysis: &Analysis, tangent: TangentCost) -> (Vec<String>, Vec<String>) {
    let none = || "damping".to_string();
    let Analysis::Explicit(explicit) = analysis else {
        let inertia = (!matches!(analysis, Analysis::Modal(_))).then(|| "inertia".to_string());
        let large = matches!(analysis, Analysis::Linear(_)).then(|| "large displacements".to_string());
        return (Vec::new(), inertia.into_iter().chain([none()]).chain(large).collect());
    };
    let damping = match (&explicit.quasi_static, &explicit.transient) {
        (Some(path), _) => match path.damping {
            Damping::Ratio(ratio) => Some(format!("mass-proportional damping, ratio {ratio}")),
            Damping::Kinetic => Some("kinetic damping".into()),
        },
        (None, Some(run)) if run.damping > 0.0 => {
            Some(format!("mass-proportional damping, {} per unit of time", run.damping))
        }
        _ => None,
    };
    let mut left_out = Vec::from_iter(stability::left_out(explicit, tangent, &[]));
    if damping.is_none() {
        left_out.push(none());
    }
    (damping.into_iter().collect(), left_out)
}
