//! Shells of scenes, in every analysis.

#![allow(clippy::unwrap_used)] // a failed test may stop here

#[path = "../common/mod.rs"]
mod common;
#[path = "../../../mesh-io/tests/common/mod.rs"]
mod meshes;
#[path = "../common/strip.rs"]
mod strip;

mod branches;
mod buckling;
mod by_temperature;
mod cases;
mod conduction;
mod conjugate_gradients;
mod drilling;
mod enclosed;
mod envelopes;
mod given;
mod harmonic;
mod harmonic_cases;
mod harmonic_words;
mod heat;
mod heat_in_time;
mod imperfection;
mod initial_stress;
mod layered;
mod linear;
mod mesh_panel;
mod mesh_scenes;
mod moved_buckling;
mod parts;
mod plies;
mod ply_stresses;
mod preload;
mod recovered;
mod rigid;
mod scattered;
mod section_forces;
mod sections;
mod spectra;
mod spectra_words;
mod stability;
mod statics;
mod stiffeners;
mod stress_fields;
mod turned_sprung;
mod warnings;
mod warped;
