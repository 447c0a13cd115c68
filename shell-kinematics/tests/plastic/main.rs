//! Sections that yield: the law of a point, the section through its thickness, its memory.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

mod bending;
mod common;
mod derivatives;
mod paths;
mod plies;
mod points;
mod rates;
mod recovery;
mod refused;
mod sheets;
