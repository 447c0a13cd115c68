//! Equilibria along a load path: a smooth ramp to each level, then a dwell until the motion has died.

use std::ops::ControlFlow;

use crate::amplitude::smooth;
use crate::clock::Clock;
use crate::damping::{Damping, KineticDamping};
use crate::dynamics::Dynamics;
use crate::error::{MarchError, positive};
use crate::march_state::{Dwell, LevelUnderWay, MarchState, Stage};
use crate::observer::Observer;
use crate::rest::{LevelReached, Missing, Sizes, period_of_motion, period_of_step};

/// Ramp and dwell. Loads are read after a dwell: damping drags the reaction while a ramp runs.
#[derive(Clone, Debug)]
pub struct QuasiStatic {
    /// Load levels λ to stop at, in order; the path starts at zero.
    pub levels: Vec<f64>,
    /// Period T₁ of the lowest mode \[T\]: the unit of `ramp` and `dwell`, and the base of the damping. None has it found on the
    /// way, again and again: it is that of the slowest motion which the loads bring about.
    pub period: Option<f64>,
    /// Ramp to each level, in periods.
    pub ramp: f64,
    /// Longest dwell, in periods.
    pub dwell: f64,
    /// How the motion dies.
    pub damping: Damping,
    /// Stop criterion: kinetic over internal energy.
    pub tolerance: f64,
    /// Stop criterion beside it: the share of the answer that may be missing, as force and as displacement ([`Missing`]).
    pub accuracy: f64,
    /// Fraction of the stable step to use.
    pub safety: f64,
}

/// Checks a period, while the load dwells, whether the motion has died.
const CHECKS_PER_PERIOD: f64 = 20.0;
/// Checks in a row that must find the motion dead: a swing is at rest for an instant wherever it turns.
const SETTLED_CHECKS: usize = 2;
/// Where the period is found: steps of the first guess, least steps between two checks, greatest change from check to check.
const FIRST_PERIOD: f64 = 100.0;
const CHECKED_STEPS: f64 = 20.0;
const PERIOD_CHANGE: f64 = 2.0;
/// Kinetic over internal energy below which a motion is too faint to tell its period: rounding of the forces outweighs what a
/// step changes of them.
const FAINT: f64 = 1e-9;
/// Evaluations of the forces that Rayleigh's quotient takes.
const QUOTIENT: u64 = 2;
/// Steps a period beyond which the period is taken for a mistake: a run would never end.
const MOST_STEPS_A_PERIOD: f64 = 1e8;

impl QuasiStatic {
    /// Marches through all levels; one record at the start and one at the end of each dwell.
    ///
    /// # Errors
    /// [`MarchError`] for options out of bounds, for divergence, and for systems without [`Dynamics::linearised`].
    pub fn march<S, O>(&self, system: &mut S, observer: &mut O) -> Result<Clock, MarchError>
    where
        S: Dynamics + ?Sized,
        O: Observer<S>,
    {
        positive("period", self.period.unwrap_or(1.0))?;
        positive("ramp", self.ramp)?;
        positive("dwell", self.dwell)?;
        positive("tolerance", self.tolerance)?;
        positive("accuracy", self.accuracy)?;
        if system.linearised().is_none() {
            return Err(MarchError::NotLinearised);
        }
        let mut clock = Clock::start(system, 0.0, self.safety, 0.0)?;
        let period = self.period.unwrap_or(FIRST_PERIOD * clock.dt);
        if period > MOST_STEPS_A_PERIOD * clock.dt {
            let bound = "at most 1e8 stable steps; check the units of period, density and stiffness";
            return Err(MarchError::Option { key: "period", value: period, bound });
        }
        clock.damping = self.damping.coefficient(period);
        let flow = clock.recorded_step(system, observer, true, f64::INFINITY, |_| 0.0)?;
        if flow.is_break() || self.levels.is_empty() {
            return Ok(clock);
        }
        let stage = self.begin(0, &clock, Sizes::default(), period);
        self.go_on(MarchState { clock, stage }, system, observer)
    }

    /// Goes on from where a march of the same data stood, with its system in the state it had there.
    ///
    /// # Errors
    /// [`MarchError`] for divergence and for the place of another march.
    pub fn go_on<S, O>(
        &self,
        mut at: MarchState,
        system: &mut S,
        observer: &mut O,
    ) -> Result<Clock, MarchError>
    where
        S: Dynamics + ?Sized,
        O: Observer<S>,
    {
        loop {
            let Stage::QuasiStatic(LevelUnderWay { level, .. }) = at.stage else { return Err(at.other()) };
            let Some(&to) = self.levels.get(level) else { return Err(at.other()) };
            if self.ramp_up(&mut at, system, observer)?.is_break() {
                break;
            }
            at.clock.now.level = to;
            let Some((settled, way)) = self.dwell(&mut at, system, observer)? else { break };
            let flow = at.clock.recorded_step(system, observer, settled, f64::INFINITY, |_| to)?;
            at.clock.watch(system)?;
            if flow.is_break() || level + 1 == self.levels.len() {
                break;
            }
            at.clock.estimate_step(system)?;
            at.stage = self.begin(level + 1, &at.clock, way.sizes, way.period);
        }
        Ok(at.clock)
    }

    /// The place at the foot of the ramp to a level.
    fn begin(&self, level: usize, clock: &Clock, sizes: Sizes, period: f64) -> Stage {
        let start = clock.now.time;
        Stage::QuasiStatic(LevelUnderWay {
            level,
            start,
            first_step: clock.steps,
            sizes,
            period,
            next_check: start,
            checked: 0,
            dwell: None,
        })
    }

    /// Marches along the ramp, if it is not over; `Break` if the observer ends the march.
    fn ramp_up<S, O>(
        &self,
        at: &mut MarchState,
        system: &mut S,
        observer: &mut O,
    ) -> Result<ControlFlow<()>, MarchError>
    where
        S: Dynamics + ?Sized,
        O: Observer<S>,
    {
        loop {
            let Stage::QuasiStatic(mut way) = at.stage else { return Err(at.other()) };
            if way.dwell.is_some() {
                return Ok(ControlFlow::Continue(()));
            }
            let (ramp, now) = (self.ramp * way.period, at.clock.now.time);
            let left = way.start + ramp - now;
            if left <= 0.5 * at.clock.dt {
                let dwell = Dwell { start: now, settled_checks: 0, peaks: KineticDamping::default() };
                (way.dwell, way.next_check) = (Some(dwell), now + self.to_next_check(&at.clock, way.period));
                at.stage = Stage::QuasiStatic(way);
                return Ok(ControlFlow::Continue(()));
            }
            let done = self.done(way.level, 0.5 * (now - way.start) / ramp);
            if observer.between(system, at, done).is_break() {
                return Ok(ControlFlow::Break(()));
            }
            let from = if way.level == 0 { 0.0 } else { self.levels[way.level - 1] };
            let to = self.levels[way.level];
            let level = |time: f64| from + (to - from) * smooth((time - way.start) / ramp);
            at.clock.step(system, left, level)?;
            // Later ramps go by what their predecessors have found: the way along the path tells less than a motion left to itself.
            if self.period.is_none() && way.level == 0 && at.clock.now.time >= way.next_check {
                let found = period_of_motion(system.linearised().ok_or(MarchError::NotLinearised)?);
                way.checked += QUOTIENT;
                self.take_over(found, &mut way, &mut at.clock);
                way.next_check = at.clock.now.time + self.to_next_check(&at.clock, way.period);
            }
            at.stage = Stage::QuasiStatic(way);
        }
    }

    /// Takes the period of the present motion over, at most so much longer or shorter than the one before. A ramp keeps the part of
    /// it that is done.
    fn take_over(&self, found: Option<f64>, way: &mut LevelUnderWay, clock: &mut Clock) {
        if let Some(found) = found {
            let change = (found / way.period).clamp(1.0 / PERIOD_CHANGE, PERIOD_CHANGE);
            way.period *= change;
            way.start = clock.now.time - change * (clock.now.time - way.start);
            clock.damping = self.damping.coefficient(way.period);
        }
    }

    /// From one check to the next \[T\].
    fn to_next_check(&self, clock: &Clock, period: f64) -> f64 {
        let least = if self.period.is_none() { CHECKED_STEPS * clock.dt } else { 0.0 };
        (period / CHECKS_PER_PERIOD).max(least)
    }

    /// Marches until the motion has died (true) or the dwell is over (false), with where the level ended;
    /// nothing if the observer ends the march.
    fn dwell<S, O>(
        &self,
        at: &mut MarchState,
        system: &mut S,
        observer: &mut O,
    ) -> Result<Option<(bool, LevelUnderWay)>, MarchError>
    where
        S: Dynamics + ?Sized,
        O: Observer<S>,
    {
        loop {
            let Stage::QuasiStatic(mut way) = at.stage else { return Err(at.other()) };
            let Some(mut dwell) = way.dwell else { return Err(at.other()) };
            // Most dwells end early: half a level for the ramp, the rest approached.
            let within = 1.0 - 0.5 / (1.0 + (at.clock.now.time - dwell.start) / way.period);
            if observer.between(system, at, self.done(way.level, within)).is_break() {
                return Ok(None);
            }
            let (clock, to) = (&mut at.clock, self.levels[way.level]);
            if clock.now.time < way.next_check {
                self.dwelling_step(clock, &mut dwell, system, to)?;
            }
            if clock.now.time >= way.next_check {
                clock.evaluate(system);
                way.checked += 1;
                // Kinetic damping has just stopped the motion: its last peak is the measure of rest.
                let kinetic = if self.damping == Damping::Kinetic { dwell.peaks.peak } else { clock.kinetic };
                let ratio = kinetic / clock.internal.max(f64::MIN_POSITIVE);
                let slow =
                    ratio < self.tolerance && (self.damping != Damping::Kinetic || dwell.peaks.peak > 0.0);
                let over = clock.now.time >= dwell.start + self.dwell * way.period;
                // An overshoot on the way is no answer to measure by: only what a level ends with is kept.
                let (mut missing, mut reached) = (Missing::default(), way.sizes);
                if slow || over {
                    let system = system.linearised().ok_or(MarchError::NotLinearised)?;
                    missing = Missing::find(system, clock.internal, way.period, &mut reached);
                    way.checked += 2 * QUOTIENT;
                } else if self.period.is_none() && ratio > FAINT {
                    let mut before = Vec::new();
                    if let Some(system) = system.linearised() {
                        before.resize(system.unknowns(), 0.0);
                        system.out_of_balance(&mut before);
                    }
                    self.dwelling_step(clock, &mut dwell, system, to)?;
                    clock.evaluate(system);
                    way.checked += 1;
                    let system = system.linearised().ok_or(MarchError::NotLinearised)?;
                    let found = period_of_step(system, &before, clock.dt);
                    self.take_over(found, &mut way, clock);
                }
                let at_rest = slow && missing.within(self.accuracy);
                dwell.settled_checks = if at_rest { dwell.settled_checks + 1 } else { 0 };
                let settled = dwell.settled_checks >= SETTLED_CHECKS;
                if settled || over {
                    let steps = clock.steps - way.first_step;
                    observer.level(&LevelReached {
                        level: to,
                        settled,
                        kinetic_over_internal: ratio,
                        missing,
                        steps,
                        evaluations: steps + way.checked,
                        period: way.period,
                    });
                    way.sizes = reached;
                    return Ok(Some((settled, way)));
                }
                way.next_check = clock.now.time + self.to_next_check(clock, way.period);
            }
            way.dwell = Some(dwell);
            at.stage = Stage::QuasiStatic(way);
        }
    }

    /// A step at a level that stays.
    fn dwelling_step<S: Dynamics + ?Sized>(
        &self,
        clock: &mut Clock,
        dwell: &mut Dwell,
        system: &mut S,
        level: f64,
    ) -> Result<(), MarchError> {
        clock.step(system, f64::INFINITY, |_| level)?;
        if self.damping == Damping::Kinetic && dwell.peaks.peaked(clock.kinetic) {
            system.stop();
            clock.book_stop();
        }
        Ok(())
    }

    /// Part of the way that is done, from the part of a level.
    fn done(&self, level: usize, within: f64) -> f64 {
        ((level as f64 + within) / self.levels.len() as f64).clamp(0.0, 1.0)
    }
}
