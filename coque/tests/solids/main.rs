//! Solids of scenes.

#![allow(clippy::unwrap_used)] // a failed test may stop here

#[path = "../common/mod.rs"]
mod common;

mod expansion;
mod filled;
mod filled_galerkin;
mod galerkin;
mod galerkin_faces;
mod galerkin_support;
mod heat;
mod solid;
mod solid_warnings;
mod stresses;
