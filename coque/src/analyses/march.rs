//! The explicit run: marches a shell in time and watches it.

use std::ops::ControlFlow;

use explicit_dynamics::{
    Clock, LevelReached, MarchError, Dynamics, MarchState, Missing, Observer, Record,
};
use implicit_statics::Inertia;
use sph_shell::Shell;

use crate::analyses::stability::Stability;
use crate::bodies::probe::Gauge;
use crate::results::summary::{Energies, LevelSummary};
use crate::run::checkpoint::Place;
use crate::run::{Ended, Findings, ProgressReport, RunOptions};
use crate::scene::{Damping, Explicit, QuasiStatic};
use crate::{Doubt, Warning};

/// Marches to the end, or to divergence, from the start or from where an earlier march stood.
pub(crate) fn march(
    explicit: &Explicit,
    shell: &mut Shell,
    gauges: Vec<Gauge>,
    found: &mut Findings<'_>,
    options: &mut RunOptions<'_>,
    from: Option<Place>,
) {
    let from = from.and_then(|place| if let Place::March(standing) = place { Some(standing) } else { None });
    if from.is_none() {
        found.stable_step = reference_step(shell);
        found.safety = explicit.safety;
    }
    let path = explicit.quasi_static.as_ref();
    let stability = Stability::new(path.and_then(|path| path.stability));
    let mut watcher = Watcher { found, gauges, path, stability, settled: false, options };
    match clocked(explicit, shell, &mut watcher, from) {
        Ok(clock) => found.steps = clock.steps,
        Err(error) => {
            if let MarchError::Diverged { step, .. } | MarchError::OutOfBounds { step, .. } = error {
                found.steps = step;
            }
            found.ended = Ended::Diverged(error.into());
        }
    }
}

/// Greatest stable step of the present configuration \[T\]; zero if none was found.
pub(crate) fn reference_step(shell: &mut Shell) -> f64 {
    shell.stable_step(1.0).map_or(0.0, |step| step.dt)
}

fn clocked(
    explicit: &Explicit,
    shell: &mut Shell,
    watcher: &mut Watcher<'_, '_, '_, '_>,
    from: Option<MarchState>,
) -> Result<Clock, MarchError> {
    let safety = explicit.safety;
    if let Some(path) = &explicit.quasi_static {
        let run = explicit_dynamics::QuasiStatic {
            levels: path.levels.list(),
            period: path.period,
            ramp: path.ramp,
            dwell: path.hold,
            damping: match path.damping {
                Damping::Ratio(ratio) => explicit_dynamics::Damping::Ratio(ratio),
                Damping::Kinetic => explicit_dynamics::Damping::Kinetic,
            },
            tolerance: path.tolerance,
            accuracy: path.accuracy,
            safety,
        };
        return match from {
            None => run.march(shell, watcher),
            Some(standing) => run.go_on(standing, shell, watcher),
        };
    }
    // Neither table cannot pass the checks; a duration of zero would be refused here too.
    let run = explicit.transient.unwrap_or(crate::scene::Transient {
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
    match from {
        None => run.march(shell, watcher),
        Some(standing) => run.go_on(standing, shell, watcher),
    }
}

impl Watcher<'_, '_, '_, '_> {
    /// Counts the negative pivots of the level that was last reached, where that is due.
    fn look_at_stability(&mut self, shell: &mut Shell, record: &Record) {
        let levels = self.path.map_or(0, |path| path.levels.list().len());
        let reached = self.found.levels.len();
        let Some(level) = self.found.levels.last_mut() else { return };
        let steps = if reached == levels { record.step } else { level.steps };
        if !self.stability.due(shell, steps) {
            return;
        }
        let Some(inertia) = self.stability.look(shell, record.at.level) else { return };
        level.negative_pivots = Some(inertia.negative);
        let Inertia { negative, zero, .. } = inertia;
        if negative + zero > 0 {
            let vanishing = if zero > 0 { format!(", {zero} vanishing") } else { String::new() };
            let message = format!(
                "level {} is at rest but not stable (negative pivots of the tangent: {negative}{vanishing}): the shell would \
                 leave it at the least disturbance; give it a small load or imperfection that shows the way",
                level.level
            );
            self.found.warnings.push(Warning::new(Doubt::Unstable, message));
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

/// Fills the curve, keeps shapes and checkpoints, offers frames.
struct Watcher<'a, 'b, 'c, 'd> {
    found: &'a mut Findings<'c>,
    gauges: Vec<Gauge>,
    /// The path of a quasi-static march.
    path: Option<&'d QuasiStatic>,
    stability: Stability,
    /// Whether a level has settled since the last checkpoint.
    settled: bool,
    options: &'a mut RunOptions<'b>,
}

impl Observer<Shell> for Watcher<'_, '_, '_, '_> {
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
        self.options.progress.recorded(&self.found.curve);
        self.found.energies = energies(record);
        self.settled |= record.settled;
        if self.path.is_none() {
            self.found.shapes.clear();
            return self.found.keep_shape(shell, record.at.time, record.at.level);
        }
        if !record.settled {
            return ControlFlow::Continue(());
        }
        self.look_at_stability(shell, record);
        self.found.keep_shape(shell, record.at.time, record.at.level)
    }

    fn level(&mut self, reached: &LevelReached) {
        let LevelReached { level, settled, kinetic_over_internal, missing, steps } = *reached;
        let Missing { out_of_balance, way_left } = missing;
        if !settled {
            let message = format!(
                "level {level} did not settle (kinetic/internal energy {kinetic_over_internal:.1e}, out of balance \
                 {out_of_balance:.1e}, way left {way_left:.1e}); lengthen `hold`, or see whether `damping` and `period` fit"
            );
            self.found.warnings.push(Warning::new(Doubt::NotSettled, message));
        }
        self.found.levels.push(LevelSummary {
            level,
            settled,
            kinetic_over_internal,
            out_of_balance,
            way_left,
            negative_pivots: None,
            steps,
        });
    }

    fn between(&mut self, shell: &mut Shell, at: &MarchState, done: f64) -> ControlFlow<()> {
        let clock = &at.clock;
        let flow = self.options.progress.update(&ProgressReport {
            done,
            time: clock.now.time,
            level: clock.now.level,
            steps: clock.steps,
            kinetic: clock.kinetic,
            internal: clock.internal,
        });
        let options = &mut *self.options;
        let wanted = options.checkpoints.as_mut().filter(|kept| kept.due(self.settled || flow.is_break()));
        if let Some(checkpoints) = wanted {
            self.settled = false;
            let place = Place::March(at.clone());
            if let Err(error) = checkpoints.write(&place, shell.motion(), &self.gauges, self.found) {
                options.progress.warn(&error.to_string());
            }
        }
        if flow.is_break() {
            self.found.ended = Ended::Interrupted { time: clock.now.time, level: clock.now.level };
        }
        flow
    }
}
