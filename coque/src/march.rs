//! The explicit run: marches a shell in time and watches it.

use std::ops::ControlFlow;

use explicit_dynamics::{Clock, LevelReached, MarchError, Observer, Record, largest_eigenvalue, stable_step};
use sph_shell::Shell;

use crate::probe::Gauge;
use crate::run::{Ended, Findings, Progress};
use crate::scene::{Damping, Explicit};
use crate::summary::{Energies, LevelSummary};

/// Lanczos steps for the stable step that the summary reports.
const LANCZOS_STEPS: usize = 30;

/// Marches to the end, or to divergence.
pub(crate) fn march(
    explicit: &Explicit,
    shell: &mut Shell,
    gauges: Vec<Gauge>,
    found: &mut Findings<'_>,
    progress: &mut dyn Progress,
) {
    found.stable_step = reference_step(shell);
    found.safety = explicit.safety;
    let keep_settled = explicit.quasi_static.is_some();
    let marched = clocked(explicit, shell, &mut Watcher { found, gauges, keep_settled, progress });
    (found.steps, found.ended) = match marched {
        Ok(clock) => (clock.steps, Ended::Done),
        Err(error) => {
            let steps = match error {
                MarchError::Diverged { step, .. } => step,
                _ => 0,
            };
            (steps, Ended::Diverged(error.into()))
        }
    };
}

/// Greatest stable step of the present configuration \[T\]; nought if none was found.
pub(crate) fn reference_step(shell: &mut Shell) -> f64 {
    stable_step(&largest_eigenvalue(shell, LANCZOS_STEPS), 1.0).unwrap_or(0.0)
}

fn clocked(
    explicit: &Explicit,
    shell: &mut Shell,
    watcher: &mut Watcher<'_, '_>,
) -> Result<Clock, MarchError> {
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

fn energies(record: &Record) -> Energies {
    let energy = record.energy;
    Energies {
        kinetic: energy.kinetic,
        internal: energy.internal,
        external: energy.external,
        dissipated: energy.dissipated,
        balance_error: record.balance_error,
    }
}

/// Fills the curve, keeps shapes and offers frames.
struct Watcher<'a, 'b> {
    found: &'a mut Findings<'b>,
    gauges: Vec<Gauge>,
    keep_settled: bool,
    progress: &'a mut dyn Progress,
}

impl Observer<Shell> for Watcher<'_, '_> {
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
        self.found.curve.rows.push(row);
        self.found.energies = energies(record);
        if !self.keep_settled {
            self.found.shapes.clear();
        }
        if record.settled || !self.keep_settled {
            return self.found.keep_shape(shell, record.at.time, record.at.level);
        }
        ControlFlow::Continue(())
    }

    fn level(&mut self, reached: &LevelReached) {
        let LevelReached { level, settled, kinetic_over_internal, steps } = *reached;
        self.found.levels.push(LevelSummary { level, settled, kinetic_over_internal, steps });
    }

    fn progress(&mut self, done: f64, record: &Record) {
        self.progress.update(done, record);
    }
}
