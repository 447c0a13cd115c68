//! option-cost: time and memory of a bare scene, and what every option adds; a scene pays only for what it names.
//!
//! The rows are marched in turn, round after round, so that whatever the machine does meanwhile hits all of them; the least time
//! of the rounds counts, their spread is the noise, and the bare scene stands in the table twice. Processor time is
//! timed between two steps of the run itself, set-up left out.

mod cost;
mod measurement;
mod rows;
mod table;

use std::sync::{Arc, OnceLock};

use coque::Column;

pub use cost::{Extent, table_rows};
pub use measurement::{measure_row, model, shell_without_scene, stir};
pub use rows::{BARE, CLAMPED, Row};
pub use table::table;

use self::cost::{Cost, measure};
use self::rows::{Pace, WITHOUT, rows};
use crate::figures::Figure;
use crate::judge::{Recorded, Runs};
use crate::{Case, JudgeError, Metric, Outcome, Run, Solver, Variant};

/// Name of the case.
pub const NAME: &str = "option-cost";
/// Metric: processor time of a particle-step \[ns\].
const TIME: &str = "time a particle-step";
/// Metric: how far the median of the rounds lies above the least \[%\].
const SPREAD: &str = "spread";
/// Metric: time beyond the row that it is added to \[%\].
const MORE_TIME: &str = "increment";
/// Metric: memory that a step touches \[bytes a particle\].
const STEP_BYTES: &str = "memory of a step";
/// Metric: memory that the run holds \[bytes a particle\].
const HELD_BYTES: &str = "memory held";

/// Some ten seconds: 2500 particles stay in the cache, and a frame of fields is spread over 200 steps.
const FULL: Extent = Extent { side: 50, steps: 200, rounds: 4 };

const TIMES: &str = "a cost: times follow the machine and its neighbours";
const BYTES: &str =
    "a cost: what is kept is an account, no error; that the bare scene keeps nothing of its own is judged";

/// The rows, and what is asked of the bare one.
pub fn case() -> Case {
    of_extent(FULL)
}

/// The case with as much marching as is asked for.
fn of_extent(extent: Extent) -> Case {
    Case {
        name: NAME,
        title: "What each option costs, alone",
        about: "A free elastic plate in motion, marched through coque with nothing named beyond geometry, material, section and \
                analysis; the same without a scene; and every option added to it alone. The rows are marched in turn, when \
                all other cases are done. Times are shown only; that the bare scene holds the arrays of the shell without a \
                scene, and no other, is asked.",
        citation: "reference: the same particles marched by the layers below coque",
        variants: variants(extent),
        each,
        together,
        figures: |runs| Ok(vec![Figure::Numbers(table(runs)?)]),
        ..Case::default()
    }
}

/// One variant a row; whichever runs first measures all.
fn variants(extent: Extent) -> Vec<Variant> {
    let measured: Arc<OnceLock<Result<Vec<Cost>, String>>> = Arc::default();
    let grid = format!("{}×{}", extent.side, extent.side);
    rows(Pace::ANY)
        .into_iter()
        .map(|row| {
            let measured = Arc::clone(&measured);
            let study = move || {
                let costs = measured.get_or_init(|| measure(&extent)).as_ref().map_err(String::clone)?;
                let cost = costs.iter().find(|cost| cost.row.name == row.name);
                Ok(outcome(cost.ok_or("the row was not measured")?))
            };
            Variant::study(row.name, &grid, study).alone()
        })
        .collect()
}

fn outcome(cost: &Cost) -> Outcome {
    let bytes = "bytes a particle";
    let mut figures = vec![
        (TIME, "ns", cost.nanoseconds),
        (SPREAD, "%", cost.spread),
        (STEP_BYTES, bytes, cost.body.step_bytes),
    ];
    figures.extend(cost.held_bytes.map(|held| (HELD_BYTES, bytes, held)));
    Outcome {
        particles: cost.body.particles,
        spacing: cost.body.spacing,
        dof: cost.body.dof,
        steps: cost.steps,
        threads: cost.row.threads,
        wall_seconds: cost.wall * 1e-9 * cost.body.particles as f64 * cost.steps as f64,
        particle_steps_per_second: 1e9 / cost.wall,
        ..Outcome::row(Solver::Explicit, &figures)
    }
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let curve = &run.outcome.curve;
    let values = curve.rows.last().into_iter().flatten();
    let metric = |(column, value): (&Column, &f64)| {
        let why = if column.unit.starts_with("bytes") { BYTES } else { TIMES };
        Metric::error(column.name.clone(), Some(*value), &column.unit).shown(why)
    };
    Ok(curve.columns.iter().zip(values).map(metric).collect())
}

/// Time beyond that of another row \[%\].
fn more_time(own: &Run, over: &Run) -> Result<f64, JudgeError> {
    let time = |run: &Run| Ok::<_, JudgeError>(run.last(TIME)?.unwrap_or(f64::NAN));
    Ok(100.0 * (time(own)? / time(over)? - 1.0))
}

fn together(runs: &Runs) -> Result<Vec<Recorded>, JudgeError> {
    let number = |name: &str| runs.iter().position(|run| run.is(name));
    let mut recorded = Vec::new();
    for row in rows(Pace::ANY) {
        let (Some(own), Some(over)) = (number(row.name), number(row.over)) else { continue };
        if own != over {
            let more = more_time(&runs.chosen[own], &runs.chosen[over])?;
            // It may be negative and is no error.
            recorded.push((own, Metric::compared(MORE_TIME, Some(more), "%", 0.0).shown(TIMES)));
        }
    }
    if let (Some(bare), Some(without)) = (number(BARE), number(WITHOUT)) {
        let reference = runs.chosen[without].last(STEP_BYTES)?.unwrap_or(f64::NAN);
        let reason = "the arrays of a shell that no scene has built, and no other: the count is exact";
        let name = format!("{STEP_BYTES}, beside no scene");
        let metric =
            Metric::compared(name, runs.chosen[bare].last(STEP_BYTES)?, "bytes a particle", reference);
        recorded.push((bare, metric.within(0.0, reason)));
    }
    Ok(recorded)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::judge::Problem;

    #[test]
    fn the_table_holds_every_row_and_the_bare_scene_no_array_of_its_own() {
        let case = of_extent(Extent { side: 8, steps: 8, rounds: 2 });
        let run = |variant: &Variant| {
            let Problem::Study(study) = &variant.source else { panic!("a row is a study") };
            Run { variant: variant.clone(), outcome: study().unwrap() }
        };
        let runs = Runs { chosen: case.variants.iter().map(run).collect(), left_out: Vec::new() };
        let mut metrics: Vec<Metric> = runs.iter().flat_map(|run| each(run).unwrap()).collect();
        metrics.extend(together(&runs).unwrap().into_iter().map(|recorded| recorded.1));
        assert!(metrics.iter().all(|metric| metric.pass));
        let judged = metrics.iter().filter(|metric| metric.tolerance.is_some());
        assert_eq!(judged.count(), 1, "only the bytes of the bare scene are asked");
        let table = table(&runs).unwrap();
        assert_eq!(table.rows.len(), rows(Pace::ANY).len());
        for line in &table.rows {
            assert_eq!(line.len(), table.head.len(), "{line:?}");
        }
    }
}
