//! The analysis in time: marches a body and watches it.

use std::ops::ControlFlow;

use explicit_dynamics::{Clock, LevelReached, MarchError, MarchState, Missing, Observer, Record};
use implicit_statics::Inertia;

use super::stability::Stability;
use crate::WarningKind;
use crate::bodies::{Configuration, DynamicBody, TangentCost};
use crate::run::Run;
use crate::run::checkpoint::Stage;
use crate::run::outcome::Ended;
use crate::run::progress::ProgressReport;
use crate::run::record::{Energies, LevelSummary, RunRecord};
use crate::scene::{Damping, Explicit, QuasiStatic, Transient};

/// Marches to the end, or to divergence, from the start or from where an earlier march stood.
pub(crate) fn march(
    explicit: &Explicit,
    body: &mut dyn DynamicBody,
    tangent: TangentCost,
    run: &mut Run<'_>,
    from: Option<Stage>,
) -> Ended {
    let from = from.and_then(|stage| if let Stage::March(state) = stage { Some(state) } else { None });
    if from.is_none() {
        run.record.stable_step = reference_step(body);
        run.record.safety = explicit.safety;
    }
    let path = explicit.quasi_static.as_ref();
    let stability = {
        let particles = body.configuration().rest.len();
        Stability::new(path.and_then(|path| path.stability), tangent, particles)
    };
    let mut watcher = Watcher { run, path, stability, settled: false, ended: Ended::Done };
    let marched = match (path, &explicit.transient) {
        (Some(path), _) => settle(path, explicit.safety, body, &mut watcher, from),
        (None, Some(wanted)) => move_on(wanted, explicit.safety, body, &mut watcher, from),
        (None, None) => return Ended::Done,
    };
    let Watcher { run, ended, .. } = watcher;
    warning_balance(body, &mut run.record);
    match marched {
        Ok(clock) => {
            run.record.steps = clock.steps;
            ended
        }
        Err(error) => {
            if let MarchError::Diverged { step, .. } | MarchError::OutOfBounds { step, .. } = error {
                run.record.steps = step;
            }
            Ended::Diverged(error.into())
        }
    }
}

/// What may be missing from the balance of a march, in parts of the energy turned over.
///
/// Sound runs miss, at most, of this: shells and rigid sets 4e-4 (struck at speed), bonds 4e-3 (that break), fluids and what stands in
/// them 8e-3 (ten particles deep, let go at once).
const OPEN_BALANCE: f64 = 0.02;

/// Displacement of a body at rest by rounding alone, in parts of its size: thousands of steps move places by less.
const ROUND_OFF: f64 = 1e-10;

/// Warns of energy that came or went without a book that says from where or whereto; a body that nothing but rounding moved has none.
fn warning_balance(body: &dyn DynamicBody, record: &mut RunRecord) {
    let Some(balance) = record.balance.filter(|balance| balance.share().abs() > OPEN_BALANCE) else { return };
    let Configuration { rest, present, .. } = body.configuration();
    let size = rest.iter().map(|x| (x - rest[0]).norm()).fold(0.0, f64::max);
    if rest.iter().zip(&present).all(|(rest, present)| (present - rest).norm() <= ROUND_OFF * size) {
        return;
    }
    let way = if balance.worst > 0.0 { "has come from nowhere" } else { "is missing" };
    let message = format!(
        "at time {} energy {way}, {:.2} % of what was turned over ({} % are too much): forces do work that nothing counts, so that \
         motions and forces may be as wrong; see whether shorter steps or a finer lattice change them",
        balance.time,
        100.0 * balance.share().abs(),
        100.0 * OPEN_BALANCE,
    );
    record.warn(WarningKind::OpenBalance, message);
}

/// Greatest stable step of the present configuration \[T\]; zero if none was found.
pub(crate) fn reference_step(body: &mut dyn DynamicBody) -> f64 {
    body.stable_step(1.0).map_or(0.0, |step| step.dt)
}

/// Marches along a load path.
fn settle(
    path: &QuasiStatic,
    safety: f64,
    body: &mut dyn DynamicBody,
    watcher: &mut Watcher<'_, '_, '_>,
    from: Option<MarchState>,
) -> Result<Clock, MarchError> {
    let march = explicit_dynamics::QuasiStatic {
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
    match from {
        None => march.march(body, watcher),
        Some(state) => march.go_on(state, body, watcher),
    }
}

/// Marches in real time.
fn move_on(
    wanted: &Transient,
    safety: f64,
    body: &mut dyn DynamicBody,
    watcher: &mut Watcher<'_, '_, '_>,
    from: Option<MarchState>,
) -> Result<Clock, MarchError> {
    let Transient { duration, record_every, damping } = *wanted;
    let march = explicit_dynamics::Transient { duration, record_every, damping, safety };
    match from {
        None => march.march(body, watcher),
        Some(state) => march.go_on(state, body, watcher),
    }
}

/// Fills the curve, keeps shapes and checkpoints, offers frames.
struct Watcher<'a, 'r, 's> {
    run: &'a mut Run<'r>,
    /// The path of a quasi-static march.
    path: Option<&'s QuasiStatic>,
    stability: Stability,
    /// Whether a level has settled since the last checkpoint.
    settled: bool,
    ended: Ended,
}

impl Watcher<'_, '_, '_> {
    /// Counts the negative pivots of the level that was last reached, where that is due.
    fn look_at_stability(&mut self, body: &mut dyn DynamicBody, record: &Record) {
        let levels = self.path.map_or(0, |path| path.levels.list().len());
        let reached = self.run.record.levels.len();
        let Some(level) = self.run.record.levels.last_mut() else { return };
        let last = reached == levels;
        let steps = if last { record.step } else { level.steps };
        if !self.stability.due(steps) {
            if last && self.stability.is_reported() {
                let message = format!(
                    "level {} is at rest, but whether it is stable was not looked at, which would take more than 1 % of the run: a perfect column \
                     rests straight beyond its critical load; see by analysis.explicit.quasi-static.stability = true, or say that it need \
                     not be seen by false",
                    level.level
                );
                self.run.record.warn(WarningKind::StabilityUnknown, message);
            }
            return;
        }
        let Some(inertia) = self.stability.look(body, record.at.level) else { return };
        level.negative_pivots = Some(inertia.negative);
        let Inertia { negative, zero, .. } = inertia;
        if negative + zero > 0 {
            let vanishing = if zero > 0 { format!(", {zero} vanishing") } else { String::new() };
            let message = format!(
                "level {} is at rest but not stable (negative pivots of the tangent: {negative}{vanishing}): the shell would \
                 leave it at the least disturbance; give it a small load or imperfection that shows the way",
                level.level
            );
            self.run.record.warn(WarningKind::Unstable, message);
        }
    }
}

impl<'b> Observer<dyn DynamicBody + 'b> for Watcher<'_, '_, '_> {
    fn record(&mut self, body: &mut (dyn DynamicBody + 'b), record: &Record) -> ControlFlow<()> {
        let (at, energy) = (record.at, record.energy);
        let columns =
            vec![at.time, at.level, energy.kinetic, energy.internal, energy.external, energy.dissipated];
        self.run.row(columns, body);
        body.look(at.time);
        self.run.record.energies = Energies {
            kinetic: energy.kinetic,
            internal: energy.internal,
            external: energy.external,
            dissipated: energy.dissipated,
            balance_error: record.balance_error,
        };
        let found = &mut self.run.record;
        found.balance.get_or_insert_default().take(at.time, &found.energies);
        self.settled |= record.settled;
        if self.path.is_none() {
            return self.run.keep_latest(body, at.time, at.level);
        }
        if !record.settled {
            return ControlFlow::Continue(());
        }
        self.look_at_stability(body, record);
        self.run.keep_shape(body, at.time, at.level)
    }

    fn level(&mut self, reached: &LevelReached) {
        let LevelReached { level, settled, kinetic_over_internal, missing, steps, evaluations, period } =
            *reached;
        let Missing { out_of_balance, way_left } = missing;
        if !settled {
            let message = format!(
                "level {level} did not settle (kinetic/internal energy {kinetic_over_internal:.1e}, out of balance \
                 {out_of_balance:.1e}, way left {way_left:.1e}); lengthen `hold`, or {}",
                match self.path.and_then(|path| path.period) {
                    Some(_) => "see whether `damping` fits, and leave `period` out",
                    None => "see whether `damping` fits",
                }
            );
            self.run.record.warn(WarningKind::NotSettled, message);
        }
        self.run.record.levels.push(LevelSummary {
            level,
            settled,
            kinetic_over_internal,
            out_of_balance,
            way_left,
            negative_pivots: None,
            steps,
            evaluations: Some(evaluations),
            factorisations: None,
            solves: None,
            period: Some(period),
        });
    }

    fn between(&mut self, body: &mut (dyn DynamicBody + 'b), at: &MarchState, done: f64) -> ControlFlow<()> {
        let clock = &at.clock;
        self.run.count_impulses(clock.now.time, &*body);
        let flow = self.run.progress.update(&ProgressReport {
            done,
            time: clock.now.time,
            level: clock.now.level,
            steps: clock.steps,
            kinetic: clock.kinetic,
            internal: clock.internal,
        });
        if self.run.checkpoint_due(self.settled || flow.is_break()) {
            self.settled = false;
            self.run.keep_checkpoint(&Stage::March(at.clone()), body);
        }
        if flow.is_break() {
            self.ended = Ended::Interrupted { time: clock.now.time, level: clock.now.level };
        }
        flow
    }
}
