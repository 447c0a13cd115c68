//! Bodies built together: a fluid, its walls, the structures in it.

mod body;
mod build;
mod gauges;
mod layout;
mod probes;
mod structures;
