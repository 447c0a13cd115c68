//! What a relaxation saves against the march of the same particles.

use crate::judge::{Recorded, Run, Runs};
use crate::methods::{CELL, RELAXED};
use crate::{JudgeError, Metric};

/// Force evaluations a level of the relaxed run on a grid, over those of the explicit one.
pub fn cost(runs: &Runs, grid: &str) -> Result<Vec<Recorded>, JudgeError> {
    let (Some(marched), Some(at)) = (runs.get(CELL, grid)?, runs.number(RELAXED, grid)?) else {
        return Ok(Vec::new());
    };
    let a_level = |run: &Run| -> Result<f64, JudgeError> {
        Ok(run.outcome.steps as f64 / (run.column("level")?.len() - 1) as f64)
    };
    let ratio = a_level(&runs.chosen[at])? / a_level(marched)?;
    let found = Metric::error("evaluations a level, of a march's", Some(ratio), "-");
    Ok(vec![(
        at,
        found.within(0.1, "asked: a tenth of the force evaluations of ramp and hold at the same error"),
    )])
}
