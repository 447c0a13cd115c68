//! Who receives the progress of a run.

use std::ops::ControlFlow;

use crate::results::curve::Curve;

/// How a run is going.
#[derive(Clone, Copy, Debug, Default)]
pub struct ProgressReport {
    /// Part that is done, from 0 to 1; a guess where levels may settle early.
    pub done: f64,
    /// Time \[T\]; zero without time.
    pub time: f64,
    /// Load level.
    pub level: f64,
    /// Steps done; without time the points found.
    pub steps: u64,
    /// Kinetic energy \[F L\].
    pub kinetic: f64,
    /// Internal energy when it was last evaluated \[F L\].
    pub internal: f64,
}

/// Receives the progress, between any two steps in time, at every point of a path without time.
pub trait Progress: Send {
    /// `Break` ends the run in good order.
    fn update(&mut self, news: &ProgressReport) -> ControlFlow<()>;

    /// Receives the curve as a run begins, and again whenever it has grown.
    fn recorded(&mut self, _curve: &Curve) {}

    /// Receives that a run on another lattice begins, for the errors of the run that is over: its number, how many there are, the lattice in words.
    fn companion(&mut self, _number: usize, _of: usize, _lattice: &str) {}

    /// Receives what the run cannot do but goes on without.
    fn warn(&mut self, _message: &str) {}
}

/// Tells nobody.
#[derive(Clone, Copy, Debug, Default)]
pub struct Silent;

impl Progress for Silent {
    fn update(&mut self, _: &ProgressReport) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }
}
