//! Statics: the unknowns, the tangent of the energy and of the loads, the system that is balanced.

pub(crate) mod blocks;
pub(crate) mod dofs;
mod enclosed;
mod equilibrium;
mod joined;
pub(crate) mod load_stiffness;
pub(crate) mod projection;
pub(crate) mod static_shell;
pub(crate) mod stiffness;
pub(crate) mod touched;
pub(crate) mod turned;
