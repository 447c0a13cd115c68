//! A step with a record of the state that it starts from, whole or in two halves with the record between.

use crate::clock::Clock;
use crate::dynamics::{Bounds, Dynamics};
use crate::error::MarchError;
use crate::record::Record;
use crate::step::{Step, Work};

/// A step whose kick is done and whose drift is not: its record has been taken.
#[derive(Clone, Copy, Debug)]
pub(crate) struct HalfStep {
    step: Step,
    work: Work,
}

impl Clock {
    /// One step like [`Clock::step`] at the present level, with a record of the state it starts from.
    ///
    /// # Errors
    /// [`MarchError::Diverged`]; [`MarchError::OutOfBounds`] instead of the record of a state out of bounds.
    pub fn recorded_step<S: Dynamics + ?Sized>(&mut self, system: &mut S) -> Result<Record, MarchError> {
        let (record, half) = self.record(system, false, f64::INFINITY)?;
        self.complete(system, &half)?;
        Ok(record)
    }

    /// The first half of a recorded step of at most `limit` \[T\] at the present level: the system is in the state that the record
    /// speaks of, its forces evaluated, its velocities kicked.
    pub(crate) fn record<S: Dynamics + ?Sized>(
        &mut self,
        system: &mut S,
        settled: bool,
        limit: f64,
    ) -> Result<(Record, HalfStep), MarchError> {
        self.renew(system)?;
        self.evaluate(system);
        let level = self.now.level;
        let step = self.next_step(system, limit, |_| level);
        // The first kick starts at its instant, the others have it in their middle: a kick of no span shows the
        // velocities as they were given. Another before it lets supports give theirs, at once, and counts what that takes.
        let still = (self.steps == 0).then(|| {
            let at_once = Step { kick: 0.0, ..step };
            self.book_start(system.kick(&at_once));
            system.kick(&at_once)
        });
        let work = system.kick(&step);
        self.check(system, Bounds::Configuration)?;
        let record = match still {
            Some(still) => self.make_record(still, work.ripple_at_start(), settled),
            None => self.make_record(work, work.ripple(), settled),
        };
        self.keep(record);
        Ok((record, HalfStep { step, work }))
    }

    /// The second half of a recorded step.
    pub(crate) fn complete<S: Dynamics + ?Sized>(
        &mut self,
        system: &mut S,
        half: &HalfStep,
    ) -> Result<(), MarchError> {
        system.drift(&half.step);
        self.finish(system, &half.step, half.work)
    }
}
