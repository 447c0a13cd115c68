//! Errors of numbers, and lattices that reach an accuracy.

#![allow(clippy::unwrap_used)] // a failed test may stop here

#[path = "../common/mod.rs"]
mod common;

mod accuracy;
mod errors;
mod sharpened;
