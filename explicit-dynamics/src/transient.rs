//! A run in real time, recorded at equal intervals.

use std::ops::ControlFlow;

use crate::error::positive;
use crate::{Clock, Dynamics, LinearisedDynamics, MarchError, Observer};

/// Steps between two estimates of the stable step.
const ESTIMATE_EVERY: u64 = 5000;

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

impl Transient {
    /// Marches to the end; the first record is the initial state, the last one the final state.
    ///
    /// # Errors
    /// [`MarchError`] for options out of bounds and for divergence.
    pub fn march<S, O>(&self, system: &mut S, observer: &mut O) -> Result<Clock, MarchError>
    where
        S: Dynamics + LinearisedDynamics,
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
        let records = (self.duration / self.record_every).ceil().max(1.0) as u64;
        let mut next_estimate = ESTIMATE_EVERY;
        for record in 0..=records {
            let end = (record + 1) as f64 * self.record_every;
            let flow = clock.recorded_step(system, observer, false, end - clock.now.time, |_| 1.0)?;
            if let Some(good) = clock.last_good() {
                observer.progress(record as f64 / records as f64, good);
            }
            if flow == ControlFlow::Break(()) || record == records {
                break;
            }
            // Half a step of slack: the last step of an interval ends on the record up to round-off.
            while end - clock.now.time > 0.5 * clock.dt.min(self.record_every) {
                clock.step(system, end - clock.now.time, |_| 1.0)?;
            }
            if clock.steps >= next_estimate {
                clock.estimate_step(system)?;
                next_estimate = clock.steps + ESTIMATE_EVERY;
            }
        }
        clock.watch(system)?;
        Ok(clock)
    }
}
