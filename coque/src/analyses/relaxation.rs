//! Equilibria at load levels by adaptive dynamic relaxation: no factor of the tangent, and snaps are gone along with.

use std::ops::ControlFlow;

use implicit_statics::{Damping, EquilibriumError, Relaxation, RelaxationOptions};

use super::breaking::{at_rest, note_breaches};
use super::criticality::note_snap;
use crate::bodies::StaticBody;
use crate::run::Run;
use crate::run::checkpoint::Stage;
use crate::run::outcome::Ended;
use crate::run::record::LevelSummary;
use crate::scene::{self, RelaxationDamping};

/// Relaxes from level to level, from the start or from where an earlier run stood.
pub(crate) fn relaxation(
    wanted: &scene::Relaxation,
    system: &mut dyn StaticBody,
    run: &mut Run<'_>,
    from: Option<Stage>,
) -> Ended {
    let options = RelaxationOptions {
        tolerance: wanted.tolerance,
        force: wanted.force,
        iterations: wanted.iterations,
        damping: match wanted.damping {
            RelaxationDamping::Kinetic => Damping::Kinetic,
            RelaxationDamping::Rayleigh => Damping::Rayleigh,
        },
        ..RelaxationOptions::default()
    };
    let list = wanted.levels.list();
    let last = list.last().copied().unwrap_or(1.0);
    let (goes_on, first, begun) = match from {
        Some(Stage::Relaxation { found, memory }) => {
            (true, found, Relaxation::resume(&options, *memory, &*system))
        }
        _ => (false, 0, Relaxation::new(&options)),
    };
    let mut relaxation = match begun {
        Ok(relaxation) => relaxation,
        Err(cause) => return run.unbalanced(0, 0.0, cause),
    };
    if !goes_on {
        if record(run, system, 0.0, 0, 0.0).is_break() {
            return Ended::Done;
        }
        keep(run, 0, &relaxation, system);
    }
    let broken = run.record.breaking.as_ref().map_or(0.0, |breaking| breaking.energy + breaking.released);
    let mut freed = run.record.energies.dissipated - broken;
    let mut before = first.checked_sub(1).and_then(|last| list.get(last)).copied().unwrap_or(0.0);
    for (number, &level) in list.iter().enumerate().skip(first) {
        let steps = run.record.steps;
        let tell = |done: f64, iterations: usize, run: &mut Run<'_>| {
            run.tell(done / last, steps + iterations as u64, before, run.record.energies.internal)
        };
        let relaxed = relaxation.to_level(system, (before, level), |at| tell(before, at.iterations, run));
        let relaxed = match relaxed {
            Ok(relaxed) => relaxed,
            Err(EquilibriumError::Ended { iterations, .. }) => {
                run.record.steps += iterations as u64;
                return Ended::Interrupted { time: 0.0, level: before };
            }
            Err(cause) => return run.unbalanced(run.record.levels.len() as u64, before, cause),
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
        freed += if release.snapped() { release.energy } else { 0.0 };
        if record(run, system, level, relaxed.iterations, freed).is_break() {
            return Ended::Done;
        }
        before = level;
        keep(run, number + 1, &relaxation, system);
    }
    Ended::Done
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
