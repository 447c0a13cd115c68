//! galerkin-cost: the cantilever under St Venant's law against bricks of twenty nodes: error and cost on several meshes.

use benchmarks_ref::reference;

use super::ST_VENANT;
use crate::figures::{Axis, BLACK, BLUE, Chart, Figure, Mark, Numbers, Series};
use crate::judge::{Case, Headline, Run, Runs, Variant};
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/cantilever-solid.toml");
const NAME: &str = "tip at K = 10";

/// Nodes along the axes with their spacings, and the error when this was reviewed \[%\].
const GRIDS: [(&str, &str, f64); 4] = [
    ("11×3×3", "[25.4, 12.7, 12.7]", 2.1),
    ("21×3×3", "[12.7, 12.7, 12.7]", 0.47),
    ("41×3×3", "[6.35, 12.7, 12.7]", 0.21),
    ("21×5×5", "[12.7, 6.35, 6.35]", 0.3),
];

/// The meshes, the bricks, and how far they may differ.
pub fn case() -> Case {
    Case {
        name: "galerkin-cost",
        title: "Cantilever, K = 1 to 10: error and time beside bricks of CalculiX",
        about: "The same solid under the same dead load with St Venant's law, which is what CalculiX has. Times of bricks are stored \
                figures of processor time on this kind of machine (Xeon at 2.5 GHz), one thread, ten equal steps; errors are against the finest bricks.",
        citation: "CalculiX 2.20, C3D20 and C3D20R, this project's reference file",
        variants: variants(),
        headline: Some(Headline::new(NAME, 0.01)),
        figures,
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    let variant = |(grid, spacing, measured): (&'static str, &str, f64)| {
        Variant::scene(ST_VENANT, SCENE, grid)
            .set("bodies.beam.solid.formulation.galerkin.law", "st-venant")
            .set("bodies.beam.solid.geometry.block.spacing", spacing)
            .alone()
            .judged(move |run, _| judged(run, measured))
    };
    GRIDS.into_iter().map(variant).collect()
}

/// Deflection of the finest bricks, the last row.
fn finest() -> Result<f64, JudgeError> {
    let table = reference("calculix_cantilever")?;
    Ok(table.number(table.rows.len() - 1, "w/L at K = 10")?)
}

fn judged(run: &Run, measured: f64) -> Result<Vec<Metric>, JudgeError> {
    let found = Metric::compared(NAME, run.last("w")?, "L", finest()?);
    let seconds = Metric::error("time of the curve", Some(run.outcome.wall_seconds), "s");
    Ok(vec![
        found.near(measured, "the mesh: two quadratic layers across bend stiffly by .4 %"),
        seconds.shown("a time; what else the machine does is in it"),
    ])
}

fn figures(runs: &Runs) -> Result<Vec<Figure>, JudgeError> {
    let (table, finest) = (reference("calculix_cantilever")?, finest()?);
    let error = |w: f64| 100.0 * (w / finest - 1.0).abs();
    let (mut rows, mut ours, mut bricks) = (Vec::new(), Vec::new(), Vec::new());
    for run in runs.iter() {
        let Some(w) = run.last("w")? else { continue };
        let seconds = run.outcome.wall_seconds;
        ours.push((seconds, error(w)));
        rows.push(row(&format!("galerkin {}", run.variant.grid), run.outcome.dof as f64, error(w), seconds));
    }
    for number in 0..table.rows.len() - 1 {
        let cell = |column: &str| table.number(number, column);
        let (w, seconds) = (cell("w/L at K = 10")?, cell("processor time")?);
        bricks.push((seconds, error(w)));
        let name = table.rows[number][0].as_str().unwrap_or("");
        rows.push(row(name, 3.0 * cell("nodes")?, error(w), seconds));
    }
    let numbers = Numbers {
        title: "Error and cost".into(),
        caption: "Deflection of the tip at K = 10 against the finest bricks; ten steps.".into(),
        head: ["", "unknowns", "error [%]", "time [s]"].map(String::from).into(),
        rows,
    };
    let chart = Chart {
        title: "Error over time".into(),
        caption: "Ten load steps on one thread.".into(),
        x: Axis::log("time [s]"),
        y: Axis::log("error [%]"),
        series: vec![
            Series::marks("galerkin, quadratic", ours, BLUE, Mark::Disc),
            Series::marks("CalculiX, bricks of 20 nodes", bricks, BLACK, Mark::Cross),
        ],
    };
    Ok(vec![Figure::Numbers(numbers), Figure::Chart(chart)])
}

fn row(name: &str, unknowns: f64, error: f64, seconds: f64) -> Vec<String> {
    vec![name.into(), format!("{unknowns}"), format!("{error:.3}"), format!("{seconds:.2}")]
}
