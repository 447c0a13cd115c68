//! The analysis in time: marches a body and watches it.

use std::ops::ControlFlow;

use explicit_dynamics::{Event, Instant, LevelReached, March, MarchState, Missing, Plan, Record, Shortened};
use implicit_statics::Inertia;

use super::stability::Stability;
use crate::WarningKind;
use crate::bodies::{Configuration, DynamicBody, TangentCost};
use crate::run::Run;
use crate::run::checkpoint::Stage;
use crate::run::outcome::Ended;
use crate::run::progress::ProgressReport;
use crate::run::record::{Energies, LevelSummary, RunRecord, ShortenedSummary};
use crate::scene::{Explicit, QuasiStatic, Transient};

/// A march under way: from the start, or from where an earlier one stood.
pub(super) struct Marching {
    plan: Option<Plan>,
    safety: f64,
    from: Option<MarchState>,
    /// None before it has begun.
    march: Option<March>,
    watch: Watch,
}

impl Marching {
    /// Of a body whose look at the tangent is known to cost so much, and that has so many particles.
    pub fn new(explicit: &Explicit, (tangent, particles): (TangentCost, usize), from: Option<Stage>) -> Self {
        let path = explicit.quasi_static.clone();
        let stability = Stability::new(path.as_ref().and_then(|path| path.stability), tangent, particles);
        let plan = match (&explicit.quasi_static, &explicit.transient) {
            (Some(path), _) => Some(settle(path, explicit.safety.get()).into()),
            (None, Some(wanted)) => Some(move_on(wanted, explicit.safety.get()).into()),
            (None, None) => None,
        };
        Self {
            plan,
            safety: explicit.safety.get(),
            from: from.and_then(|stage| if let Stage::March(state) = stage { Some(state) } else { None }),
            march: None,
            watch: Watch { path, stability, settled: false },
        }
    }

    /// Makes a step, or takes a record of the state before one; `Break` at the end, or at divergence.
    pub fn advance(&mut self, body: &mut dyn DynamicBody, run: &mut Run<'_>) -> ControlFlow<Ended> {
        if let Some(plan) = self.plan.take() {
            if let Some(from) = self.from.take() {
                self.march = Some(March::resume(plan, from));
                return self.between(body, run);
            }
            run.record.stable_step = reference_step(body);
            run.record.safety = self.safety;
            match March::start(plan, body) {
                Ok(march) => self.march = Some(march),
                Err(error) => return ControlFlow::Break(Ended::Diverged(error.into())),
            }
        }
        let Some(march) = &mut self.march else { return ControlFlow::Break(Ended::Done) };
        loop {
            match march.advance(body) {
                Ok(Event::Step) => return self.between(body, run),
                Ok(Event::Level(reached)) => self.watch.level(&reached, run),
                Ok(Event::Record(record)) => {
                    body.bring();
                    if self.watch.record(&record, body, run).is_continue() {
                        return ControlFlow::Continue(());
                    }
                    // The step that the record was taken in is done to its end; how it ends no longer matters.
                    let _ = march.advance(body);
                    return self.end(Ended::Done, body, run);
                }
                Ok(Event::End) => return self.end(Ended::Done, body, run),
                Err(error) => return self.end(Ended::Diverged(error.into()), body, run),
            }
        }
    }

    /// Ends the march behind the present step, with a checkpoint if the run writes any.
    pub fn interrupt(&mut self, body: &mut dyn DynamicBody, run: &mut Run<'_>) -> Ended {
        if self.march.as_ref().is_some_and(|march| march.state().is_none())
            && let ControlFlow::Break(ended) = self.advance(body, run)
        {
            return ended;
        }
        let Instant { time, level } = self.stands_at();
        if let Some(state) = self.march.as_ref().and_then(March::state)
            && run.checkpoint_due(true)
        {
            body.bring();
            run.keep_checkpoint(&Stage::March(state.clone()), body);
        }
        self.account(body, run);
        Ended::Interrupted { time, level }
    }

    /// Time \[T\] and load level.
    pub fn stands_at(&self) -> Instant {
        self.march.as_ref().map_or(Instant::default(), |march| march.clock().now)
    }

    /// Tells of a step, and keeps a checkpoint where that is due; `Break` if the run is to end there.
    fn between(&mut self, body: &mut dyn DynamicBody, run: &mut Run<'_>) -> ControlFlow<Ended> {
        let Some(march) = &self.march else { return ControlFlow::Continue(()) };
        let clock = march.clock();
        if run.counts_impulses() {
            body.bring();
        }
        run.count_impulses(clock.now.time, &*body);
        let flow = run.update(&ProgressReport {
            done: march.done(),
            time: clock.now.time,
            level: clock.now.level,
            steps: clock.steps,
            kinetic: clock.kinetic,
            internal: clock.internal,
        });
        if flow.is_break() {
            return ControlFlow::Break(self.interrupt(body, run));
        }
        if run.checkpoint_due(self.watch.settled)
            && let Some(state) = march.state()
        {
            self.watch.settled = false;
            body.bring();
            run.keep_checkpoint(&Stage::March(state.clone()), body);
        }
        ControlFlow::Continue(())
    }

    fn end(&self, ended: Ended, body: &mut dyn DynamicBody, run: &mut Run<'_>) -> ControlFlow<Ended> {
        self.account(body, run);
        ControlFlow::Break(ended)
    }

    /// Notes how many steps there were, and whether their energies balance.
    fn account(&self, body: &mut dyn DynamicBody, run: &mut Run<'_>) {
        body.bring();
        warning_balance(body, &mut run.record);
        if let Some(march) = &self.march {
            run.record.steps = march.clock().steps;
            // Structures in a fluid have clocks of their own.
            let of_clock = march.clock().shortened();
            let Shortened { steps, least, time } = if of_clock.steps > 0 { of_clock } else { body.slowed() };
            run.record.shortened = (steps > 0).then_some(ShortenedSummary { steps, least, time });
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

/// Along a load path.
fn settle(path: &QuasiStatic, safety: f64) -> explicit_dynamics::QuasiStatic {
    explicit_dynamics::QuasiStatic {
        levels: path.levels.list(),
        period: path.period.as_deref().copied(),
        ramp: path.ramp.get(),
        hold: path.hold.get(),
        damping: path.damping,
        tolerance: path.tolerance.get(),
        accuracy: path.accuracy.get(),
        safety,
    }
}

/// In real time.
fn move_on(wanted: &Transient, safety: f64) -> explicit_dynamics::Transient {
    let Transient { duration, record_every, damping, .. } = wanted;
    explicit_dynamics::Transient {
        duration: duration.get(),
        record_every: record_every.get(),
        damping: damping.get(),
        safety,
    }
}

/// Fills the curve, keeps shapes, offers frames.
struct Watch {
    /// The path of a quasi-static march.
    path: Option<QuasiStatic>,
    stability: Stability,
    /// Whether a level has settled since the last checkpoint.
    settled: bool,
}

impl Watch {
    fn record(&mut self, record: &Record, body: &mut dyn DynamicBody, run: &mut Run<'_>) -> ControlFlow<()> {
        let (at, energy) = (record.at, record.energy);
        let columns =
            vec![at.time, at.level, energy.kinetic, energy.internal, energy.external, energy.dissipated];
        run.row(columns, body);
        body.look(at.time);
        let found = &mut run.record;
        found.energies = Energies {
            kinetic: energy.kinetic,
            internal: energy.internal,
            external: energy.external,
            dissipated: energy.dissipated,
            balance_error: record.balance_error,
        };
        found.balance.get_or_insert_default().take(at.time, &found.energies);
        self.settled |= record.settled;
        run.contact.look_in_time(body, record, &mut run.record);
        if self.path.is_none() {
            return run.keep_latest(body, at.time, at.level);
        }
        if !record.settled {
            return ControlFlow::Continue(());
        }
        self.look_at_stability(record, body, run);
        run.keep_shape(body, at.time, at.level)
    }

    /// Counts the negative pivots of the level that was last reached, where that is due.
    fn look_at_stability(&mut self, record: &Record, body: &mut dyn DynamicBody, run: &mut Run<'_>) {
        let levels = self.path.as_ref().map_or(0, |path| path.levels.list().len());
        let reached = run.record.levels.len();
        let Some(level) = run.record.levels.last_mut() else { return };
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
                run.record.warn(WarningKind::StabilityUnknown, message);
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
            run.record.warn(WarningKind::Unstable, message);
        }
    }

    fn level(&self, reached: &LevelReached, run: &mut Run<'_>) {
        let LevelReached { level, settled, kinetic_over_internal, missing, steps, evaluations, period } =
            *reached;
        let Missing { out_of_balance, remaining_displacement } = missing;
        if !settled {
            let message = format!(
                "level {level} did not settle (kinetic/internal energy {kinetic_over_internal:.1e}, out of balance \
                 {out_of_balance:.1e}, remaining displacement {remaining_displacement:.1e}); lengthen `hold`, or {}",
                match self.path.as_ref().and_then(|path| path.period) {
                    Some(_) => "see whether `damping` fits, and leave `period` out",
                    None => "see whether `damping` fits",
                }
            );
            run.record.warn(WarningKind::NotSettled, message);
        }
        run.record.levels.push(LevelSummary {
            level,
            settled,
            kinetic_over_internal,
            out_of_balance,
            remaining_displacement,
            negative_pivots: None,
            steps,
            evaluations: Some(evaluations),
            factorisations: None,
            solves: None,
            period: Some(period),
        });
    }
}
