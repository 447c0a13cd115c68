//! column-on-square-plate: water in space on a square plate that is clamped all round.

mod run;

use super::measure::{SHELL, Size, mean_and_deviation, outcome};
use crate::judge::{Case, Headline, Outcome, Run, Variant};
use crate::support::studies::{SHOWN, figure};
use crate::{JudgeError, Metric};
use run::sag;

const WAY: &str = "deflection";
const STILL: &str = "deflection without time";
const BALANCE: &str = "missing energy";
const MEAN: &str = "mean of the deflection";
/// End \[s\].
const END: f64 = 0.3;

/// The plate, its own static answer, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "column-on-square-plate",
        title: "A cube of water on a clamped square plate",
        about: "A metre of water on a plate a twentieth as thick as it is wide, against the linear \
                answer of the same shell without time under the weight of both. The plate alone is \
                damped. Mean and standard deviation are those of the last tenth of a second.",
        citation: "the same particles without time",
        variants: [(10, true), (16, false), (20, false)]
            .into_iter()
            .map(|(cells, quick)| {
                let grid = format!("{cells}×{cells}×{cells}");
                Variant::study(SHELL, &grid, move || study(cells))
                    .quick_if(quick)
                    .judged(|run, _| judged(run))
            })
            .collect(),
        headline: Some(Headline::new(MEAN, 0.1)),
        ..Case::default()
    }
}

fn study(cells: usize) -> Result<Outcome, String> {
    let found = sag(cells, END).map_err(|error| error.to_string())?;
    let size = Size {
        particles: found.particles,
        spacing: 1.0 / cells as f64,
        steps: found.steps,
        seconds: found.seconds,
    };
    let columns = [("time", "s"), (WAY, "mm"), (BALANCE, "J"), (STILL, "mm")];
    let rows: Vec<[f64; 4]> = found.rows.iter().map(|&[t, way, lost]| [t, way, lost, found.still]).collect();
    Ok(outcome(size, columns, &rows))
}

fn judged(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let late = mean_and_deviation(&run.column("time")?, &run.column(WAY)?, [END - 0.1, END]);
    let still = run.column(STILL)?[0];
    Ok(vec![
        Metric::compared(MEAN, late.map(|found| found.0), "mm", still)
            .within(0.05 * still, "asked: 5 %; half a spacing of head is 2.5 to 5 % of the depth"),
        Metric::error("standard deviation", late.map(|found| 100.0 * found.1 / found.0), "% of the mean")
            .within(5.0, "asked: a coupling that feeds the plate swings more and more"),
        figure(run, BALANCE, "J")?.shown(SHOWN),
    ])
}
