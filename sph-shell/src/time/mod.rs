//! The shell in time: the step of a particle, the whole step in one sweep, the march, the spectrum.

pub(crate) mod fused;
pub(crate) mod march;
pub(crate) mod particle;
pub(crate) mod spectrum;
