//! Bonds: families of nodes, what corrects their weights, and the forces they carry.

pub(crate) mod correction;
pub(crate) mod couplings;
pub(crate) mod families;
pub(crate) mod forces;
mod linearised;
pub(crate) mod network;
pub(crate) mod solid_bonds;
mod tangent;
