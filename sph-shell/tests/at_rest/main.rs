//! Shells at rest: statics, paths, modes, what bears and loads them, sections.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

#[path = "../common/mod.rs"]
mod common;

mod beams_on_springs;
mod conduction;
mod drilling;
mod enclosed;
mod even_bed;
mod flat_bars;
mod heat;
mod heat_in_time;
mod inertia;
mod initial_stress;
mod iterative;
mod kept_factors;
mod layered;
mod load_stiffness;
mod modes;
mod more_springs;
mod newton;
mod patch;
mod preload;
mod prescribed;
mod prestressed;
mod regions;
mod relaxation;
mod results;
mod rolled;
mod sections;
mod shifted;
mod springs;
mod statics;
mod stiffened_answers;
mod stiffeners;
mod uneven;
