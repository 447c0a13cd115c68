//! One step of central differences: its instants, its spans, and the work done over it.

use serde::{Deserialize, Serialize};

/// A moment of a run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Instant {
    /// Time \[T\].
    pub time: f64,
    /// Load level λ \[–\]: scales driven loads and prescribed motions; one in a transient run.
    pub level: f64,
}

/// One step of central differences, from `from` to `to`.
#[derive(Clone, Copy, Debug)]
pub struct Step {
    /// Where the forces were evaluated.
    pub from: Instant,
    /// Where the configuration arrives.
    pub to: Instant,
    /// Span of the velocity update \[T\]: from the middle of the last step to the middle of this one.
    pub kick: f64,
    /// Mass-proportional damping c \[1/T\].
    pub damping: f64,
}

impl Step {
    /// Span of the configuration update \[T\].
    pub fn drift(&self) -> f64 {
        self.to.time - self.from.time
    }
}

/// What one kick did.
#[derive(Clone, Copy, Debug, Default)]
pub struct Work {
    /// Kinetic energy at `from`, with the mean of the velocities before and after the kick \[F L\].
    pub kinetic: f64,
    /// Work of loads and of prescribed motions over the kick \[F L\].
    pub external: f64,
    /// Energy taken by mass-proportional damping over the kick \[F L\].
    pub dissipated: f64,
}
