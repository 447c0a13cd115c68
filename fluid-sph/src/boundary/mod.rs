//! Particles that are not fluid: those of walls and the points of structures.

pub(crate) mod check;
pub(crate) mod ledger;
pub(crate) mod pending;
pub(crate) mod points;
mod settling;
pub(crate) mod sides;
mod zone;
