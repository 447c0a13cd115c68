//! A run in real time, recorded at equal intervals.

use crate::clock::Clock;
use crate::dynamics::Dynamics;
use crate::error::{MarchError, positive};
use crate::march_state::{MarchState, Stage};

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

    /// Where it starts, its first record due.
    ///
    /// # Errors
    /// [`MarchError`] for options out of bounds, [`MarchError::NoStableStep`].
    pub(crate) fn start<S: Dynamics + ?Sized>(&self, system: &mut S) -> Result<MarchState, MarchError> {
        positive("duration", self.duration)?;
        positive("record_every", self.record_every)?;
        let clock = Clock::start(system, 1.0, self.safety, self.damping)?;
        let steps = self.duration.max(self.record_every) / clock.dt;
        if steps > MOST_STEPS || self.duration / self.record_every > MOST_RECORDS {
            let bound = "at most 1e10 stable steps and 1e7 records; check units, duration and record_every";
            return Err(MarchError::Option { key: "duration", value: self.duration, bound });
        }
        Ok(MarchState { clock, stage: Stage::Transient { record: 0, next_estimate: 0 } })
    }

    /// One step, unless a record is due: then nothing but how far the record's own step may go \[T\].
    ///
    /// # Errors
    /// [`MarchError`] for divergence and for the place of another march.
    pub(crate) fn step<S: Dynamics + ?Sized>(
        &self,
        at: &mut MarchState,
        system: &mut S,
    ) -> Result<Option<f64>, MarchError> {
        let Stage::Transient { record, next_estimate } = at.stage else { return Err(at.other()) };
        let clock = &mut at.clock;
        let left = self.due(record + 1) - clock.now.time;
        // Half a step of slack: the last step of an interval ends on the record up to round-off.
        if left > 0.5 * clock.dt.min(self.record_every) {
            clock.step(system, left, |_| 1.0)?;
            return Ok(None);
        }
        let mut next = next_estimate;
        if clock.holds > 1 && clock.steps >= next {
            clock.estimate_step(system)?;
            next = clock.steps + clock.holds;
        }
        at.stage = Stage::Transient { record: record + 1, next_estimate: next };
        Ok(Some(self.limit(at)))
    }

    /// How far the step may go that starts at the present record \[T\].
    pub(crate) fn limit(&self, at: &MarchState) -> f64 {
        let Stage::Transient { record, .. } = at.stage else { return f64::INFINITY };
        self.due(record + 1) - at.clock.now.time
    }

    /// Goes on behind a recorded step; true where it was the last one.
    ///
    /// # Errors
    /// [`MarchError`] for divergence and for the place of another march.
    pub(crate) fn recorded<S: Dynamics + ?Sized>(
        &self,
        at: &mut MarchState,
        system: &S,
    ) -> Result<bool, MarchError> {
        let Stage::Transient { record, next_estimate } = &mut at.stage else { return Err(at.other()) };
        if *record == 0 {
            *next_estimate = at.clock.holds;
        }
        let over = *record >= self.records();
        if over {
            at.clock.watch(system)?;
        }
        Ok(over)
    }

    /// Part of the duration that is over, from 0 to 1.
    pub(crate) fn done(&self, at: &MarchState) -> f64 {
        (at.clock.now.time / self.duration).clamp(0.0, 1.0)
    }
}
