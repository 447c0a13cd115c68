//! Bonds: families of nodes, what corrects their weights, the forces they carry, and how they break.

mod applied;
pub(crate) mod balance;
pub(crate) mod breaking;
pub(crate) mod correction;
pub(crate) mod couplings;
mod exchange;
pub(crate) mod faces;
pub(crate) mod families;
mod fitted;
pub(crate) mod flatness;
pub(crate) mod flow;
pub(crate) mod forces;
pub(crate) mod fragments;
pub(crate) mod images;
pub(crate) mod intact;
mod least_change;
pub(crate) mod limits;
mod linearised;
pub(crate) mod mechanics;
pub(crate) mod network;
mod patterns;
mod present;
pub(crate) mod repulsion;
pub(crate) mod solid_bonds;
mod tangent;
mod work;
mod yielding;
