//! Peridynamic solids: from the scene's words to `peridynamics`.

mod body;
mod build;
mod conditions;
mod describe;
mod doubts;
mod fields;
mod parts;
mod sets;
