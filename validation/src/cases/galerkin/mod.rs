//! Solids without elements on strain and rotation; a new case is a file, a line here, and one in the list.

mod blade_on_root;
mod bricks;
mod cantilever;
mod column;
mod hollow_ball;
mod hot_tube;
mod nodes;
mod one_solve;
mod plates;
mod shell_and_solid;
mod speed;
mod thick_tube;

use benchmarks_ref::reference;

use super::finer;
use crate::JudgeError;
use crate::judge::{Case, Run};

/// The law of increments, with the defaults.
pub const INCREMENTS: &str = "galerkin";
/// The same shape functions with St Venant's law.
pub const ST_VENANT: &str = "galerkin St Venant";

/// Every case, in the order of table and report.
pub fn all() -> Vec<Case> {
    vec![
        cantilever::case(),
        column::case(),
        plates::case(),
        nodes::case(),
        shell_and_solid::case(),
        bricks::case(),
        speed::case(),
        thick_tube::case(),
        hollow_ball::case(),
        hot_tube::case(),
        blade_on_root::case(),
        finer::stub_solid(INCREMENTS),
        finer::pressed_pad(INCREMENTS),
    ]
}

/// The greatest distance of a column from a table, relative to that, at the levels of the run that the table has \[%\]; none if the
/// run did not reach its end.
fn off(run: &Run, column: &str, table: &[(f64, f64)]) -> Result<Option<f64>, JudgeError> {
    let mut most: Option<f64> = None;
    for &(level, known) in table {
        if let Some(found) = run.at(column, level)?.filter(|_| run.done()) {
            let error = 100.0 * (found / known - 1.0).abs();
            most = Some(most.map_or(error, |most| most.max(error)));
        }
    }
    Ok(most)
}

/// Two columns of a reference, as pairs where it has both; the second divided by a unit.
fn table(name: &str, [x, y]: [&str; 2], unit: f64) -> Result<Vec<(f64, f64)>, JudgeError> {
    let table = reference(name)?;
    let place = |name: &str| table.columns.iter().position(|column| column.name == name);
    let (x, y) = (place(x), place(y));
    let pair = |row: &Vec<serde_json::Value>| Some((row[x?].as_f64()?, row[y?].as_f64()? / unit));
    Ok(table.rows.iter().filter_map(pair).collect())
}

/// Figures of the prototype: loads and deflections of a series.
fn prototype(series: &str) -> Result<Vec<(f64, f64)>, JudgeError> {
    let table = reference("sr_galerkin_prototype")?;
    let row = |row: &Vec<serde_json::Value>| {
        let here = row[0].as_str() == Some(series);
        here.then(|| Some((row[2].as_f64()?, row[4].as_f64()?))).flatten()
    };
    Ok(table.rows.iter().filter_map(row).collect())
}

/// The greatest distance of a column from figures of the prototype.
fn from_prototype(run: &Run, column: &str, series: &str) -> Result<Option<f64>, JudgeError> {
    let mut most: Option<f64> = None;
    for (level, known) in prototype(series)? {
        if let Some(found) = run.at(column, level)?.filter(|_| run.done()) {
            most = Some(most.unwrap_or(0.0).max((found - known).abs()));
        }
    }
    Ok(most)
}

/// Why a figure may be this far from that of the prototype.
const DIGITS: &str = "five digits are known: half of the last and what Newton's tolerance leaves";
