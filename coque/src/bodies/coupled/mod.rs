//! Bodies built together: a fluid, its walls, the structures in it.

mod between;
mod body;
pub(super) mod build;
mod contact;
mod dry;
mod gauges;
mod layout;
mod probes;
mod reach;
mod soft;
pub(super) mod still;
mod structures;
mod watch;
mod watched;
