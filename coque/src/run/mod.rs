//! A run: what it is given, what it has found so far, how it is told, kept and ended. What it does is an analysis.

pub(crate) mod checkpoint;
pub(crate) mod impulses;
pub(crate) mod outcome;
pub(crate) mod progress;
pub(crate) mod record;
pub(crate) mod summary;
mod under_way;

pub(crate) use under_way::Run;
