//! What the other commands make: templates, sweeps, meshes; the examples.

#![allow(clippy::unwrap_used)] // a failed test may stop here

#[path = "../common/mod.rs"]
mod common;

mod examples;
mod refine;
mod structures;
mod sweep;
mod templates;
