//! What the strip cases share: the distance of the tip from where it should be, the tip's path, the rolled shapes.

use super::dial::{CELL, STATIC};
use crate::answers::DYNAMICS;
use crate::case::{Booked, Run, Runs};
use crate::measure::largest;
use crate::record::Found;
use crate::report::{Axis, BLACK, Chart, Colour, Line, Mark, Series, Shapes, Sheet, shade};
use crate::table::short;
use crate::{JudgeError, Metric};

/// Unit of all errors of strips.
pub const UNIT: &str = "% of L";

/// Distance of the tip from `exact` = (shortening, deflection), both in parts of `length`: √(Δu² + Δw²)/L in percent.
pub fn tip_error(run: &Run, level: f64, length: f64, exact: (f64, f64)) -> Result<Option<f64>, JudgeError> {
    let (u, w) = (run.at("minus_U_tip", level)?, run.at("W_tip", level)?);
    Ok(u.zip(w).map(|(u, w)| 100.0 * (u / length - exact.0).hypot(w / length - exact.1)))
}

/// How far the static run on a grid is from the explicit one: what is left of the dynamics in the latter.
///
/// `measured` is what that was \[% of L\].
pub fn still(
    runs: &Runs,
    grid: &str,
    levels: &[f64],
    length: f64,
    measured: f64,
) -> Result<Vec<Booked>, JudgeError> {
    let (Some(moving), Some(at)) = (runs.get(CELL, grid), runs.find(STATIC, grid)) else {
        return Ok(Vec::new());
    };
    let mut differences = Vec::new();
    for &level in levels {
        for column in ["minus_U_tip", "W_tip"] {
            let pair = moving.at(column, level)?.zip(runs.0[at].at(column, level)?);
            differences.push(pair.map(|(a, b)| 100.0 * (a - b).abs() / length));
        }
    }
    let found = Metric::error(DYNAMICS, largest(differences), UNIT);
    Ok(vec![(at, found.near(measured, "unfinished rest at the levels of the explicit run"))])
}

/// Judges the distance from a table that is itself off the exact curve by `table`, where a run was off by `measured` \[% of L\].
pub fn beside_table(found: Found, table: f64, measured: f64) -> Metric {
    let reason = format!(
        "the table is itself {} % of L off the exact curve; to that three times the error measured against the curve",
        short(table)
    );
    found.within(table + 3.0 * measured, reason)
}

/// Largest distance of the rows of a table from the exact tip, in percent of the length.
pub fn table_error(levels: &[f64], u: &[f64], w: &[f64], length: f64, exact: fn(f64) -> (f64, f64)) -> f64 {
    let distance = |row: usize| {
        let tip = exact(levels[row]);
        100.0 * (u[row] / length - tip.0).hypot(w[row] / length - tip.1)
    };
    (0..levels.len()).map(distance).fold(0.0, f64::max)
}

/// Tip displacements in parts of the length against the load level, with the exact law as lines.
pub fn tip_chart(
    title: &str,
    caption: &str,
    runs: &[(&Run, Colour, Mark)],
    length: f64,
    exact: impl Fn(f64) -> Option<(f64, f64)>,
) -> Result<Chart, JudgeError> {
    let levels: Vec<f64> = (0..=200).map(|i| f64::from(i) / 200.0).collect();
    let law = |pick: fn((f64, f64)) -> f64| -> Vec<(f64, f64)> {
        levels.iter().filter_map(|&level| Some((level, pick(exact(level)?)))).collect()
    };
    let mut series = vec![
        Series::line("exact: −u/L (solid), w/L (dashed)", law(|tip| tip.0), BLACK, Line::Solid),
        Series::line("", law(|tip| tip.1), BLACK, Line::Dashed),
    ];
    for (run, colour, mark) in runs {
        let level = run.column("level")?;
        let mut label = format!("{} {}", run.variant.method, run.variant.grid);
        for column in ["minus_U_tip", "W_tip"] {
            let values = run.column(column)?;
            let points = level.iter().zip(values).map(|(&level, value)| (level, value / length)).collect();
            series.push(Series::marks(&std::mem::take(&mut label), points, *colour, *mark));
        }
    }
    Ok(Chart {
        title: title.into(),
        caption: caption.into(),
        x: Axis::linear("load level"),
        y: Axis::linear("displacement of the tip / L"),
        series,
    })
}

/// The settled shapes of a run, laid over each other.
pub fn rolled_shapes(title: &str, caption: &str, run: &Run) -> Shapes {
    let sheets = run
        .outcome
        .shapes
        .iter()
        .map(|shape| {
            Sheet::new(&format!("level {}", short(shape.level)), &run.outcome, shape, shade(shape.level))
        })
        .collect();
    Shapes { title: title.into(), caption: caption.into(), view: (-62.0, 16.0), sheets }
}

/// The runs at some grid, with their looks on the dial.
pub fn on_grid<'a>(runs: &'a Runs, grid: &str) -> Vec<(&'a Run, Colour, Mark)> {
    runs.0
        .iter()
        .filter(|run| run.variant.grid == grid)
        .filter_map(|run| super::dial::setting(&run.variant.method).map(|look| (run, look.colour, look.mark)))
        .collect()
}
