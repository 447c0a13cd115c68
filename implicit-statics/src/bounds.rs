//! What a system says of a state that its model does not cover.

/// A state outside the range of its model.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{what} of {place} is {value:.3e}, must be {bound}")]
pub struct OutOfBounds {
    /// Where.
    pub place: String,
    /// The quantity.
    pub what: &'static str,
    /// What it is.
    pub value: f64,
    /// What it must be.
    pub bound: &'static str,
}
