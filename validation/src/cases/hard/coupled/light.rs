//! light-structure: plates a tenth, once and ten times as dense as the water that they carry.

use crate::cases::coupled::column::{Body, Column, WAY, exact};
use crate::cases::coupled::measure::mean_and_deviation;
use crate::judge::{Case, Headline, Run, Variant};
use crate::support::coupled::{GRAVITY, WATER};
use crate::support::studies::figure;
use crate::{JudgeError, Metric};

const MEAN: &str = "mean of the deflection";
const SWING: &str = "standard deviation";
const NUMBER: &str = "ρ₀c₀Δt over the plate's mass";
const BALANCE: &str = "missing energy";
/// Densities of the plate over that of water.
const RATIOS: [f64; 3] = [0.1, 1.0, 10.0];
const LAYERS: usize = 1;
/// Window in which the plate is watched \[s\].
const LATE: [f64; 2] = [0.2, 0.4];

/// The column on plates of other densities, its weight being that of the water.
pub fn case() -> Case {
    Case {
        name: "light-structure",
        title: "Plates lighter than the water that they carry",
        about: "The column of hydrostatic-column at one spacing a thickness, on plates of other \
                densities. Couplings that take a load and a motion in turn are said to fail where the \
                fluid adds more mass than the structure has. The number that counts is ρ₀c₀Δt/(ρ_s t): \
                how much of its speed a plate loses to sound in one step of the fluid.",
        citation: "closed form, as hydrostatic-column",
        variants: RATIOS
            .into_iter()
            .map(|ratio| {
                let column = Column { density: ratio * WATER, ..Column::published(Body::Shell, LAYERS) };
                let grid = format!("ρ_s/ρ₀ = {ratio}");
                Variant::study("shell", &grid, move || column.study())
                    .judged(move |run, _| judged(&column, run))
            })
            .collect(),
        headline: Some(Headline::new(MEAN, 0.1)),
        ..Case::default()
    }
}

fn judged(column: &Column, run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let late = mean_and_deviation(&run.column("time")?, &run.column(WAY)?, LATE);
    let exact = exact(column.density);
    let steps = run.outcome.steps as f64;
    let sound = 10.0 * (GRAVITY * 2.0).sqrt();
    let number = WATER * sound * column.duration / (steps * column.density * 0.05);
    let swing = Metric::error(SWING, late.map(|found| 100.0 * found.1 / found.0), "% of the mean");
    Ok(vec![
        Metric::compared(MEAN, late.map(|found| found.0), "m", exact)
            .within(0.1 * exact, "two and a half percent of head are half a spacing; the rest is the kernel"),
        if column.density > 5.0 * WATER {
            swing.within(10.0, "measured 3.5 %: a heavy plate is slower to give its swing to the water")
        } else {
            swing.within(5.0, "a coupling that feeds the plate swings more and more")
        },
        Metric::error(NUMBER, Some(number), "-").shown("no bound was met up to here"),
        figure(run, BALANCE, "J/m")?.shown("the greater part is of the fluid"),
    ])
}
