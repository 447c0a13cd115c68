//! column-on-square-plate: water in space on a square plate that is clamped all round.

use super::measure::{SHELL, mean_and_deviation};
use crate::judge::{Case, Headline, Run, Variant};
use crate::support::coupled::{GRAVITY, WATER};
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("column-on-square-plate.toml");
const MEAN: &str = "mean of the deflection";
/// End \[s\].
const END: f64 = 0.3;
/// Deflection of a clamped plate a twentieth as thick as it is wide, in q a⁴/D (`plate_static_square`).
const CLAMPED: f64 = 0.001_327_26;

/// The plate, its closed form, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "column-on-square-plate",
        title: "A cube of water on a clamped square plate",
        about: "A metre of water on a plate a twentieth as thick as it is wide, against a plate with shear \
                under the weight of both; the same particles without time are within .04 % of it. The plate alone is \
                damped. Mean and standard deviation are those of the last tenth of a second.",
        citation: "clamped plate with shear, this project's table",
        variants: [(10, true), (16, false), (20, false)]
            .map(|(cells, quick)| variant(cells).quick_if(quick))
            .into(),
        headline: Some(Headline::new(MEAN, 0.1)),
        ..Case::default()
    }
}

/// So many particles of the fluid, and cells of the shell, along a side.
fn variant(cells: usize) -> Variant {
    let dx = 1.0 / cells as f64;
    Variant::scene(SHELL, SCENE, format!("{cells}×{cells}×{cells}"))
        .set("bodies.water.fluid.geometry.block.spacing", dx)
        .set("bodies.tank.walls.geometry.basin.min", format!("[0.0, 0.0, {}]", -3.0 * dx))
        .set("bodies.plate.shell.geometry.plate.particles", format!("[{0}, {0}]", cells + 1))
        .unsettled()
        .judged(|run, _| judged(run))
}

fn judged(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let late = mean_and_deviation(&run.column("time")?, &run.column("w")?, [END - 0.1, END]);
    let stiffness = 1e9 * 0.05_f64.powi(3) / (12.0 * 0.91);
    let still = 1e3 * CLAMPED * GRAVITY * (WATER + 0.05 * 2700.0) / stiffness;
    Ok(vec![
        Metric::compared(MEAN, late.map(|found| found.0), "mm", still)
            .within(0.05 * still, "asked: 5 %; half a spacing of head is 2.5 to 5 % of the depth"),
        Metric::error("standard deviation", late.map(|found| 100.0 * found.1 / found.0), "% of the mean")
            .within(5.0, "asked: a coupling that feeds the plate swings more and more"),
    ])
}
