//! Bonds: families of nodes, what corrects their weights, and the forces they carry.

pub(crate) mod correction;
pub(crate) mod families;
pub(crate) mod forces;
pub(crate) mod network;
mod present;
pub(crate) mod solid_bonds;
mod tangent;
