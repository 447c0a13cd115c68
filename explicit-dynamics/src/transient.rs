//! A run in real time, recorded at equal intervals.

use crate::clock::Clock;
use crate::dynamics::Dynamics;
use crate::error::{MarchError, positive};
use crate::march_state::{MarchState, Stage};
use crate::observer::Observer;

/// Length of a run, in steps and in records, beyond which it is taken for a mistake.
const MOST_STEPS: f64 = 1e10;
const MOST_RECORDS: f64 = 1e7;

/// Marches for a duration with load level one.
#[derive(Clone, Copy, Debug)]
pub struct Transient {
    /// Length of the run \[T\].
    pub duration: f64,
    /// Time between records \[T\]; the step is shortened a little so that records fall on it.
    pub record_every: f64,
    /// Mass-proportional damping c \[1/T\].
    pub damping: f64,
    /// Fraction of the stable step to use.
    pub safety: f64,
}

/// Part of an interval between records below which the last one is rounding, not an interval.
const ROUND_OFF: f64 = 1e-6;

impl Transient {
    /// Number of records after the first.
    fn records(&self) -> u64 {
        (self.duration / self.record_every - ROUND_OFF).ceil().max(1.0) as u64
    }

    /// When a record is due \[T\]: the last one at the end, however short its interval.
    fn due(&self, record: u64) -> f64 {
        let regular = record as f64 * self.record_every;
        let over = regular > self.duration + ROUND_OFF * self.record_every;
        if over && record == self.records() { self.duration } else { regular }
    }

    /// Marches to the end; the first record is the initial state, the last one the final state.
    ///
    /// # Errors
    /// [`MarchError`] for options out of bounds and for divergence.
    pub fn march<S, O>(&self, system: &mut S, observer: &mut O) -> Result<Clock, MarchError>
    where
        S: Dynamics + ?Sized,
        O: Observer<S>,
    {
        positive("duration", self.duration)?;
        positive("record_every", self.record_every)?;
        let mut clock = Clock::start(system, 1.0, self.safety, self.damping)?;
        let steps = self.duration.max(self.record_every) / clock.dt;
        if steps > MOST_STEPS || self.duration / self.record_every > MOST_RECORDS {
            let bound = "at most 1e10 stable steps and 1e7 records; check units, duration and record_every";
            return Err(MarchError::Option { key: "duration", value: self.duration, bound });
        }
        let flow = clock.recorded_step(system, observer, false, self.due(1), |_| 1.0)?;
        let stage = Stage::Transient { record: 0, next_estimate: clock.holds };
        if flow.is_break() {
            return Ok(clock);
        }
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
        let records = self.records();
        loop {
            let Stage::Transient { record, next_estimate } = at.stage else { return Err(at.other()) };
            let done = at.clock.now.time / self.duration;
            if observer.between(system, &at, done.clamp(0.0, 1.0)).is_break() {
                break;
            }
            let clock = &mut at.clock;
            let left = self.due(record + 1) - clock.now.time;
            // Half a step of slack: the last step of an interval ends on the record up to round-off.
            if left > 0.5 * clock.dt.min(self.record_every) {
                clock.step(system, left, |_| 1.0)?;
                continue;
            }
            let mut next = next_estimate;
            if clock.holds > 1 && clock.steps >= next {
                clock.estimate_step(system)?;
                next = clock.steps + clock.holds;
            }
            let left = self.due(record + 2) - clock.now.time;
            let flow = clock.recorded_step(system, observer, false, left, |_| 1.0)?;
            at.stage = Stage::Transient { record: record + 1, next_estimate: next };
            if flow.is_break() || record + 1 >= records {
                break;
            }
        }
        at.clock.watch(system)?;
        Ok(at.clock)
    }
}
