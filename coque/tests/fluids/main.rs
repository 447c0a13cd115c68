//! Fluids of scenes and the structures in them.

#![allow(clippy::unwrap_used)] // a failed test may stop here

#[path = "../common/mod.rs"]
mod common;

mod basins;
mod contact_in_fluid;
mod floating;
mod floating_shapes;
mod fluid;
mod fluid_scenes;
mod jointed;
mod moored;
mod openings;
mod periodic;
mod still;
mod unseen_contact;
mod waves;
