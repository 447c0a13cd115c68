//! Walls: the pressure of their particles, and how they move.

pub(crate) mod extrapolated;
pub(crate) mod motion;
