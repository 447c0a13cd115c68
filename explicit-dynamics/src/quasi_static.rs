//! Equilibria along a load path: a smooth ramp to each level, then a dwell until the motion has died.

use std::ops::ControlFlow;

use crate::amplitude::smooth;
use crate::clock::Clock;
use crate::damping::{Damping, KineticDamping};
use crate::dynamics::Dynamics;
use crate::error::{MarchError, positive};
use crate::march_state::{Dwell, MarchState, Stage};
use crate::observer::Observer;
use crate::rest::{LevelReached, Missing, Sizes};

/// Ramp and dwell. Loads are read after a dwell: damping drags the reaction while a ramp runs.
#[derive(Clone, Debug)]
pub struct QuasiStatic {
    /// Load levels λ to stop at, in order; the path starts at zero.
    pub levels: Vec<f64>,
    /// Period T₁ of the lowest mode \[T\]: the unit of `ramp` and `dwell`, and the base of the damping.
    pub period: f64,
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
        positive("period", self.period)?;
        positive("ramp", self.ramp)?;
        positive("hold", self.dwell)?;
        positive("tolerance", self.tolerance)?;
        positive("accuracy", self.accuracy)?;
        if system.linearised().is_none() {
            return Err(MarchError::NotLinearised);
        }
        let damping = self.damping.coefficient(self.period);
        let mut clock = Clock::start(system, 0.0, self.safety, damping)?;
        if self.period > MOST_STEPS_A_PERIOD * clock.dt {
            let bound = "at most 1e8 stable steps; check the units of period, density and stiffness";
            return Err(MarchError::Option { key: "period", value: self.period, bound });
        }
        let flow = clock.recorded_step(system, observer, true, f64::INFINITY, |_| 0.0)?;
        if flow.is_break() || self.levels.is_empty() {
            return Ok(clock);
        }
        let stage = self.begin(0, &clock, Sizes::default());
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
            let Stage::QuasiStatic { level, start, .. } = at.stage else { return Err(at.other()) };
            let Some(&to) = self.levels.get(level) else { return Err(at.other()) };
            if self.ramp_up(&mut at, system, observer)?.is_break() {
                break;
            }
            at.clock.now.level = to;
            let Some((settled, sizes)) = self.dwell(&mut at, start, system, observer)? else { break };
            let flow = at.clock.recorded_step(system, observer, settled, f64::INFINITY, |_| to)?;
            at.clock.watch(system)?;
            if flow.is_break() || level + 1 == self.levels.len() {
                break;
            }
            at.clock.estimate_step(system)?;
            at.stage = self.begin(level + 1, &at.clock, sizes);
        }
        Ok(at.clock)
    }

    /// The place at the foot of the ramp to a level.
    fn begin(&self, level: usize, clock: &Clock, sizes: Sizes) -> Stage {
        Stage::QuasiStatic { level, start: clock.now.time, first_step: clock.steps, sizes, dwell: None }
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
        let Stage::QuasiStatic { level: number, start, first_step, sizes, dwell: None } = at.stage else {
            return Ok(ControlFlow::Continue(()));
        };
        let to = self.levels[number];
        let from = if number == 0 { 0.0 } else { self.levels[number - 1] };
        let ramp = self.ramp * self.period;
        let level = |time: f64| from + (to - from) * smooth((time - start) / ramp);
        while start + ramp - at.clock.now.time > 0.5 * at.clock.dt {
            let within = 0.5 * (at.clock.now.time - start) / ramp;
            if observer.between(system, at, self.done(number, within)).is_break() {
                return Ok(ControlFlow::Break(()));
            }
            at.clock.step(system, start + ramp - at.clock.now.time, level)?;
        }
        let now = at.clock.now.time;
        let dwell = Dwell {
            end: now + self.dwell * self.period,
            next_check: now + self.period / CHECKS_PER_PERIOD,
            settled_checks: 0,
            peaks: KineticDamping::default(),
        };
        at.stage = Stage::QuasiStatic { level: number, start, first_step, sizes, dwell: Some(dwell) };
        Ok(ControlFlow::Continue(()))
    }

    /// Marches until the motion has died (true) or the dwell is over (false), with the sizes of the answers so far;
    /// nothing if the observer ends the march.
    fn dwell<S, O>(
        &self,
        at: &mut MarchState,
        start: f64,
        system: &mut S,
        observer: &mut O,
    ) -> Result<Option<(bool, Sizes)>, MarchError>
    where
        S: Dynamics + ?Sized,
        O: Observer<S>,
    {
        loop {
            let Stage::QuasiStatic { level: number, first_step, sizes, dwell: Some(mut dwell), .. } =
                at.stage
            else {
                return Err(at.other());
            };
            // Most dwells end early: half a level for the ramp, the rest approached.
            let dwelt = at.clock.now.time - start - self.ramp * self.period;
            let within = 1.0 - 0.5 / (1.0 + dwelt / self.period);
            if observer.between(system, at, self.done(number, within)).is_break() {
                return Ok(None);
            }
            let (clock, to) = (&mut at.clock, self.levels[number]);
            if clock.now.time < dwell.next_check {
                clock.step(system, f64::INFINITY, |_| to)?;
                if self.damping == Damping::Kinetic && dwell.peaks.peaked(clock.kinetic) {
                    system.stop();
                    clock.book_stop();
                }
            }
            if clock.now.time >= dwell.next_check {
                clock.evaluate(system);
                // Kinetic damping has just stopped the motion: its last peak is the measure of rest.
                let kinetic = if self.damping == Damping::Kinetic { dwell.peaks.peak } else { clock.kinetic };
                let ratio = kinetic / clock.internal.max(f64::MIN_POSITIVE);
                let slow =
                    ratio < self.tolerance && (self.damping != Damping::Kinetic || dwell.peaks.peak > 0.0);
                let over = clock.now.time >= dwell.end;
                // An overshoot on the way is no answer to measure by: only what a level ends with is kept.
                let (mut missing, mut reached) = (Missing::default(), sizes);
                if slow || over {
                    let system = system.linearised().ok_or(MarchError::NotLinearised)?;
                    missing = Missing::find(system, clock.internal, self.period, &mut reached);
                }
                let at_rest = slow && missing.within(self.accuracy);
                dwell.settled_checks = if at_rest { dwell.settled_checks + 1 } else { 0 };
                let settled = dwell.settled_checks >= SETTLED_CHECKS;
                if settled || over {
                    let steps = clock.steps - first_step;
                    let kinetic_over_internal = ratio;
                    observer.level(&LevelReached {
                        level: to,
                        settled,
                        kinetic_over_internal,
                        missing,
                        steps,
                    });
                    return Ok(Some((settled, reached)));
                }
                dwell.next_check = clock.now.time + self.period / CHECKS_PER_PERIOD;
            }
            at.stage = Stage::QuasiStatic { level: number, start, first_step, sizes, dwell: Some(dwell) };
        }
    }

    /// Part of the way that is done, from the part of a level.
    fn done(&self, level: usize, within: f64) -> f64 {
        ((level as f64 + within) / self.levels.len() as f64).clamp(0.0, 1.0)
    }
}
