//! The analyses, one file each, and the simulation that leads a body through one of them; what was recorded is kept however it
//! ends.

mod breaking;
mod cases;
mod course;
mod criticality;
mod estimate;
mod frozen;
mod harmonic;
mod harmonic_cases;
mod heat;
mod linear;
mod march;
mod modes;
mod one_solve;
mod path;
mod preload;
mod random_vibration;
mod relaxation;
mod response_spectrum;
mod shaken_modes;
mod simulation;
mod stability;
mod started;
mod swinging;

pub use estimate::Estimate;
pub use simulation::{Event, Simulation};

use implicit_statics::HarmonicDamping;

use crate::bodies::{Description, Model, Resultant, TangentCost};
use crate::fields::{FieldSink, Frames};
use crate::results::curve::Curve;
use crate::run::Run;
use crate::run::base_motion::BaseMotion;
use crate::run::cases_summary::CasesSummary;
use crate::run::checkpoint::{Checkpoint, CheckpointError, Checkpoints, checksum};
use crate::run::contact_watch::ContactWatch;
use crate::run::impulses::Impulses;
use crate::run::outcome::{Ended, Outcome};
use crate::run::progress::Progress;
use crate::run::record::RunRecord;
use crate::run::summary::Summary;
use crate::scene::units::Quantity;
use crate::scene::{Analysis, BaseResponse, Damping};

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
        let run = self.nothing_yet(Some(progress), None, None);
        Simulation::begin(self, run, None).run()
    }

    /// The same with options: keeps checkpoints, shows frames, goes on from a checkpoint.
    ///
    /// # Errors
    /// [`CheckpointError::Surface`] and [`CheckpointError::Model`] for the checkpoint of another model.
    pub fn run_with(self, options: RunOptions<'_>) -> Result<Outcome, CheckpointError> {
        Ok(Simulation::with_options(self, options)?.run())
    }

    fn nothing_yet<'a>(
        &mut self,
        progress: Option<&'a mut dyn Progress>,
        checkpoints: Option<&'a mut Checkpoints>,
        sink: Option<&'a mut dyn FieldSink>,
    ) -> Run<'a> {
        let driven = self.driven.map(|driven| driven.particle);
        let forces = self.probes.iter().filter(|probe| probe.of.has_mean()).count();
        Run {
            contact: ContactWatch::new(match true_to_scale(&self.task.analysis) {
                true => std::mem::take(&mut self.contacts),
                false => std::mem::take(&mut self.contacts).named_only(),
            }),
            impulses: Impulses::new(forces),
            curve: Curve { columns: self.columns(), rows: Vec::new() },
            shapes: Vec::new(),
            latest: None,
            states: self.keeps_states().then(Vec::new),
            record: RunRecord::default(),
            probes: std::mem::take(&mut self.probes),
            driven: self.driven,
            force_unit: self.driven.map(|_| self.task.units.symbol(Quantity::Force)),
            supports: None,
            cases: None,
            vibration: None,
            base: BaseMotion::of(&self.task.analysis),
            frames: sink.map(|sink| Frames::new(sink, &self.task, driven, self.barred.is_some())),
            progress,
            checkpoints,
            ranks: self.ranks.clone(),
        }
    }

    /// Checksum of where its particles are and how they are joined, and of the file that tells it.
    pub(crate) fn checksum(&self) -> u32 {
        checksum(self.body.body(), &self.identity)
    }

    /// Whether the states at its levels serve other lattices, on which the errors of its numbers are found.
    fn keeps_states(&self) -> bool {
        let balanced = matches!(&self.task.analysis, Analysis::Static(wanted) if !wanted.one_solve);
        balanced && self.barred.is_some() && self.driven.is_none()
    }

    /// What the model holds and what it leaves out, by its body and by its analysis.
    pub fn describe(&self) -> Description {
        let mut described = self.description.clone();
        let (modelled, left_out) = with_analysis(&self.task.analysis, described.tangent);
        described.modelled.extend(modelled);
        described.left_out.extend(left_out);
        described
    }

    fn summary(
        self,
        record: RunRecord,
        supports: Option<Resultant>,
        cases: Option<CasesSummary>,
        ended: &Ended,
    ) -> Summary {
        let mut description = self.describe();
        let Self { task, threads, ranks, .. } = self;
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
            cases,
            vibration: None,
            over_time: Vec::new(),
            threads,
            ranks: ranks.map(|ranks| ranks.number()),
            particle_steps_per_second: description.particles as f64 * marched as f64 / record.wall_seconds,
            ended: ended.to_string(),
            errors: None,
            body: description,
            record,
        }
    }
}

/// Whether shapes are those that the body takes, not enlarged for the eye.
fn true_to_scale(analysis: &Analysis) -> bool {
    !(matches!(analysis, Analysis::Linear(_)) || analysis.swings() || analysis.kind().gives_modes)
}

/// What an analysis adds to what a body models and leaves out.
fn with_analysis(analysis: &Analysis, tangent: TangentCost) -> (Vec<String>, Vec<String>) {
    let none = || "damping".to_string();
    match analysis {
        Analysis::Harmonic(wanted) => {
            return of_vibration(wanted.damped(), wanted.base.map(|base| shaken(base.response)));
        }
        Analysis::ResponseSpectrum(wanted) => {
            let bases =
                format!("acceleration of all that holds the body by {} response spectra", wanted.base.len());
            return of_vibration(wanted.damping.damped(), Some(bases));
        }
        Analysis::RandomVibration(wanted) => {
            let loads = if wanted.loads.is_some() { " and of the loads" } else { "" };
            let bases = format!("noise of {} bases{loads}, Gaussian and steady", wanted.base.len());
            return of_vibration(wanted.damping.damped(), Some(bases));
        }
        _ => {}
    }
    if let Analysis::Heat(wanted) = analysis {
        let course = wanted.transient.is_none().then_some("a course of temperatures in time");
        return (Vec::new(), ["motion"].into_iter().chain(course).map(String::from).collect());
    }
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
        (None, Some(run)) if run.damping.get() > 0.0 => {
            Some(format!("mass-proportional damping, {} per unit of time", run.damping))
        }
        _ => None,
    };
    let mut left_out = Vec::from_iter(stability::left_out(explicit, tangent, &[]));
    if damping.is_none() {
        left_out.push(none());
    }
    let base = explicit.transient.as_ref().and_then(|run| run.base.as_ref());
    let base = base.map(|base| shaken(base.response));
    (damping.into_iter().chain(base).collect(), left_out)
}

/// A base that is shaken.
fn shaken(response: BaseResponse) -> String {
    let to = match response {
        BaseResponse::Relative => "to the base",
        BaseResponse::Absolute => "to space",
    };
    format!("acceleration of all that holds the body, displacements with respect {to}")
}

/// What a vibration adds.
fn of_vibration(damping: HarmonicDamping, shaken: Option<String>) -> (Vec<String>, Vec<String>) {
    let damping = match damping {
        HarmonicDamping::None => None,
        HarmonicDamping::Ratio(ratio) => Some(format!("damping of {ratio} of the critical one in each mode")),
        HarmonicDamping::Rayleigh { mass, stiffness } => Some(format!(
            "damping by mass, {mass} per unit of time, and by stiffness, {stiffness} units of time"
        )),
        HarmonicDamping::Structural(loss) => Some(format!("structural damping, loss factor {loss}")),
    };
    let mut left_out = vec!["large displacements".to_string()];
    left_out.extend(damping.is_none().then(|| "damping".to_string()));
    (damping.into_iter().chain(shaken).collect(), left_out)
}
