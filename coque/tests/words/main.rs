//! What a scene may say: sets made of sets, parameters, amounts, files that it includes, records.

#![allow(clippy::unwrap_used)] // a failed test may stop here

#[path = "../common/mod.rs"]
mod common;
#[path = "../common/strip.rs"]
mod strip;

mod includes;
mod parameters;
mod records;
mod sets_of_sets;
