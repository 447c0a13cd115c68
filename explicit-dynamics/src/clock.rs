//! The one loop: steps, energy balance, and the watch for divergence.

use serde::{Deserialize, Serialize};

use crate::dynamics::{Bounds, Dynamics};
use crate::error::{MarchError, OutOfBounds};
use crate::record::{Balance, Record};
use crate::stable_step::StableStep;
use crate::step::{Instant, Step, Work};

/// Steps between two checks for runaway particles.
const WATCH_EVERY: u64 = 64;
/// Growth of the kinetic energy since the last check that asks for another at once.
const GROWTH: f64 = 4.0;
/// Part of a step by which steps may be longer than asked for, all of them together, so that none is wasted on rounding.
const SLIVER: f64 = 1e-6;

/// Steps that a system made shorter than its stable one ([`Dynamics::shortened`]).
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Shortened {
    /// How many.
    pub steps: u64,
    /// The least over the stable one \[–\]; zero where there was none.
    pub least: f64,
    /// When that was \[T\].
    pub time: f64,
}

impl Shortened {
    pub(crate) fn take(&mut self, share: f64, time: f64) {
        if self.steps == 0 || share < self.least {
            (self.least, self.time) = (share, time);
        }
        self.steps += 1;
    }
}

/// Time, step size and energy balance of a system under way.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Clock {
    /// Where the run stands.
    pub now: Instant,
    /// Steps done.
    pub steps: u64,
    /// Present step \[T\].
    pub dt: f64,
    /// Steps for which it holds.
    pub holds: u64,
    /// Fraction of the stable step that is used.
    pub safety: f64,
    /// Mass-proportional damping \[1/T\].
    pub damping: f64,
    /// Kinetic energy at the last kick \[F L\].
    pub kinetic: f64,
    /// Internal energy when it was last evaluated \[F L\].
    pub internal: f64,
    external: f64,
    dissipated: f64,
    last_dt: f64,
    initial: Option<f64>,
    last_good: Option<Box<Record>>,
    shortened: Shortened,
    /// Kinetic energy when the particles were last watched \[F L\].
    watched: f64,
}

impl Clock {
    /// Starts at time zero with the stable step of the present configuration.
    ///
    /// # Errors
    /// [`MarchError::Option`] for a safety outside (0, 1.2\] (beyond 1 only to show divergence),
    /// [`MarchError::NoStableStep`].
    pub fn start<S: Dynamics + ?Sized>(
        system: &mut S,
        level: f64,
        safety: f64,
        damping: f64,
    ) -> Result<Self, MarchError> {
        if !(safety > 0.0 && safety <= 1.2) {
            return Err(MarchError::Option { key: "safety", value: safety, bound: "in (0, 1.2]" });
        }
        let mut clock = Self {
            now: Instant { time: 0.0, level },
            steps: 0,
            dt: 0.0,
            holds: 0,
            safety,
            damping,
            kinetic: 0.0,
            internal: 0.0,
            external: 0.0,
            dissipated: 0.0,
            last_dt: 0.0,
            initial: None,
            last_good: None,
            shortened: Shortened::default(),
            watched: 0.0,
        };
        clock.estimate_step(system)?;
        Ok(clock)
    }

    /// Takes the stable step of the present configuration.
    ///
    /// # Errors
    /// [`MarchError::NoStableStep`].
    pub fn estimate_step<S: Dynamics + ?Sized>(&mut self, system: &mut S) -> Result<(), MarchError> {
        let StableStep { dt, holds } = system.stable_step(self.safety)?;
        (self.dt, self.holds) = (dt, holds);
        Ok(())
    }

    /// Renews an estimate that holds for one step only. Longer ones are renewed by the marches at their records, so that
    /// steps between two records are equal.
    pub(crate) fn renew<S: Dynamics + ?Sized>(&mut self, system: &mut S) -> Result<(), MarchError> {
        if self.holds <= 1 { self.estimate_step(system) } else { Ok(()) }
    }

    /// One step of at most `limit` \[T\] towards load level `level(time)`, without a record.
    ///
    /// # Errors
    /// [`MarchError::Diverged`] when a particle outruns its bound, [`MarchError::OutOfBounds`].
    pub fn step<S: Dynamics + ?Sized>(
        &mut self,
        system: &mut S,
        limit: f64,
        level: impl Fn(f64) -> f64,
    ) -> Result<(), MarchError> {
        self.renew(system)?;
        let step = self.next_step(system, limit, level);
        let work = system.advance(&step);
        self.finish(system, &step, work)
    }

    /// Evaluates forces and energy of the present configuration.
    pub(crate) fn evaluate<S: Dynamics + ?Sized>(&mut self, system: &mut S) {
        self.internal = system.evaluate(self.now);
    }

    /// Keeps a record as the last one in good order.
    pub(crate) fn keep(&mut self, record: Record) {
        self.last_good = Some(Box::new(record));
    }

    /// Steps that the system made shorter than its stable one.
    pub fn shortened(&self) -> Shortened {
        self.shortened
    }

    /// The last record of a run that was in good order.
    pub fn last_good(&self) -> Option<&Record> {
        self.last_good.as_deref()
    }

    /// Largest step that still ends at or before `limit` from now, without a sliver left over: all steps up to there are
    /// equal. Where the limit is a whole number of steps away, rounding would make it one more: steps would shrink in front
    /// of every record, and such a rhythm feeds the fast modes (central differences keep energy for equal steps only).
    pub(crate) fn next_step<S: Dynamics + ?Sized>(
        &mut self,
        system: &mut S,
        limit: f64,
        level: impl Fn(f64) -> f64,
    ) -> Step {
        let most = system.shortened(self.dt, self.safety);
        if most < self.dt {
            self.shortened.take(most / self.dt, self.now.time);
        }
        let dt = if limit.is_finite() { limit / (limit / most - SLIVER).ceil().max(1.0) } else { most };
        let time = self.now.time + dt;
        Step {
            from: self.now,
            to: Instant { time, level: level(time) },
            kick: 0.5 * (self.last_dt + dt),
            damping: self.damping,
        }
    }

    /// The record of an instant: with what its kick did, and by how much the energies then exceed the one that is kept.
    pub(crate) fn make_record(&mut self, work: Work, ripple: f64, settled: bool) -> Record {
        let energy = Balance {
            kinetic: work.kinetic,
            internal: self.internal,
            // The instant lies in the middle of the kick.
            external: self.external + 0.5 * work.external,
            dissipated: self.dissipated + 0.5 * work.dissipated,
        };
        let initial =
            *self.initial.get_or_insert(energy.kinetic + energy.internal - energy.external - ripple);
        let balance_error = energy.error(initial) - ripple;
        Record { step: self.steps, at: self.now, energy, balance_error, settled }
    }

    /// Counts a step, and checks the bounds where that is due.
    pub(crate) fn finish<S: Dynamics + ?Sized>(
        &mut self,
        system: &S,
        step: &Step,
        work: Work,
    ) -> Result<(), MarchError> {
        self.kinetic = work.kinetic;
        self.external += work.external;
        self.dissipated += work.dissipated;
        self.last_dt = step.drift();
        self.now = step.to;
        self.steps += 1;
        // A runaway particle multiplies the kinetic energy within steps: check before it spreads.
        let growing = !work.kinetic.is_finite() || work.kinetic > GROWTH * self.watched;
        let due = self.steps.is_multiple_of(WATCH_EVERY);
        if growing || due {
            self.watched = work.kinetic;
            self.watch(system)?;
        }
        if due { self.check(system, Bounds::Configuration) } else { Ok(()) }
    }

    /// Counts the work of supports that give and take velocities at once, at the start.
    pub(crate) fn book_start(&mut self, work: Work) {
        self.external += work.external;
    }

    /// Counts the kinetic energy that a stop of all particles takes away.
    pub fn book_stop(&mut self) {
        self.dissipated += self.kinetic;
        self.kinetic = 0.0;
    }

    /// Checks for a runaway particle.
    ///
    /// # Errors
    /// [`MarchError::Diverged`].
    pub fn watch<S: Dynamics + ?Sized>(&self, system: &S) -> Result<(), MarchError> {
        self.check(system, Bounds::Motion)
    }

    /// Asks the system whether it is within bounds, and says when it was not.
    pub(crate) fn check<S: Dynamics + ?Sized>(&self, system: &S, bounds: Bounds) -> Result<(), MarchError> {
        let (Instant { time, level }, step) = (self.now, self.steps);
        system.within_bounds(bounds).map_err(|found| {
            let last_good = self.last_good.clone();
            match found {
                OutOfBounds::Speed { particle, speed, bound } => {
                    let safety = self.safety;
                    MarchError::Diverged { time, step, level, particle, speed, bound, safety, last_good }
                }
                OutOfBounds::Range(found) => MarchError::OutOfBounds { time, step, level, found, last_good },
            }
        })
    }
}
