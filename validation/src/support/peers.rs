//! Answers of other programs to nonlinear shells, each with its time over that of our run: stored figures of one machine.

use benchmarks_ref::{Reference, reference};

use crate::JudgeError;
use crate::judge::{Peer, Peers};
use crate::methods::STATIC;

/// Limit loads of the hinged panel, held against the expected one \[N\].
pub fn limit_loads(expected: f64) -> Result<Option<Peers>, JudgeError> {
    let table = reference("peers_panel")?;
    let answer = |row: usize| -> Result<Peer, JudgeError> {
        Ok(Peer {
            method: table.text(row, "program")?,
            error: 100.0 * (table.number(row, "limit load")? / expected - 1.0).abs(),
            cost: table.number(row, "time")?,
        })
    };
    let answers = (0..table.rows.len()).map(answer).collect::<Result<_, _>>()?;
    Ok(Some(Peers { method: STATIC, grid: "21×21", answers }))
}

/// Tips of a strip by program and mesh, held against `exact` = (shortening, deflection) over the length: the greatest distance
/// of the levels stored, in percent of the length.
pub fn tips(
    case: &str,
    grid: &'static str,
    exact: fn(f64) -> (f64, f64),
) -> Result<Option<Peers>, JudgeError> {
    let table = reference("peers_strips")?;
    let mut answers: Vec<Peer> = Vec::new();
    let mut mesh = String::new();
    for row in 0..table.rows.len() {
        if table.text(row, "case")? != case {
            continue;
        }
        let found = answer(&table, row, exact)?;
        let here = table.text(row, "mesh")?;
        match answers.last_mut().filter(|last| last.method == found.method && mesh == here) {
            Some(last) => last.error = last.error.max(found.error),
            None => answers.push(found),
        }
        mesh = here;
    }
    Ok(Some(Peers { method: STATIC, grid, answers }))
}

/// The answer at one level.
fn answer(table: &Reference, row: usize, exact: fn(f64) -> (f64, f64)) -> Result<Peer, JudgeError> {
    let (u, w) = exact(table.number(row, "level")?);
    let (shortening, deflection) = (table.number(row, "shortening")?, table.number(row, "deflection")?);
    Ok(Peer {
        method: table.text(row, "program")?,
        error: 100.0 * libm::hypot(shortening - u, deflection - w),
        cost: table.number(row, "time")?,
    })
}
