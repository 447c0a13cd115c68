//! Ways to break a fluid with structures in it.

pub mod drop;
pub mod fluid_first;
pub mod jet;
pub mod light;
pub mod thin;
