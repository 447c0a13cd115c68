//! option-cost: time and memory of a bare scene, and what every option adds; a scene pays only for what it names.

use std::sync::{Arc, OnceLock};

use coque::{Column, Curve};

use crate::case::{Booked, Case, Run, Runs, Variant};
use crate::option_cost::table::{CASE, HELD_BYTES, MORE_TIME, SPREAD, STEP_BYTES, TIME};
use crate::option_cost::{BARE, Cost, Extent, Pace, WITHOUT, measure, rows};
use crate::outcome::{Outcome, Solver};
use crate::{JudgeError, Metric};

/// Some ten seconds: 2500 particles stay in the cache, and a frame of fields is spread over 200 steps.
const FULL: Extent = Extent { side: 50, steps: 200, rounds: 4 };

const SHOWN: &str = "shown: times follow the machine";

pub fn case() -> Case {
    of_extent(FULL)
}

/// The case with as much marching as is asked for.
fn of_extent(extent: Extent) -> Case {
    Case {
        name: CASE,
        title: "What each option costs, alone",
        about: "A free elastic plate in motion, marched through coque with nothing named beyond geometry, material, section and \
                analysis; the same without a scene; and every option added to it alone. The rows are marched in turn, when \
                all other cases are done. Times are shown only; that the bare scene holds the arrays of the shell without a \
                scene, and no other, is asked.",
        citation: "reference: the same particles marched by the layers below coque",
        variants: variants(extent),
        each,
        together,
        headline: None,
        figures: |_| Ok(Vec::new()),
    }
}

/// One variant a row; whichever runs first measures all.
fn variants(extent: Extent) -> Vec<Variant> {
    let measured: Arc<OnceLock<Result<Vec<Cost>, String>>> = Arc::default();
    let grid = format!("{}×{}", extent.side, extent.side);
    // Names do not depend on the pace.
    rows(Pace { side: extent.side, dt: 1.0, frame: extent.steps })
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
    let column = |name: &str, unit: &str| Column { name: name.into(), unit: unit.into() };
    let mut columns = vec![column(TIME, "ns"), column(SPREAD, "%"), column(STEP_BYTES, "bytes a particle")];
    let mut row = vec![cost.nanoseconds, cost.spread, cost.body.step_bytes];
    if let Some(held) = cost.held_bytes {
        columns.push(column(HELD_BYTES, "bytes a particle"));
        row.push(held);
    }
    Outcome {
        solver: Solver::Explicit,
        curve: Curve { columns, rows: vec![row] },
        particles: cost.body.particles,
        spacing: cost.body.spacing,
        dof: cost.body.dof,
        steps: cost.steps,
        threads: cost.row.threads,
        wall_seconds: cost.wall * 1e-9 * cost.body.particles as f64 * cost.steps as f64,
        particle_steps_per_second: 1e9 / cost.wall,
        stable_step: 0.0,
        restless: 0,
        critical: Vec::new(),
        failure: None,
        shapes: Vec::new(),
        faces: Vec::new(),
    }
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let curve = &run.outcome.curve;
    let values = curve.rows.last().into_iter().flatten();
    let metric = |(column, value): (&Column, &f64)| {
        Metric::error(column.name.clone(), Some(*value), &column.unit).because(SHOWN)
    };
    Ok(curve.columns.iter().zip(values).map(metric).collect())
}

fn together(runs: &Runs) -> Result<Vec<Booked>, JudgeError> {
    let number = |name: &str| runs.0.iter().position(|run| run.variant.method == name);
    let last = |at: usize, column: &str| -> Result<f64, JudgeError> {
        Ok(runs.0[at].column(column)?.last().copied().unwrap_or(f64::NAN))
    };
    let mut booked = Vec::new();
    for row in rows(Pace { side: 2, dt: 1.0, frame: 1 }) {
        let (Some(own), Some(over)) = (number(row.name), number(row.over)) else { continue };
        if own != over {
            let more = 100.0 * (last(own, TIME)? / last(over, TIME)? - 1.0);
            booked.push((own, signed(MORE_TIME, more, "%").because(SHOWN)));
        }
    }
    if let (Some(bare), Some(without)) = (number(BARE), number(WITHOUT)) {
        let reference = last(without, STEP_BYTES)?;
        let reason = "the arrays of a shell that no scene has built, and no other: the count is exact";
        let name = format!("{STEP_BYTES}, beside no scene");
        let metric = Metric::compared(name, Some(last(bare, STEP_BYTES)?), "bytes a particle", reference);
        booked.push((bare, metric.within(0.0, reason)));
    }
    Ok(booked)
}

/// A number that may be negative and is no error.
fn signed(name: &str, value: f64, unit: &str) -> Metric {
    Metric::compared(name, Some(value), unit, 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::Problem;
    use crate::option_cost::what_each_option_costs;
    use crate::{CaseResult, Record};

    #[test]
    fn the_table_holds_every_row_and_the_bare_scene_no_array_of_its_own() {
        let case = of_extent(Extent { side: 8, steps: 8, rounds: 2 });
        let run = |variant: &Variant| {
            let Problem::Study(study) = &variant.source else { panic!("a row is a study") };
            Run { variant: variant.clone(), outcome: study().unwrap() }
        };
        let runs = Runs(case.variants.iter().map(run).collect());
        let record =
            |run: &Run| Record::new(case.name, &run.variant.method, &run.outcome, each(run).unwrap());
        let mut records: Vec<Record> = runs.0.iter().map(record).collect();
        for (number, metric) in together(&runs).unwrap() {
            records[number].metrics.push(metric);
        }
        assert!(records.iter().all(Record::passes));
        let judged = records.iter().flat_map(|record| &record.metrics).filter(|m| m.tolerance.is_some());
        assert_eq!(judged.count(), 1, "only the bytes of the bare scene are asked");
        let table = what_each_option_costs(&[CaseResult { case, runs, records, picture: None }]).unwrap();
        assert_eq!(table.rows.len(), rows(Pace { side: 8, dt: 1.0, frame: 8 }).len());
        for line in &table.rows {
            assert_eq!(line.len(), table.head.len(), "{line:?}");
        }
    }
}
