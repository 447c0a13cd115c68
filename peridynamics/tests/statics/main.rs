//! The body without time: its tangent, its equilibria, and closed forms.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

mod bodies;
mod closed_forms;
mod equilibria;
mod growth;
mod patch;
mod tangent;

#[path = "../../examples/static_cases/bar.rs"]
mod bar;
#[path = "../../examples/static_cases/blocks.rs"]
#[allow(dead_code)] // the example uses all of it
mod blocks;
#[path = "../../examples/static_cases/cantilever.rs"]
#[allow(dead_code)]
mod cantilever;
#[path = "../../examples/static_cases/hole.rs"]
#[allow(dead_code)]
mod hole;
