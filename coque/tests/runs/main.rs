//! Runs of scenes: how they begin, go and end.

#![allow(clippy::unwrap_used)] // a failed test may stop here

#[path = "../common/chain.rs"]
mod chain;
#[path = "../common/mod.rs"]
mod common;

mod at_rest;
mod base;
mod history;
mod own_body;
mod prescribed;
mod probes;
mod push;
mod run;
mod scenes;
mod steps;
mod taken;
mod velocities;
