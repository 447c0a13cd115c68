//! Shells that touch tools or themselves.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

#[path = "../common/audit.rs"]
mod audit;
#[path = "../common/mod.rs"]
mod common;

mod crumpling;
mod drops;
mod frozen;
mod own_contact;
mod own_friction;
mod stages;
mod tools;
