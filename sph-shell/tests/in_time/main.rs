//! Shells in time: marches and their balances, the strong form, memory.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

#[path = "../common/mod.rs"]
mod common;

mod bounds;
mod enclosed;
mod energy;
mod history;
mod march;
mod shared;
mod shared_bodies;
mod shared_touching;
mod stiffened;
mod strong_form;
mod strong_form_difference;
mod turned;
mod wetted;
