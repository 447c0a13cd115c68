//! The body without time: its tangent, its equilibria, and closed forms.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

mod blocks;
mod bodies;
mod closed_forms;
mod equilibria;
mod expansion;
mod griffith;
mod patch;
mod slow_cracks;
mod tangent;
mod turned;
