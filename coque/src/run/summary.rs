//! What a run was and what it cost, for people and programs (`summary.json`).

use serde::Serialize;

use super::cases_summary::CasesSummary;
use super::over_time::OverTime;
use super::record::RunRecord;
use super::vibration_summary::VibrationSummary;
use crate::bodies::{Description, Resultant};
use crate::results::error_bars::Errors;

/// What a run was, what it found and what it cost.
#[derive(Clone, Debug, Serialize)]
pub struct Summary {
    /// Title of the scene.
    pub title: String,
    /// Values of the scene that the command line replaced, as `path=value`.
    pub replaced: Vec<String>,
    /// Analysis, as the scene calls it.
    pub analysis: String,
    /// What ran, with what is modelled and what is left out.
    #[serde(flatten)]
    pub body: Description,
    /// What was found.
    #[serde(flatten)]
    pub record: RunRecord,
    /// What the supports exert, reduced to the centroid, at the last record; none where nothing was recorded or known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub supports: Option<Resultant>,
    /// What was found for load cases and combinations; none in a scene without.
    #[serde(skip_serializing_if = "Option::is_none", flatten)]
    pub cases: Option<CasesSummary>,
    /// What answers to response spectra and to noise consist of; none of other analyses.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub vibration: Option<VibrationSummary>,
    /// What measured columns were over the time of the run; none where it is not asked for.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub over_time: Vec<OverTime>,
    /// Threads used.
    pub threads: usize,
    /// Processes that ran it together, each with so many threads; none where one did.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ranks: Option<usize>,
    /// Particles times steps per second of the march \[1/s\]; zero without time.
    pub particle_steps_per_second: f64,
    /// "done", or why the run ended early.
    pub ended: String,
    /// The errors of its numbers, where they were asked for.
    #[serde(flatten, skip_serializing_if = "Option::is_none")]
    pub errors: Option<Errors>,
}
