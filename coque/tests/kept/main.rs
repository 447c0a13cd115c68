//! What is kept of a run, whatever ends it, and runs that go on.

#![allow(clippy::unwrap_used)] // a failed test may stop here

#[path = "../common/mod.rs"]
mod common;

mod interrupted;
mod kept;
mod resume;
mod resume_galerkin;
