//! A run: what it is given, what it has found so far, how it is reported, kept and ended. What it does is an analysis.

mod active_run;
pub(crate) mod base_motion;
pub(crate) mod cases_summary;
pub(crate) mod checkpoint;
pub(crate) mod contact_watch;
pub(crate) mod folder;
pub(crate) mod glue_watch;
pub(crate) mod impulses;
pub(crate) mod outcome;
pub(crate) mod over_time;
pub(crate) mod progress;
pub(crate) mod record;
pub(crate) mod summary;
pub(crate) mod vibration_summary;

pub(crate) use active_run::Run;
