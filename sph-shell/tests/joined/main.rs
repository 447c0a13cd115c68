//! Sheets that meet, edges tied to sheets, sets that move as rigid bodies.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

#[path = "../common/mod.rs"]
mod common;

mod hinged_bodies;
mod junction;
mod junction_arc;
mod junction_frames;
mod junction_hard;
mod junction_march;
mod junction_masses;
mod moved_bodies;
mod rigid;
mod rigid_march;
mod ties;
mod ties_answers;
mod ties_on_lines;
mod turned_sets;
