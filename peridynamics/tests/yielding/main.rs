//! Bonds that yield: the law in uniform strains, what it refuses, and bodies in marches.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

mod bar;
mod blocks;
#[path = "../lattices/mod.rs"]
mod lattices;
mod marches;
mod refused;
mod uniform;
