//! A march: a plan under way, a value that is advanced from event to event.

use crate::clock::Clock;
use crate::dynamics::Dynamics;
use crate::error::MarchError;
use crate::march_state::MarchState;
use crate::quasi_static::QuasiStatic;
use crate::record::Record;
use crate::recorded::HalfStep;
use crate::rest::LevelReached;
use crate::transient::Transient;

/// Where a march goes.
#[derive(Clone, Debug)]
pub enum Plan {
    /// Along load levels, to rest at each.
    QuasiStatic(QuasiStatic),
    /// Through real time.
    Transient(Transient),
}

/// A march under way: its plan, and where it stands. The system is handed to every call, and has to be the same one each time.
///
/// A march that is no longer advanced ends there. What is called is generic in the system, and an event is a few words: two hundred
/// instructions a step.
#[derive(Clone, Debug)]
pub struct March {
    plan: Plan,
    at: MarchState,
    next: Next,
}

/// What has happened to a march since it was last advanced.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    /// A step is done, or two where one of them shows the period. The march stands between two steps, where [`March::state`] says.
    Step,
    /// A load level has ended; its record comes next.
    Level(LevelReached),
    /// A record is taken: the system is in the state that it speaks of, its forces evaluated, and the kick of the next step is done.
    Record(Record),
    /// The last record lies behind; nothing is left to do.
    End,
}

/// What the next advance has to do.
#[derive(Clone, Copy, Debug)]
enum Next {
    /// A step of the plan.
    Step,
    /// The first half of a recorded step of at most `limit` \[T\].
    Record {
        settled: bool,
        limit: f64,
    },
    /// The other half.
    Rest(HalfStep),
    Nothing,
}

impl March {
    /// Starts a march: finds the stable step; the first event is the record of the initial state.
    ///
    /// # Errors
    /// [`MarchError`] for options out of bounds; of a quasi-static plan for systems without [`Dynamics::linearised`].
    pub fn start<S: Dynamics + ?Sized>(plan: impl Into<Plan>, system: &mut S) -> Result<Self, MarchError> {
        let plan = plan.into();
        let (at, next) = match &plan {
            Plan::QuasiStatic(path) => {
                (path.start(system)?, Next::Record { settled: true, limit: f64::INFINITY })
            }
            Plan::Transient(run) => {
                let at = run.start(system)?;
                let limit = run.limit(&at);
                (at, Next::Record { settled: false, limit })
            }
        };
        Ok(Self { plan, at, next })
    }

    /// A march of the same plan where one stood; it goes on to the same bits with its system in the state it had there.
    ///
    /// The first advance refuses the place of another march ([`MarchError::OtherMarch`]).
    pub fn resume(plan: impl Into<Plan>, at: MarchState) -> Self {
        Self { plan: plan.into(), at, next: Next::Step }
    }

    /// Goes on to the next event. Behind an error, as behind the end, there is nothing but [`Event::End`].
    ///
    /// # Errors
    /// [`MarchError`] for divergence and for the place of another march.
    pub fn advance<S: Dynamics + ?Sized>(&mut self, system: &mut S) -> Result<Event, MarchError> {
        let event = match self.next {
            Next::Step => self.step(system),
            Next::Record { settled, limit } => self.record(system, settled, limit),
            Next::Rest(half) => self.complete(system, &half),
            Next::Nothing => Ok(Event::End),
        };
        if event.is_err() {
            self.next = Next::Nothing;
        }
        event
    }

    /// Goes on to the next record, with the system in the state it speaks of; none at the end.
    ///
    /// # Errors
    /// As [`March::advance`].
    pub fn next_record<S: Dynamics + ?Sized>(
        &mut self,
        system: &mut S,
    ) -> Result<Option<Record>, MarchError> {
        loop {
            match self.advance(system)? {
                Event::Record(record) => return Ok(Some(record)),
                Event::End => return Ok(None),
                Event::Step | Event::Level(_) => {}
            }
        }
    }

    /// Goes on to the end.
    ///
    /// # Errors
    /// As [`March::advance`].
    pub fn finish<S: Dynamics + ?Sized>(mut self, system: &mut S) -> Result<Clock, MarchError> {
        while self.next_record(system)?.is_some() {}
        Ok(self.at.clock)
    }

    /// Time, step and energies so far.
    pub fn clock(&self) -> &Clock {
        &self.at.clock
    }

    /// From where, with its system in its present state, it can be resumed: behind [`Event::Step`] and nowhere else.
    pub fn state(&self) -> Option<&MarchState> {
        matches!(self.next, Next::Step).then_some(&self.at)
    }

    /// Part of the way that is done, from 0 to 1; a guess where holds may end early.
    pub fn done(&self) -> f64 {
        match &self.plan {
            Plan::QuasiStatic(path) => path.done(&self.at),
            Plan::Transient(run) => run.done(&self.at),
        }
    }

    fn step<S: Dynamics + ?Sized>(&mut self, system: &mut S) -> Result<Event, MarchError> {
        match &self.plan {
            Plan::QuasiStatic(path) => {
                let Some(reached) = path.step(&mut self.at, system)? else { return Ok(Event::Step) };
                self.next = Next::Record { settled: reached.settled, limit: f64::INFINITY };
                Ok(Event::Level(reached))
            }
            Plan::Transient(run) => match run.step(&mut self.at, system)? {
                None => Ok(Event::Step),
                Some(limit) => self.record(system, false, limit),
            },
        }
    }

    fn record<S: Dynamics + ?Sized>(
        &mut self,
        system: &mut S,
        settled: bool,
        limit: f64,
    ) -> Result<Event, MarchError> {
        let (record, half) = self.at.clock.record(system, settled, limit)?;
        self.next = Next::Rest(half);
        Ok(Event::Record(record))
    }

    fn complete<S: Dynamics + ?Sized>(
        &mut self,
        system: &mut S,
        half: &HalfStep,
    ) -> Result<Event, MarchError> {
        self.at.clock.complete(system, half)?;
        let over = match &self.plan {
            Plan::QuasiStatic(path) => path.recorded(&mut self.at, system)?,
            Plan::Transient(run) => run.recorded(&mut self.at, system)?,
        };
        self.next = if over { Next::Nothing } else { Next::Step };
        Ok(if over { Event::End } else { Event::Step })
    }
}

impl From<QuasiStatic> for Plan {
    fn from(path: QuasiStatic) -> Self {
        Self::QuasiStatic(path)
    }
}

impl From<Transient> for Plan {
    fn from(run: Transient) -> Self {
        Self::Transient(run)
    }
}
