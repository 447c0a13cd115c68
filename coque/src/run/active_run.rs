//! A run under way: what it has found, what it measures, whom it tells.

use std::borrow::Cow;
use std::ops::ControlFlow;

use implicit_statics::EquilibriumError;
use peers::Peers;

use super::base_motion::BaseMotion;
use super::cases_summary::CasesSummary;
use super::checkpoint::{Checkpoint, CheckpointError, Checkpoints, Contents, Stage, checksum};
use super::contact_watch::ContactWatch;
use super::impulses::Impulses;
use super::outcome::{Ended, Failure};
use super::progress::{Progress, ProgressReport};
use super::record::RunRecord;
use super::vibration_summary::VibrationSummary;
use crate::WarningKind;
use crate::bodies::{Body, Configuration, Identity, PrescribedPoint, Probe, Resultant, Shape};
use crate::fields::Frames;
use crate::ranks::{Ranks, Word};
use crate::results::curve::Curve;

/// Positions kept in all shapes together: half a gigabyte.
const MOST_POSITIONS: usize = 20_000_000;

/// A run under way.
pub(crate) struct Run<'a> {
    pub curve: Curve,
    /// Deformed shapes, one after the other.
    pub shapes: Vec<Shape>,
    /// The shape at the last record, where none before it is kept.
    pub latest: Option<Shape>,
    /// States at the start and at every level, if they are kept.
    pub states: Option<Vec<Vec<f64>>>,
    pub record: RunRecord,
    pub probes: Vec<Probe>,
    /// What the forces among them did since the last record.
    pub impulses: Impulses,
    /// The prescribed motion whose force is sought.
    pub driven: Option<PrescribedPoint>,
    /// Unit of the force that is the level of paths, where a prescribed motion drives them.
    pub force_unit: Option<String>,
    /// What the supports exerted at the last record.
    pub supports: Option<Resultant>,
    /// What was found for load cases and combinations, in a scene that has some.
    pub cases: Option<CasesSummary>,
    /// What answers to response spectra and to noise consist of.
    pub vibration: Option<VibrationSummary>,
    /// What the base moves by, where columns have that in them.
    pub base: Option<BaseMotion>,
    /// Looks at contact where the run records.
    pub contact: ContactWatch,
    /// Where frames of fields go, if anywhere.
    pub frames: Option<Frames<'a>>,
    /// Who receives its progress, if anyone does.
    pub progress: Option<&'a mut dyn Progress>,
    pub checkpoints: Option<&'a mut Checkpoints>,
    /// Those who run it together; none where one process does.
    pub ranks: Option<Ranks>,
}

impl Run<'_> {
    /// Adds a row to the curve: the columns of the analysis, then what the probes read.
    pub fn row(&mut self, mut columns: Vec<f64>, body: &dyn Body) {
        let (time, first) = (columns[0], columns.len());
        self.read_probes(&mut columns, body);
        if let Some(base) = &self.base {
            base.add_to(&mut columns[first..], &self.probes, time);
        }
        self.push(columns);
    }

    /// Appends what the probes read now, and notes what the supports exert.
    pub fn read_probes(&mut self, row: &mut Vec<f64>, body: &dyn Body) {
        self.supports = body.support_resultant();
        let mut forces = 0;
        for probe in &mut self.probes {
            let value = probe.read(body);
            row.push(value);
            if probe.of.has_mean() {
                row.push(self.impulses.mean(forces, value));
                forces += 1;
            }
        }
        self.impulses.recorded();
    }

    /// Whether forces are read in every step.
    pub fn counts_impulses(&self) -> bool {
        self.probes.iter().any(|probe| probe.of.has_mean())
    }

    /// Counts what forces did over the step that ended at a time; between two steps they are those of its kick.
    pub fn count_impulses(&mut self, time: f64, body: &dyn Body) {
        let forces = self.probes.iter_mut().filter(|probe| probe.of.has_mean());
        self.impulses.take(time, forces.map(|probe| probe.read(body)));
    }

    /// Adds a row that is complete.
    pub fn push(&mut self, row: Vec<f64>) {
        self.curve.rows.push(row);
        self.show_curve();
    }

    /// Keeps the present shape, as long as there is room, and offers it as a frame; `Break` if that cannot go on.
    ///
    /// The forces of the body must be those of its state.
    pub fn keep_shape(&mut self, body: &dyn Body, time: f64, level: f64) -> ControlFlow<()> {
        self.contact.note(body, [time, level], &mut self.record);
        self.contact.look(body, [time, level], &mut self.record);
        self.keep_positions(body.configuration().present, time, level);
        self.keep_state(body);
        self.offer(body, time, level)
    }

    /// Keeps the present state of a body that has no history, if states are kept and as long as there is room.
    fn keep_state(&mut self, body: &dyn Body) {
        let Some(states) = &mut self.states else { return };
        if let [motion, _] = &body.state()[..]
            && (states.len() + 1) * motion.numbers.len() <= MOST_POSITIONS
        {
            states.push(motion.numbers.to_vec());
        }
    }

    /// Keeps the present shape in the place of the one before, and offers it as a frame.
    pub fn keep_latest(&mut self, body: &dyn Body, time: f64, level: f64) -> ControlFlow<()> {
        let Configuration { present, .. } = body.configuration();
        self.latest = (present.len() <= MOST_POSITIONS).then_some(Shape { time, level, positions: present });
        self.offer(body, time, level)
    }

    pub fn keep_positions(&mut self, positions: Vec<sph_core::Vec3>, time: f64, level: f64) {
        if (self.shapes.len() + 1) * positions.len() <= MOST_POSITIONS {
            self.shapes.push(Shape { time, level, positions });
        }
    }

    /// Offers the present state as a frame, if frames are wanted. Of several processes only the first has any: it says to the others that it
    /// cannot go on, and all end behind the next step.
    pub fn offer(&mut self, body: &dyn Body, time: f64, level: f64) -> ControlFlow<()> {
        let flow =
            self.frames.as_mut().map_or(ControlFlow::Continue(()), |frames| frames.offer(body, time, level));
        let Some(ranks) = self.ranks.as_ref().filter(|_| flow.is_break()) else { return flow };
        ranks.say(Word::Stop);
        ControlFlow::Continue(())
    }

    /// Whether a checkpoint is due, for all processes alike; `asked` where one is wanted at any rate.
    pub fn checkpoint_due(&self, asked: bool) -> bool {
        let due = self.checkpoints.as_ref().is_some_and(|kept| kept.due(asked));
        let Some(ranks) = &self.ranks else { return due };
        if due {
            ranks.say(Word::Checkpoint);
        }
        ranks.heard(Word::Checkpoint) || asked
    }

    /// Writes a checkpoint, if the run writes any; what prevents it is reported, and the run goes on.
    pub fn keep_checkpoint(&mut self, stage: &Stage, body: &dyn Body) {
        let Some(checkpoints) = self.checkpoints.take() else { return };
        let written = checkpoints.write(self.kept(stage, body), &self.curve.rows, &self.shapes);
        if let (Err(error), Some(progress)) = (written, &mut self.progress) {
            progress.warn(&error.to_string());
        }
        self.checkpoints = Some(checkpoints);
    }

    /// What a checkpoint keeps of it beside its rows and shapes.
    fn kept<'k>(&'k self, stage: &'k Stage, body: &'k dyn Body) -> Contents<'k> {
        let mut record = self.record.clone();
        let offered = self.frames.as_ref().map_or(0, |frames| frames.offered);
        record.frames = self.frames.as_ref().map_or(0, |frames| frames.taken);
        Contents {
            body: 0,
            particles: body.configuration().rest.len(),
            stage: Cow::Borrowed(stage),
            state: body.state(),
            turns: self.probes.iter().map(|probe| Cow::Borrowed(&probe.turns[..])).collect(),
            impulses: Cow::Borrowed(&self.impulses),
            supports: self.supports,
            looked: self.contact.looked,
            record: Cow::Owned(record),
            latest: self.latest.as_ref().map(Cow::Borrowed),
            offered,
            rows: 0,
        }
    }

    /// Puts the run and its body where a checkpoint stood; gives the stage.
    ///
    /// # Errors
    /// [`CheckpointError::Surface`] and [`CheckpointError::Model`] for the checkpoint of another body.
    pub fn go_on_from(
        &mut self,
        checkpoint: Checkpoint,
        body: &mut dyn Body,
        identity: &Identity,
    ) -> Result<Stage, CheckpointError> {
        let Checkpoint { kept, grown, .. } = checkpoint;
        let (width, here) = (self.curve.columns.len(), body.configuration().rest.len());
        if kept.particles == here && kept.body != checksum(body, identity) {
            let file = identity.file.clone();
            return Err(CheckpointError::Surface(file.unwrap_or_else(|| "the mid-surface".into())));
        }
        let fits = kept.turns.len() == self.probes.len()
            && grown.rows.iter().all(|row| row.len() == width)
            && grown.shapes.iter().chain(kept.latest.as_deref()).all(|shape| shape.positions.len() == here)
            && body.set_state(&kept.state).is_ok();
        if !fits {
            return Err(CheckpointError::Model { particles: kept.particles, here });
        }
        for (probe, turns) in self.probes.iter_mut().zip(kept.turns) {
            probe.turns = turns.into_owned();
        }
        if let Some(checkpoints) = &mut self.checkpoints {
            checkpoints.go_on(kept.rows, [grown.rows.len(), grown.shapes.len()]);
        }
        (self.curve.rows, self.shapes) = (grown.rows, grown.shapes);
        self.latest = kept.latest.map(Cow::into_owned);
        self.contact.looked = kept.looked;
        (self.impulses, self.supports) = (kept.impulses.into_owned(), kept.supports);
        self.record = kept.record.into_owned();
        if let Some(frames) = &mut self.frames {
            (frames.offered, frames.taken) = (kept.offered, self.record.frames);
        }
        Ok(kept.stage.into_owned())
    }

    /// Shows the curve as it is now.
    pub fn show_curve(&mut self) {
        if let Some(progress) = &mut self.progress {
            progress.recorded(&self.curve);
        }
    }

    /// Tells how it goes; `Break` if it is to end, for all processes alike.
    pub fn update(&mut self, news: &ProgressReport) -> ControlFlow<()> {
        let flow = self.progress.as_mut().map_or(ControlFlow::Continue(()), |progress| progress.update(news));
        let Some(ranks) = &self.ranks else { return flow };
        if flow.is_break() {
            ranks.say(Word::Stop);
        }
        if ranks.heard(Word::Stop) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    /// Tells how it goes without time; `Break` if it is to end, for all processes alike, which meet here to hear of it.
    pub fn tell(&mut self, done: f64, steps: u64, level: f64, internal: f64) -> ControlFlow<()> {
        if let Some(ranks) = &mut self.ranks {
            ranks.add(&mut [], &mut []);
        }
        self.update(&ProgressReport { done, steps, level, internal, ..ProgressReport::default() })
    }

    /// How a run ends whose balance was not found.
    pub fn unbalanced(&self, points: u64, level: f64, cause: EquilibriumError) -> Ended {
        let unit = if points > 0 { self.force_unit.clone() } else { None };
        Ended::Diverged(Failure::Balance { points, level, cause, unit })
    }

    /// Warns of loads whose stiffness is not symmetric, where stability is judged from the symmetric part; once, whenever it is taken up again.
    pub fn warn_of_skew_loads(&mut self, share: f64) {
        let known = self.record.warnings.iter().any(|warning| warning.kind == WarningKind::NoPotential);
        if share > 0.0 && !known {
            let message = format!(
                "the loads have no potential: entries of up to {share:.2} of the largest in their stiffness are skew \
                 (pressure over free edges, couples about moving edges) and left out of the tangent; equilibria are \
                 exact, but critical levels and negative pivots are those of the symmetric part and may be others, and flutter is not \
                 looked for: check with [analysis.explicit.transient]"
            );
            self.record.warn(WarningKind::NoPotential, message);
        }
    }
}
