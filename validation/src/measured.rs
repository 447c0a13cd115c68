//! The errors that the runs of a case had when it was last reviewed: three times each is the most that it may be.

use crate::{JudgeError, Run};

/// For each method the grids on which it runs, each with its error: of a metric that has a reference in percent of that, else in
/// the unit of the metric. A grid may stand for several by the part they begin with.
pub struct Measured(pub &'static [(&'static str, &'static [(&'static str, f64)])]);

impl Measured {
    /// The error of a run; where two grids begin as that of the run does, the longer counts.
    ///
    /// # Errors
    /// [`JudgeError::NotMeasured`] for a run without a row: a new run is measured before it is judged.
    pub fn of(&self, run: &Run) -> Result<f64, JudgeError> {
        let (method, grid) = (&run.variant.method, &run.variant.grid);
        self.find(method, grid)
            .ok_or_else(|| JudgeError::NotMeasured { method: method.clone(), grid: grid.clone() })
    }

    fn find(&self, method: &str, grid: &str) -> Option<f64> {
        let methods = self.0.iter().filter(|row| row.0 == method);
        let grids = methods.flat_map(|row| row.1).filter(|known| grid.starts_with(known.0));
        grids.max_by_key(|known| known.0.len()).map(|known| known.1)
    }
}

#[test]
fn the_longer_grid_counts_and_other_runs_have_none() {
    let rows = Measured(&[("a", &[("5×3", 1.0), ("5×3 thin", 2.0)]), ("b", &[("5×3", 3.0)])]);
    for (method, grid, error) in [
        ("a", "5×3", Some(1.0)),
        ("a", "5×3 thick", Some(1.0)),
        ("a", "5×3 thin", Some(2.0)),
        ("b", "5×3 thin", Some(3.0)),
        ("b", "7×3", None),
        ("c", "5×3", None),
    ] {
        assert_eq!(rows.find(method, grid), error, "{method} {grid}");
    }
}
