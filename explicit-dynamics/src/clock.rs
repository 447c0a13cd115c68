//! The one loop: steps, energy balance, records, and the watch for divergence.

use std::ops::ControlFlow;

use serde::{Deserialize, Serialize};

use crate::stable_step::{LinearisedDynamics, largest_eigenvalue, stable_step};
use crate::{Dynamics, Instant, LevelReached, MarchError, MarchState, Step, Work};

/// Steps between two looks for runaway particles.
const WATCH_EVERY: u64 = 64;
/// Growth of the kinetic energy since the last look that asks for another at once.
const GROWTH: f64 = 4.0;
/// Part of a step by which steps may be longer than asked for, all of them together, so that none is wasted on rounding.
const SLIVER: f64 = 1e-6;
/// Lanczos steps of an estimate of the stable step.
const LANCZOS_STEPS: usize = 30;

/// Energies of a run up to an instant \[F L\].
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Balance {
    /// Kinetic energy.
    pub kinetic: f64,
    /// Internal energy.
    pub internal: f64,
    /// Work of loads and prescribed motions.
    pub external: f64,
    /// Taken by damping.
    pub dissipated: f64,
}

impl Balance {
    /// What is missing: `kinetic + internal + dissipated − external − (kinetic + internal at the start)`.
    pub fn error(&self, initial: f64) -> f64 {
        self.kinetic + self.internal + self.dissipated - self.external - initial
    }
}

/// What an observer is shown.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// Steps done.
    pub step: u64,
    /// When, and at which load level.
    pub at: Instant,
    /// Energies; `balance_error` is against the first record.
    pub energy: Balance,
    /// [`Balance::error`] against the energy of the start \[F L\].
    pub balance_error: f64,
    /// True at the end of a hold whose stop criterion was met.
    pub settled: bool,
}

/// Watches a run; the system is in the state the record speaks of, its forces evaluated.
pub trait Observer<S> {
    /// Takes a record; `Break` ends the run in good order.
    fn record(&mut self, system: &mut S, record: &Record) -> ControlFlow<()>;

    /// Told at the end of each load level of a quasi-static march.
    fn level(&mut self, _reached: &LevelReached) {}

    /// Told between any two steps where the march stands; `Break` ends it there in good order.
    ///
    /// `done` goes from 0 to 1; it is a guess where holds may end early. A march goes on from the standing and the
    /// state of the system as if it had never stopped.
    fn between(&mut self, _system: &mut S, _at: &MarchState, _done: f64) -> ControlFlow<()> {
        ControlFlow::Continue(())
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
    /// Kinetic energy when the particles were last watched \[F L\].
    watched: f64,
}

impl Clock {
    /// Starts at time zero with the stable step of the present configuration.
    ///
    /// # Errors
    /// [`MarchError::Option`] for a safety outside (0, 1.2\] (beyond 1 only to show divergence),
    /// [`MarchError::NoStableStep`].
    pub fn start<S: Dynamics + LinearisedDynamics>(
        system: &mut S,
        level: f64,
        safety: f64,
        damping: f64,
    ) -> Result<Self, MarchError> {
        if !(safety > 0.0 && safety <= 1.2) {
            return Err(MarchError::Option { key: "safety", value: safety, bound: "in (0, 1]" });
        }
        let mut clock = Self {
            now: Instant { time: 0.0, level },
            steps: 0,
            dt: 0.0,
            safety,
            damping,
            kinetic: 0.0,
            internal: 0.0,
            external: 0.0,
            dissipated: 0.0,
            last_dt: 0.0,
            initial: None,
            last_good: None,
            watched: 0.0,
        };
        clock.estimate_step(system)?;
        Ok(clock)
    }

    /// Takes the step from the spectrum of the present configuration.
    ///
    /// # Errors
    /// [`MarchError::NoStableStep`].
    pub fn estimate_step<S: Dynamics + LinearisedDynamics>(
        &mut self,
        system: &mut S,
    ) -> Result<(), MarchError> {
        self.dt = stable_step(&largest_eigenvalue(system, LANCZOS_STEPS), self.safety)?;
        Ok(())
    }

    /// One step of at most `limit` \[T\] towards load level `level(time)`, without a record.
    ///
    /// # Errors
    /// [`MarchError::Diverged`] when a particle outruns its bound, [`MarchError::OutOfBounds`].
    pub fn step<S: Dynamics>(
        &mut self,
        system: &mut S,
        limit: f64,
        level: impl Fn(f64) -> f64,
    ) -> Result<(), MarchError> {
        let step = self.next_step(limit, level);
        let work = system.advance(&step);
        self.finish(system, &step, work)
    }

    /// One step like [`Clock::step`], with a record of the state it starts from.
    ///
    /// # Errors
    /// [`MarchError::Diverged`]; [`MarchError::OutOfBounds`] instead of the record of a state out of bounds.
    pub fn recorded_step<S: Dynamics>(
        &mut self,
        system: &mut S,
        observer: &mut impl Observer<S>,
        settled: bool,
        limit: f64,
        level: impl Fn(f64) -> f64,
    ) -> Result<ControlFlow<()>, MarchError> {
        self.evaluate(system);
        let step = self.next_step(limit, level);
        // The first kick starts at its instant, the others have it in their middle: a kick of no span shows the
        // velocities as they were given.
        let still = (self.steps == 0).then(|| system.kick(&Step { kick: 0.0, ..step }));
        let work = system.kick(&step);
        self.look(system)?;
        let record = self.make_record(still.unwrap_or(work), settled);
        let flow = observer.record(system, &record);
        self.last_good = Some(Box::new(record));
        system.drift(&step);
        self.finish(system, &step, work)?;
        Ok(flow)
    }

    /// Evaluates forces and energy of the present configuration.
    pub(crate) fn evaluate<S: Dynamics>(&mut self, system: &mut S) {
        system.force(self.now, true);
        self.internal = system.internal_energy();
    }

    /// The last record of a run that was in good order.
    pub fn last_good(&self) -> Option<&Record> {
        self.last_good.as_deref()
    }

    /// Largest step that still ends at or before `limit` from now, without a sliver left over: all steps up to there are
    /// equal. Where the limit is a whole number of steps away, rounding would make it one more: steps would shrink in front
    /// of every record, and such a rhythm feeds the fast modes (central differences keep energy for equal steps only).
    fn next_step(&self, limit: f64, level: impl Fn(f64) -> f64) -> Step {
        let dt = if limit.is_finite() { limit / (limit / self.dt - SLIVER).ceil().max(1.0) } else { self.dt };
        let time = self.now.time + dt;
        Step {
            from: self.now,
            to: Instant { time, level: level(time) },
            kick: 0.5 * (self.last_dt + dt),
            damping: self.damping,
        }
    }

    fn make_record(&mut self, work: Work, settled: bool) -> Record {
        let energy = Balance {
            kinetic: work.kinetic,
            internal: self.internal,
            // The instant lies in the middle of the kick.
            external: self.external + 0.5 * work.external,
            dissipated: self.dissipated + 0.5 * work.dissipated,
        };
        let initial = *self.initial.get_or_insert(energy.kinetic + energy.internal - energy.external);
        Record { step: self.steps, at: self.now, energy, balance_error: energy.error(initial), settled }
    }

    fn finish<S: Dynamics>(&mut self, system: &S, step: &Step, work: Work) -> Result<(), MarchError> {
        self.kinetic = work.kinetic;
        self.external += work.external;
        self.dissipated += work.dissipated;
        self.last_dt = step.drift();
        self.now = step.to;
        self.steps += 1;
        // A runaway particle multiplies the kinetic energy within steps: look before it spreads.
        let growing = !work.kinetic.is_finite() || work.kinetic > GROWTH * self.watched;
        let due = self.steps.is_multiple_of(WATCH_EVERY);
        if growing || due {
            self.watched = work.kinetic;
            self.watch(system)?;
        }
        if due { self.look(system) } else { Ok(()) }
    }

    /// Books the kinetic energy that a stop of all particles takes away.
    pub fn book_stop(&mut self) {
        self.dissipated += self.kinetic;
        self.kinetic = 0.0;
    }

    /// Looks whether the configuration is within the range of the model.
    fn look<S: Dynamics>(&self, system: &S) -> Result<(), MarchError> {
        system.within_bounds().map_err(|found| MarchError::OutOfBounds {
            time: self.now.time,
            step: self.steps,
            level: self.now.level,
            found,
            last_good: self.last_good.clone(),
        })
    }

    /// Looks for a runaway particle.
    ///
    /// # Errors
    /// [`MarchError::Diverged`].
    pub fn watch<S: Dynamics>(&self, system: &S) -> Result<(), MarchError> {
        let (particle, speed) = system.fastest();
        let bound = system.speed_bound();
        if speed <= bound {
            return Ok(());
        }
        Err(MarchError::Diverged {
            time: self.now.time,
            step: self.steps,
            level: self.now.level,
            particle,
            speed,
            bound,
            safety: self.safety,
            last_good: self.last_good.clone(),
        })
    }
}
