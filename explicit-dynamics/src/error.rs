//! How a march can fail.

use crate::record::Record;

/// A system out of bounds.
#[derive(Clone, Debug, thiserror::Error, PartialEq)]
pub enum OutOfBounds {
    /// A particle is faster than any of a sound run.
    #[error("particle {particle} moves at {speed:.3e}, beyond the bound {bound:.3e}")]
    Speed {
        /// The particle.
        particle: usize,
        /// Its speed \[L/T\].
        speed: f64,
        /// The bound \[L/T\].
        bound: f64,
    },
    /// The configuration is outside the range of the model.
    #[error(transparent)]
    Range(#[from] OutOfRange),
}

/// A configuration outside the range of its model.
#[derive(Clone, Debug, thiserror::Error, PartialEq)]
#[error("{what} of {place} is {value:.3e}, must be {bound}")]
pub struct OutOfRange {
    /// Where.
    pub place: String,
    /// The quantity.
    pub what: &'static str,
    /// What it is.
    pub value: f64,
    /// What it must be.
    pub bound: &'static str,
}

/// A march that did not reach its end.
#[derive(Clone, Debug, thiserror::Error, PartialEq)]
pub enum MarchError {
    /// A particle became faster than any sound solution can make it.
    #[error(
        "diverged at time {time:.6e} (step {step}, load level {level:.6}): particle {particle} moves at {speed:.3e}, \
         beyond the bound {bound:.3e}; lower the safety factor of the step (it was {safety}) or load more slowly"
    )]
    Diverged {
        /// Time \[T\].
        time: f64,
        /// Steps done.
        step: u64,
        /// Load level.
        level: f64,
        /// The particle.
        particle: usize,
        /// Its speed \[L/T\].
        speed: f64,
        /// The bound \[L/T\].
        bound: f64,
        /// Fraction of the stable step that was used.
        safety: f64,
        /// The last state that was recorded in good order.
        last_good: Option<Box<Record>>,
    },
    /// The configuration left the range of the model.
    #[error(
        "left the range of the model at time {time:.6e} (step {step}, load level {level:.6}): {found}; load less or more slowly"
    )]
    OutOfBounds {
        /// Time \[T\].
        time: f64,
        /// Steps done.
        step: u64,
        /// Load level.
        level: f64,
        /// What is out of bounds.
        found: OutOfRange,
        /// The last state that was recorded in good order.
        last_good: Option<Box<Record>>,
    },
    /// A quasi-static march of a system that does not tell how far from rest it is.
    #[error("the system has no linearised form to tell when it is at rest; march it in real time")]
    NotLinearised,
    /// The stiffness has no positive, finite largest eigenvalue.
    #[error(
        "no stable step: the largest eigenvalue of the stiffness over the mass was estimated as {0}; check masses and material"
    )]
    NoStableStep(f64),
    /// The place of a march was handed to one of another kind, or with fewer levels.
    #[error("the march stands at {0}, which this one never comes to; go on with the march that stood there")]
    OtherMarch(String),
    /// An option of the march is outside its bounds.
    #[error("{key} is {value}; it must be {bound}")]
    Option {
        /// The option.
        key: &'static str,
        /// What was given.
        value: f64,
        /// What is allowed.
        bound: &'static str,
    },
}

/// Refuses an option unless it is finite and positive.
pub(crate) fn positive(key: &'static str, value: f64) -> Result<(), MarchError> {
    if value > 0.0 && value.is_finite() {
        Ok(())
    } else {
        Err(MarchError::Option { key, value, bound: "positive and finite" })
    }
}
