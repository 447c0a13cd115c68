//! Displacements over the load against a published table: how far a run is from it, and both drawn.

use benchmarks_ref::{Curve, reference};

use super::path::distance;
use crate::JudgeError;
use crate::figures::{Axis, BLACK, BLUE, Chart, Figure, GREEN, Line, Mark, Series};
use crate::judge::measure::largest;
use crate::judge::{Measured, Metric, Run, Runs};
use crate::methods::{ELEMENTS, STATIC};

/// Unit of the distances.
const UNIT: &str = "% of the largest";

/// A problem that is held against a table.
pub struct AgainstTable {
    /// Name of the table; its column `P/Pmax` holds the load.
    pub table: &'static str,
    /// Column of the runs that holds the load.
    pub load: &'static str,
    /// Columns with displacements: of the runs, of the table, and the name of the metric.
    pub columns: &'static [(&'static str, &'static str)],
    /// Displacement in parts of which distances are counted.
    pub largest: f64,
    /// Load up to which rows are compared.
    pub until: f64,
    /// A row that is left out, by its load.
    pub without: Option<f64>,
    /// Name of the metric for the largest distance.
    pub name: &'static str,
    /// Distances \[% of the largest displacement\] when the case was last reviewed.
    pub measured: Measured,
    /// What the distance is made of.
    pub reason: &'static str,
}

impl AgainstTable {
    /// The largest distance of each displacement from the table, in percent of the largest displacement.
    pub fn errors(&self, run: &Run) -> Result<Vec<Option<f64>>, JudgeError> {
        let distances = self.columns.iter().map(|&(found, known)| self.distance(run, found, known));
        distances.map(|error| Ok(error?.map(|error| 100.0 * error / self.largest))).collect()
    }

    /// The largest of them.
    pub fn error(&self, run: &Run) -> Result<Option<f64>, JudgeError> {
        Ok(largest(self.errors(run)?))
    }

    /// The largest difference of a displacement at the table's rows, on the run's part of first rise; none if that ended before.
    fn distance(&self, run: &Run, found: &str, known: &str) -> Result<Option<f64>, JudgeError> {
        let table = reference(self.table)?;
        let rows = table.column("P/Pmax")?.into_iter().zip(table.column(known)?);
        // Straight pieces: a cubic would swing where the load hardly grows and the displacement runs.
        let (loads, values) = (run.column(self.load)?, run.column(found)?);
        let rising = 1 + loads.windows(2).take_while(|pair| pair[1] > pair[0]).count();
        let own = Curve::new(
            loads[..rising.min(loads.len())].to_vec(),
            values[..rising.min(values.len())].to_vec(),
        );
        let at = |load: f64| own.as_ref().ok().and_then(|curve| curve.at(load).ok());
        let differences = rows
            .filter(|&(load, _)| load <= self.until && self.without.is_none_or(|left_out| left_out != load))
            .map(|(load, known)| at(load).map(|found| (found - known).abs()));
        Ok(largest(differences))
    }

    /// The largest distance of the table's points from the paths of all displacements, in percent of the largest displacement
    /// and of the full load: for runs whose load falls, where [`AgainstTable::errors`] end.
    pub fn off_path(&self, run: &Run) -> Result<Option<f64>, JudgeError> {
        let (table, load) = (reference(self.table)?, run.column(self.load)?);
        let loads = table.column("P/Pmax")?;
        let mut errors = Vec::new();
        for &(found, known) in self.columns {
            let path: Vec<_> = run.column(found)?.into_iter().zip(load.iter().copied()).collect();
            let points: Vec<_> = table.column(known)?.into_iter().zip(loads.iter().copied()).collect();
            errors.push(distance(&path, &points, (self.largest, 1.0)));
        }
        Ok(largest(errors))
    }

    /// The largest distance, then that of each displacement.
    pub fn each(&self, run: &Run) -> Result<Vec<Metric>, JudgeError> {
        let (errors, measured) = (self.errors(run)?, self.measured.of(run)?);
        let all = std::iter::once((self.name, largest(errors.iter().copied())));
        let all = all.chain(self.columns.iter().map(|column| column.0).zip(errors.iter().copied()));
        Ok(all.map(|(name, error)| Metric::error(name, error, UNIT).near(measured, self.reason)).collect())
    }

    /// Table, particles and finite elements on a grid, the load over the displacements.
    pub fn figure(
        &self,
        runs: &Runs,
        grid: &str,
        [title, caption]: [&str; 2],
        [x, y]: [Axis; 2],
    ) -> Result<Vec<Figure>, JudgeError> {
        let table = reference(self.table)?;
        let loads = table.column("P/Pmax")?;
        let mut series = Vec::new();
        let mut label = "Sze et al. 2004, S4R";
        for &(_, known) in self.columns {
            let points = table.column(known)?.into_iter().zip(loads.iter().copied()).collect();
            series.push(Series::marks(std::mem::take(&mut label), points, GREEN, Mark::Cross));
        }
        for (method, words, colour, line) in
            [(STATIC, "particles", BLUE, Line::Solid), (ELEMENTS, "finite elements", BLACK, Line::Dashed)]
        {
            let Some(run) = runs.get(method, grid)? else { continue };
            let mut label = format!("{words} {grid}");
            for &(found, _) in self.columns {
                let points = run.column(found)?.into_iter().zip(run.column(self.load)?).collect();
                series.push(Series::line(&std::mem::take(&mut label), points, colour, line));
            }
        }
        Ok(vec![Figure::Chart(Chart { title: title.into(), caption: caption.into(), x, y, series })])
    }
}
