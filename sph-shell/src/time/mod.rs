//! Dynamics: the step of a particle, the whole step in one sweep, the march, the mass-scaled tangent.

pub(crate) mod evaluation;
pub(crate) mod fused;
mod joined;
pub(crate) mod march;
pub(crate) mod particle;
pub(crate) mod share;
pub(crate) mod spectrum;
