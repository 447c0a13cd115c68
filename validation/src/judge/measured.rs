//! The errors that the runs of a case had when it was last reviewed: three times each is the most that it may be.

use super::variant::Run;
use crate::JudgeError;

/// For each method the grids on which it runs, each with its error: of a metric that has a reference in percent of that, else in
/// the unit of the metric.
pub struct Measured(pub &'static [(&'static str, &'static [(&'static str, f64)])]);

impl Measured {
    /// The error of a run.
    ///
    /// # Errors
    /// [`JudgeError::NotMeasured`] for a run without a row: a new run is measured before it is judged.
    pub fn of(&self, run: &Run) -> Result<f64, JudgeError> {
        let (method, grid) = (&run.variant.method, &run.variant.grid);
        let mut grids = self.0.iter().filter(|row| row.0 == method).flat_map(|row| row.1);
        grids
            .find(|known| known.0 == grid)
            .map(|known| known.1)
            .ok_or_else(|| JudgeError::NotMeasured { method: method.clone(), grid: grid.clone() })
    }
}
