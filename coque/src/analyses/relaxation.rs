//! Equilibria at load levels by adaptive dynamic relaxation: no factor of the tangent, and snaps are gone along with.

use std::ops::ControlFlow;

use implicit_statics::{EquilibriumError, Relaxation, RelaxationMemory, RelaxationOptions};

use super::breaking::{at_rest, note_breaches};
use super::criticality::note_snap;
use crate::bodies::StaticBody;
use crate::run::Run;
use crate::run::checkpoint::Stage;
use crate::run::outcome::Ended;
use crate::run::record::LevelSummary;
use crate::scene;

/// Levels relaxed to, one after the other.
pub(super) struct RelaxedLevels {
    options: RelaxationOptions,
    list: Vec<f64>,
    /// Levels found.
    found: usize,
    /// What an earlier run knew where it stood, before this one has begun.
    memory: Option<Box<RelaxationMemory>>,
    /// None before it has begun.
    relaxation: Option<Relaxation>,
    /// Energy that snaps set free so far \[F L\].
    freed: f64,
}

impl RelaxedLevels {
    /// From the start, or from where an earlier run stood.
    pub fn new(wanted: &scene::Relaxation, from: Option<Stage>) -> Self {
        let options = RelaxationOptions {
            tolerance: wanted.tolerance.get(),
            force: wanted.force.get(),
            iterations: wanted.iterations.get(),
            damping: wanted.damping,
            ..RelaxationOptions::default()
        };
        let (found, memory) = match from {
            Some(Stage::Relaxation { found, memory }) => (found, Some(memory)),
            _ => (0, None),
        };
        Self { options, list: wanted.levels.list(), found, memory, relaxation: None, freed: 0.0 }
    }

    /// The level last found; zero before the first.
    pub fn last(&self) -> f64 {
        self.found.checked_sub(1).and_then(|last| self.list.get(last)).copied().unwrap_or(0.0)
    }

    /// Relaxes to the next level; `Break` with the last one, or where it is not found.
    pub fn advance(&mut self, system: &mut dyn StaticBody, run: &mut Run<'_>) -> ControlFlow<Ended> {
        let mut relaxation = match self.relaxation.take() {
            Some(relaxation) => relaxation,
            None => self.begin(system, run)?,
        };
        let Some(&level) = self.list.get(self.found) else { return ControlFlow::Break(Ended::Done) };
        let flow = self.relax(level, &mut relaxation, system, run);
        self.relaxation = Some(relaxation);
        flow
    }

    fn begin(&mut self, system: &mut dyn StaticBody, run: &mut Run<'_>) -> ControlFlow<Ended, Relaxation> {
        let memory = self.memory.take();
        let goes_on = memory.is_some();
        let begun = match memory {
            Some(memory) => Relaxation::resume(&self.options, *memory, &*system),
            None => Relaxation::new(&self.options),
        };
        let relaxation = match begun {
            Ok(relaxation) => relaxation,
            Err(cause) => return ControlFlow::Break(run.unbalanced(0, 0.0, cause)),
        };
        if !goes_on {
            if record(run, system, 0.0, 0, 0.0).is_break() {
                return ControlFlow::Break(Ended::Done);
            }
            keep(run, 0, &relaxation, system);
        }
        let broken = run.record.breaking.as_ref().map_or(0.0, |breaking| breaking.energy + breaking.released);
        self.freed = run.record.energies.dissipated - broken;
        ControlFlow::Continue(relaxation)
    }

    fn relax(
        &mut self,
        level: f64,
        relaxation: &mut Relaxation,
        system: &mut dyn StaticBody,
        run: &mut Run<'_>,
    ) -> ControlFlow<Ended> {
        let (before, steps) = (self.last(), run.record.steps);
        let last = self.list.last().copied().unwrap_or(1.0);
        let relaxed = relaxation.to_level(system, (before, level), |at| {
            let internal = run.record.energies.internal;
            run.tell(before / last, steps + at.iterations as u64, before, internal)
        });
        let relaxed = match relaxed {
            Ok(relaxed) => relaxed,
            Err(EquilibriumError::Ended { iterations, .. }) => {
                run.record.steps += iterations as u64;
                return ControlFlow::Break(Ended::Interrupted { time: 0.0, level: before });
            }
            Err(cause) => {
                let points = run.record.levels.len() as u64;
                return ControlFlow::Break(run.unbalanced(points, before, cause));
            }
        };
        run.record.steps += relaxed.evaluations as u64;
        let reached = LevelSummary {
            out_of_balance: relaxed.residuals.last().copied().unwrap_or(0.0) / relaxed.load,
            evaluations: Some(relaxed.evaluations as u64),
            ..LevelSummary::balanced(level, None, relaxed.iterations as u64)
        };
        run.record.levels.push(reached);
        note_breaches(&relaxed.breaches, None, &mut run.record);
        let release = &relaxed.release;
        note_snap(release, (before, level), &mut run.record);
        self.freed += if release.snapped() { release.energy } else { 0.0 };
        if record(run, system, level, relaxed.iterations, self.freed).is_break() {
            return ControlFlow::Break(Ended::Done);
        }
        self.found += 1;
        keep(run, self.found, relaxation, system);
        if self.found == self.list.len() {
            return ControlFlow::Break(Ended::Done);
        }
        ControlFlow::Continue(())
    }
}

/// Keeps a checkpoint where so many levels are found, if the run writes any.
fn keep(run: &mut Run<'_>, found: usize, relaxation: &Relaxation, system: &dyn StaticBody) {
    if run.checkpoints.is_some() {
        let memory = Box::new(relaxation.memory().clone());
        run.keep_checkpoint(&Stage::Relaxation { found, memory }, system);
    }
}

/// Reads a row at an equilibrium and keeps its shape. What a snap `freed` \[F L\] the loads did, and damping took.
fn record(
    run: &mut Run<'_>,
    system: &mut dyn StaticBody,
    level: f64,
    iterations: usize,
    freed: f64,
) -> ControlFlow<()> {
    let internal = system.refresh(level);
    run.row(vec![level, internal, iterations as f64], system);
    run.record.energies = at_rest(internal, freed, &run.record);
    run.keep_shape(system, 0.0, level)
}
