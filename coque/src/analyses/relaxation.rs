//! Equilibria at load levels by adaptive dynamic relaxation: no factor of the tangent, and snaps are gone along with.

use std::ops::ControlFlow;

use implicit_statics::{Damping, EquilibriumError, RelaxationOptions};

use crate::bodies::Balanced;
use crate::run::Run;
use crate::run::outcome::Ended;
use crate::run::record::{Energies, LevelSummary};
use crate::scene::{Relaxation, RelaxationDamping};

/// Relaxes from level to level.
pub(crate) fn relaxation(wanted: &Relaxation, system: &mut dyn Balanced, run: &mut Run<'_>) -> Ended {
    let options = RelaxationOptions {
        tolerance: wanted.tolerance,
        iterations: wanted.iterations,
        damping: match wanted.damping {
            RelaxationDamping::Kinetic => Damping::Kinetic,
            RelaxationDamping::Rayleigh => Damping::Rayleigh,
        },
        ..RelaxationOptions::default()
    };
    let list = wanted.levels.list();
    let last = list.last().copied().unwrap_or(1.0);
    if record(run, system, 0.0, 0).is_break() {
        return Ended::Done;
    }
    let mut relaxation = match implicit_statics::Relaxation::new(&options) {
        Ok(relaxation) => relaxation,
        Err(cause) => return run.unbalanced(0, 0.0, cause),
    };
    let mut before = 0.0;
    for level in list {
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
            out_of_balance: wanted.tolerance * relaxed.residuals.last().copied().unwrap_or(0.0)
                / relaxed.bound,
            evaluations: Some(relaxed.evaluations as u64),
            ..LevelSummary::balanced(level, None, relaxed.iterations as u64)
        };
        run.record.levels.push(reached);
        if record(run, system, level, relaxed.iterations).is_break() {
            return Ended::Done;
        }
        before = level;
    }
    Ended::Done
}

/// Reads a row at an equilibrium and keeps its shape.
fn record(run: &mut Run<'_>, system: &mut dyn Balanced, level: f64, iterations: usize) -> ControlFlow<()> {
    let internal = system.refresh(level);
    run.row(vec![level, internal, iterations as f64], system);
    run.record.energies = Energies::at_rest(internal);
    run.keep_shape(system, 0.0, level)
}
