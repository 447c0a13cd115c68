//! two-cantilevers: a strip that bears on another one below it.
//!
//! ```text
//!  ▐━━━━━━━━━━━━━━━━━━━━  ↓ P
//!  ▐━━━━━━━━━━━━━━━━
//! ```

use benchmarks_ref::touching::two_cantilevers;

use crate::figures::{Axis, BLACK, BLUE, Chart, Figure, GREEN, Line, Series, VERMILION};
use crate::judge::{Case, Headline, Measured, Run, Runs, Variant};
use crate::methods::STATIC;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/two-cantilevers.toml");
const OFF: &str = "greatest error of the force between them";
/// Length of the lower strip over that of the upper.
const PART: f64 = 0.8;
/// B g/L³ times the width \[N\].
const UNIT: f64 = 2.1e5 * 1e3 / 12.0 * 50.0 * 0.2 / 1e9;
/// Force at the end of the upper strip at level one \[B g/L³\].
const FORCE: f64 = 12.0;

/// Errors \[% of the greatest force\].
const MEASURED: Measured = Measured(&[(STATIC, &[("100 and 70 cells", 0.0022), ("25 and 28 cells", 0.023)])]);

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "two-cantilevers",
        title: "Two cantilevers, one that bears on the other",
        about: "Two strips of unlike cells, clamped a gap apart: a force at the end of the upper one brings it down on the end of the lower \
                one, and both bear it from there on. They touch nowhere else.",
        citation: "Euler and Bernoulli's beams of small deflection",
        variants: vec![strips(25, 28), strips(100, 70)],
        each,
        headline: Some(Headline::new(OFF, 0.01)),
        figures,
        ..Case::default()
    }
}

fn strips(upper: usize, lower: usize) -> Variant {
    Variant::scene(STATIC, SCENE, format!("{upper} and {lower} cells"))
        .set("bodies.upper.shell.geometry.plate.particles", format!("[{}, 3]", upper + 1))
        .set("bodies.lower.shell.geometry.plate.particles", format!("[{}, 4]", lower + 1))
}

/// Levels and forces of a run.
fn forces(run: &Run) -> Result<Vec<(f64, f64)>, JudgeError> {
    Ok(run.column("level")?.into_iter().zip(run.column("F")?).collect())
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let most = UNIT * two_cantilevers(PART, FORCE)[0];
    let errors = forces(run)?
        .into_iter()
        .map(|(level, force)| 100.0 * (force - UNIT * two_cantilevers(PART, FORCE * level)[0]).abs() / most);
    let worst = errors.reduce(f64::max).filter(|_| run.done());
    let reason = "shear of the strips, (t/L)² of the deflection, and the depth of contact";
    Ok(vec![Metric::error(OFF, worst, "% of the greatest force").near(MEASURED.of(run)?, reason)])
}

fn figures(runs: &Runs) -> Result<Vec<Figure>, JudgeError> {
    let loads = (0..=60).map(|i| 0.2 * f64::from(i));
    let curve = loads.map(|load| (load, two_cantilevers(PART, load)[0])).collect();
    let mut series = vec![Series::line("beams", curve, BLACK, Line::Dashed)];
    let looks = [GREEN, BLUE, VERMILION];
    for (number, run) in runs.iter().enumerate() {
        let points = forces(run)?.into_iter().map(|(level, force)| (FORCE * level, force / UNIT));
        series.push(Series::line(
            &run.variant.grid,
            points.collect(),
            looks[number % looks.len()],
            Line::Solid,
        ));
    }
    Ok(vec![Figure::Chart(Chart {
        title: "Force between two cantilevers".into(),
        caption: "The lower one is .8 as long as the upper, at whose end the force P acts; g is the gap of their faces.".into(),
        x: Axis::linear("P L³/(B g)"),
        y: Axis::linear("F L³/(B g)"),
        series,
    })])
}
