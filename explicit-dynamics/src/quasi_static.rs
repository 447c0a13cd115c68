//! Equilibria along a load path: a smooth ramp to each level, then a hold until the motion has died.

use crate::amplitude::smooth;
use crate::clock::Clock;
use crate::damping::{Damping, KineticDamping};
use crate::dynamics::Dynamics;
use crate::error::{MarchError, positive};
use crate::march_state::{Hold, LevelUnderWay, MarchState, Stage};
use crate::rest::{LevelReached, Missing, Sizes, period_of_motion, period_of_step};

/// Ramp and hold. Loads are read after a hold: damping drags the reaction while a ramp runs.
#[derive(Clone, Debug)]
pub struct QuasiStatic {
    /// Load levels λ to stop at, in order; the path starts at zero.
    pub levels: Vec<f64>,
    /// Period T₁ of the lowest mode \[T\]: the unit of `ramp` and `hold`, and the base of the damping. None has it found on the
    /// way, again and again: it is that of the slowest motion which the loads bring about.
    pub period: Option<f64>,
    /// Ramp to each level, in periods.
    pub ramp: f64,
    /// Longest hold, in periods.
    pub hold: f64,
    /// How the motion dies.
    pub damping: Damping,
    /// Stop criterion: kinetic over internal energy.
    pub tolerance: f64,
    /// Stop criterion beside it: the share of the answer that may be missing, as force and as displacement ([`Missing`]).
    pub accuracy: f64,
    /// Fraction of the stable step to use.
    pub safety: f64,
}

/// Checks a period, while the load holds, whether the motion has died.
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
    /// Where it starts, its first record due.
    ///
    /// # Errors
    /// [`MarchError`] for options out of bounds, and for systems without [`Dynamics::linearised`].
    pub(crate) fn start<S: Dynamics + ?Sized>(&self, system: &mut S) -> Result<MarchState, MarchError> {
        positive("period", self.period.unwrap_or(1.0))?;
        positive("ramp", self.ramp)?;
        positive("hold", self.hold)?;
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
        let stage = Stage::QuasiStatic(foot(0, &clock, Sizes::default(), period));
        Ok(MarchState { clock, stage })
    }

    /// One step on the ramp, or one with its check in the hold; how the level ended, if it did: its record is due then.
    ///
    /// # Errors
    /// [`MarchError`] for divergence and for the place of another march.
    pub(crate) fn step<S: Dynamics + ?Sized>(
        &self,
        at: &mut MarchState,
        system: &mut S,
    ) -> Result<Option<LevelReached>, MarchError> {
        let Stage::QuasiStatic(mut way) = at.stage else { return Err(at.other()) };
        let Some(&to) = self.levels.get(way.level) else { return Err(at.other()) };
        let reached = match way.hold {
            None => self.ramp_up(&mut at.clock, &mut way, system, to).map(|()| None),
            Some(hold) => self.hold(&mut at.clock, (&mut way, hold), system, to),
        };
        at.stage = Stage::QuasiStatic(way);
        reached
    }

    /// Goes on behind a recorded step, to the foot of the next ramp; true where the level was the last one.
    ///
    /// # Errors
    /// [`MarchError`] for divergence and for the place of another march.
    pub(crate) fn recorded<S: Dynamics + ?Sized>(
        &self,
        at: &mut MarchState,
        system: &mut S,
    ) -> Result<bool, MarchError> {
        let Stage::QuasiStatic(way) = at.stage else { return Err(at.other()) };
        // Before the first level there is no hold.
        let begun = way.hold.is_some();
        let next = if begun { way.level + 1 } else { 0 };
        if begun {
            at.clock.watch(system)?;
        }
        let Some(&to) = self.levels.get(next) else { return Ok(true) };
        if begun {
            at.clock.estimate_step(system)?;
        }
        let mut way = foot(next, &at.clock, way.sizes, way.period);
        self.arrive(&mut at.clock, &mut way, to);
        at.stage = Stage::QuasiStatic(way);
        Ok(false)
    }

    /// Part of the way that is done, from 0 to 1: a guess, as holds may end early.
    pub(crate) fn done(&self, at: &MarchState) -> f64 {
        let Stage::QuasiStatic(way) = at.stage else { return 0.0 };
        let now = at.clock.now.time;
        // Most holds end early: half a level for the ramp, the rest approached.
        let within = match way.hold {
            None => 0.5 * (now - way.start) / (self.ramp * way.period),
            Some(hold) => 1.0 - 0.5 / (1.0 + (now - hold.start) / way.period),
        };
        ((way.level as f64 + within) / self.levels.len() as f64).clamp(0.0, 1.0)
    }

    /// One step on the ramp to a level.
    fn ramp_up<S: Dynamics + ?Sized>(
        &self,
        clock: &mut Clock,
        way: &mut LevelUnderWay,
        system: &mut S,
        to: f64,
    ) -> Result<(), MarchError> {
        let (start, ramp) = (way.start, self.ramp * way.period);
        let left = start + ramp - clock.now.time;
        let from = if way.level == 0 { 0.0 } else { self.levels[way.level - 1] };
        let level = |time: f64| from + (to - from) * smooth((time - start) / ramp);
        clock.step(system, left, level)?;
        // Later ramps go by what their predecessors have found: the way along the path tells less than a motion left to itself.
        if self.period.is_none() && way.level == 0 && clock.now.time >= way.next_check {
            let found = period_of_motion(system.linearised().ok_or(MarchError::NotLinearised)?);
            way.checked += QUOTIENT;
            self.take_over(found, way, clock);
            way.next_check = clock.now.time + self.to_next_check(clock, way.period);
        }
        self.arrive(clock, way, to);
        Ok(())
    }

    /// Begins the hold where the ramp is over.
    fn arrive(&self, clock: &mut Clock, way: &mut LevelUnderWay, to: f64) {
        let now = clock.now.time;
        if way.start + self.ramp * way.period - now <= 0.5 * clock.dt {
            way.hold = Some(Hold { start: now, settled_checks: 0, peaks: KineticDamping::default() });
            way.next_check = now + self.to_next_check(clock, way.period);
            clock.now.level = to;
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

    /// One step in the hold, and a look whether the motion has died (settled) or the hold is over, where that is due.
    fn hold<S: Dynamics + ?Sized>(
        &self,
        clock: &mut Clock,
        (way, mut hold): (&mut LevelUnderWay, Hold),
        system: &mut S,
        to: f64,
    ) -> Result<Option<LevelReached>, MarchError> {
        self.dwelling_step(clock, &mut hold, system, to)?;
        let reached = if clock.now.time >= way.next_check {
            self.check_rest(clock, (way, &mut hold), system, to)?
        } else {
            None
        };
        way.hold = Some(hold);
        Ok(reached)
    }

    /// Looks whether the motion has died or the hold is over; takes over the period of the motion otherwise.
    fn check_rest<S: Dynamics + ?Sized>(
        &self,
        clock: &mut Clock,
        (way, hold): (&mut LevelUnderWay, &mut Hold),
        system: &mut S,
        to: f64,
    ) -> Result<Option<LevelReached>, MarchError> {
        clock.evaluate(system);
        way.checked += 1;
        // Kinetic damping has just stopped the motion: its last peak is the measure of rest.
        let kinetic = if self.damping == Damping::Kinetic { hold.peaks.peak } else { clock.kinetic };
        let ratio = kinetic / clock.internal.max(f64::MIN_POSITIVE);
        let slow = ratio < self.tolerance && (self.damping != Damping::Kinetic || hold.peaks.peak > 0.0);
        let over = clock.now.time >= hold.start + self.hold * way.period;
        // An overshoot on the way is no answer to measure by: only what a level ends with is kept.
        let (mut missing, mut sizes) = (Missing::default(), way.sizes);
        if slow || over {
            let system = system.linearised().ok_or(MarchError::NotLinearised)?;
            missing = Missing::find(system, clock.internal, way.period, &mut sizes);
            way.checked += 2 * QUOTIENT;
        } else if self.period.is_none() && ratio > FAINT {
            let mut before = Vec::new();
            if let Some(system) = system.linearised() {
                before.resize(system.unknowns(), 0.0);
                system.out_of_balance(&mut before);
            }
            self.dwelling_step(clock, hold, system, to)?;
            clock.evaluate(system);
            way.checked += 1;
            let system = system.linearised().ok_or(MarchError::NotLinearised)?;
            let found = period_of_step(system, &before, clock.dt);
            self.take_over(found, way, clock);
        }
        let at_rest = slow && missing.within(self.accuracy);
        hold.settled_checks = if at_rest { hold.settled_checks + 1 } else { 0 };
        let settled = hold.settled_checks >= SETTLED_CHECKS;
        if !(settled || over) {
            way.next_check = clock.now.time + self.to_next_check(clock, way.period);
            return Ok(None);
        }
        way.sizes = sizes;
        let steps = clock.steps - way.first_step;
        Ok(Some(LevelReached {
            level: to,
            settled,
            kinetic_over_internal: ratio,
            missing,
            steps,
            evaluations: steps + way.checked,
            period: way.period,
        }))
    }

    /// A step at a level that stays.
    fn dwelling_step<S: Dynamics + ?Sized>(
        &self,
        clock: &mut Clock,
        hold: &mut Hold,
        system: &mut S,
        level: f64,
    ) -> Result<(), MarchError> {
        clock.step(system, f64::INFINITY, |_| level)?;
        if self.damping == Damping::Kinetic && hold.peaks.peaked(clock.kinetic) {
            system.stop();
            clock.book_stop();
        }
        Ok(())
    }
}

/// The place at the foot of the ramp to a level.
fn foot(level: usize, clock: &Clock, sizes: Sizes, period: f64) -> LevelUnderWay {
    let start = clock.now.time;
    LevelUnderWay {
        level,
        start,
        first_step: clock.steps,
        sizes,
        period,
        next_check: start,
        checked: 0,
        hold: None,
    }
}
