//! plank-dropped-into-water: a free solid of bonds, half as dense as water, falls into it and floats.

use crate::cases::coupled::measure::{SOLID, mean_and_deviation};
use crate::judge::{Case, Headline, Run, Variant};
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("plank.toml");
const SPACING: f64 = 0.02;
/// Tank and depth of the water, plank \[m\].
const TANK: [f64; 2] = [1.0, 0.5];
const PLANK: [f64; 2] = [0.3, 0.1];
const DENSITY: f64 = 500.0;
const END: f64 = 4.0;

const HEIGHT: &str = "height of the plank's middle";

/// The plank, and where it has to float.
pub fn case() -> Case {
    Case {
        name: "plank-dropped-into-water",
        title: "A plank falls into water and floats",
        about: "Nothing holds the plank. It floats with its middle in the surface, which its draught has \
                lifted by 15 mm.",
        citation: "Archimedes",
        variants: vec![Variant::scene(SOLID, SCENE, "15×5").unsettled().judged(|run, _| judged(run))],
        headline: Some(Headline::new(HEIGHT, 1.0)),
        ..Case::default()
    }
}

fn judged(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let late = mean_and_deviation(&run.column("time")?, &run.column("height")?, [2.0, END]);
    let floats = TANK[1] + DENSITY / 1000.0 * PLANK[0] * PLANK[1] / TANK[0];
    let denser = run.outcome.fluid.as_ref().map(|fluid| 100.0 * fluid.greatest_density_error);
    Ok(vec![
        Metric::compared(HEIGHT, late.map(|found| found.0), "m", floats)
            .within(SPACING, "a spacing: the mean from 2 to 4 s, while it still bobs"),
        Metric::error("balance", Some(run.outcome.balance), "%").shown("of 30 J/m that the plank brings"),
        Metric::error("density error", denser, "%").shown("the slap of a flat face is a peak of sound"),
    ])
}
