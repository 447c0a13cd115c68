//! What yields.

#![allow(clippy::unwrap_used)] // a failed test may stop here

#[path = "../common/mod.rs"]
mod common;

mod yielding;
mod yielding_bonds;
mod yielding_parts;
mod yielding_rates;
mod yielding_recovery;
