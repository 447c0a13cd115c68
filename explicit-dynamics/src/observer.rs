//! The observer of a run, and the recorded step.

use std::ops::ControlFlow;

use crate::clock::Clock;
use crate::dynamics::{Bounds, Dynamics};
use crate::error::MarchError;
use crate::march_state::MarchState;
use crate::record::Record;
use crate::rest::LevelReached;
use crate::step::Step;

/// Watches a run; the system is in the state the record speaks of, its forces evaluated.
pub trait Observer<S: ?Sized> {
    /// Takes a record; `Break` ends the run in good order.
    fn record(&mut self, system: &mut S, record: &Record) -> ControlFlow<()>;

    /// Receives how a load level of a quasi-static march ended.
    fn level(&mut self, _reached: &LevelReached) {}

    /// Receives the state of the march between any two steps; `Break` ends the march there in good order.
    ///
    /// `done` goes from 0 to 1; it is a guess where dwells may end early. From `at` and the state of the system a march goes on
    /// to the same bits.
    fn between(&mut self, _system: &mut S, _at: &MarchState, _done: f64) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }
}

impl Clock {
    /// One step like [`Clock::step`], with a record of the state it starts from.
    ///
    /// # Errors
    /// [`MarchError::Diverged`]; [`MarchError::OutOfBounds`] instead of the record of a state out of bounds.
    pub fn recorded_step<S: Dynamics + ?Sized>(
        &mut self,
        system: &mut S,
        observer: &mut impl Observer<S>,
        settled: bool,
        limit: f64,
        level: impl Fn(f64) -> f64,
    ) -> Result<ControlFlow<()>, MarchError> {
        self.renew(system)?;
        self.evaluate(system);
        let step = self.next_step(limit, level);
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
        let flow = observer.record(system, &record);
        self.keep(record);
        system.drift(&step);
        self.finish(system, &step, work)?;
        Ok(flow)
    }
}
