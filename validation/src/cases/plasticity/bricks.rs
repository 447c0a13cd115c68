//! Loads at equal ways against a table of solid elements.

use benchmarks_ref::{Curve, reference};

use crate::JudgeError;
use crate::figures::{Axis, BLACK, BLUE, Chart, Figure, GREEN, Line, Series, VERMILION};
use crate::judge::{Run, Runs};

/// A run beside a table: columns of the way and of the load, each with its factor, and between which ways they are compared.
pub struct Bricks {
    /// Name of the table.
    pub table: &'static str,
    /// Columns of the table: way and load.
    pub known: [&'static str; 2],
    /// Columns of the run: way and load.
    pub found: [&'static str; 2],
    /// Load of the table by a unit of the run's.
    pub unit: f64,
    /// Ways between which loads are compared.
    pub between: [f64; 2],
}

impl Bricks {
    /// Ways and loads of a run, in the units of the table.
    fn path(&self, run: &Run) -> Result<Vec<[f64; 2]>, JudgeError> {
        let found = run.column(self.found[0])?.into_iter().zip(run.column(self.found[1])?);
        Ok(found.map(|(way, load)| [way, load * self.unit]).collect())
    }

    /// Greatest error of the load at the rows of the table, in percent of the row.
    pub fn worst(&self, run: &Run) -> Result<Option<f64>, JudgeError> {
        let table = reference(self.table)?;
        let path = self.path(run)?;
        // Until the way turns back, if it does.
        let on: Vec<[f64; 2]> = {
            let turns = path.windows(2).position(|pair| pair[1][0] <= pair[0][0]);
            path[..turns.map_or(path.len(), |last| last + 1)].to_vec()
        };
        let curve = Curve::new(on.iter().map(|row| row[0]).collect(), on.iter().map(|row| row[1]).collect())?;
        let mut worst = None;
        for row in 0..table.rows.len() {
            let [way, load] = [table.number(row, self.known[0])?, table.number(row, self.known[1])?];
            if !(self.between[0]..=self.between[1]).contains(&way) {
                continue;
            }
            let Ok(found) = curve.at(way) else { return Ok(None) };
            worst = Some(f64::max(worst.unwrap_or(0.0), 100.0 * (found / load - 1.0).abs()));
        }
        Ok(worst)
    }

    /// The paths of all runs beside the table.
    pub fn figure(&self, runs: &Runs, words: [&str; 2], axes: [Axis; 2]) -> Result<Vec<Figure>, JudgeError> {
        let table = reference(self.table)?;
        let paths = runs.iter().map(|run| self.path(run)).collect::<Result<Vec<_>, _>>()?;
        // As far as any run goes, whether it is compared there or not.
        let far = paths.iter().flatten().map(|row| row[0]).fold(self.between[1], f64::max);
        let ways = table.column(self.known[0])?.into_iter();
        let known = ways.zip(table.column(self.known[1])?).filter(|(way, _)| *way <= far).collect();
        let mut series = vec![Series::line("solid elements", known, BLACK, Line::Dashed)];
        let looks = [BLUE, VERMILION, GREEN];
        for (number, (run, path)) in runs.iter().zip(paths).enumerate() {
            let points = path.into_iter().map(|[way, load]| (way, load)).collect();
            let grid = &run.variant.grid;
            series.push(Series::line(grid, points, looks[number % looks.len()], Line::Solid));
        }
        let ([title, caption], [x, y]) = (words.map(String::from), axes);
        Ok(vec![Figure::Chart(Chart { title, caption, x, y, series })])
    }
}
