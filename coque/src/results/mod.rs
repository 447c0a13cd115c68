//! What a run leaves behind, and the files it is written to.

pub(crate) mod chart;
pub(crate) mod curve;
pub(crate) mod error_bars;
pub(crate) mod growing;
pub(crate) mod picture;
pub(crate) mod plot;
