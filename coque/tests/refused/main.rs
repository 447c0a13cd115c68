//! What is refused, and how it is said.

#![allow(clippy::unwrap_used)] // a failed test may stop here

#[path = "../common/mod.rs"]
mod common;

mod filled_refusals;
mod fluid_refusals;
mod galerkin_refusals;
mod inputs;
mod no_panic;
mod no_panic_folders;
mod refusals;
mod solid_refusals;
