//! What touches, tools and several bodies.

#![allow(clippy::unwrap_used)] // a failed test may stop here

#[path = "../common/mod.rs"]
mod common;

mod edges;
mod friction;
mod glue;
mod linked_pair;
mod links;
mod own_contact;
mod rigid_bodies;
mod rigid_joints;
mod rubbing;
mod rubbing_solids;
mod seen_contact;
mod several;
mod solids_on_tools;
mod tools;
mod touched_modes;
mod touched_paths;
mod touching;
mod touching_solids;
