//! pressed-ring: a ring between two smooth plates, from the first touch to lying flat on them.
//!
//! ```text
//!    ▓▓▓▓▓▓▓▓▓   ↓ P
//!     ╭─────╮
//!     │     │    H
//!     ╰─────╯
//!    ▓▓▓▓▓▓▓▓▓
//! ```

use benchmarks_ref::touching::pressed_ring;

use crate::figures::{Axis, BLACK, BLUE, Chart, Figure, GREEN, Line, Series, VERMILION};
use crate::judge::{Case, Headline, Measured, Run, Runs, Variant};
use crate::methods::{CELL, STATIC};
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/ring-between-plates.toml");
const OFF: &str = "greatest error of the force";
/// Height that the plate takes off the half ring by level one.
const DOWN: f64 = 0.7;
/// B times the width of the ring \[N m\].
const BENDING: f64 = 1.2e6 * 0.02 * 0.02 * 0.02 / 12.0 * 0.1;

/// Errors \[% of the force\].
const MEASURED: Measured = Measured(&[
    (STATIC, &[("20 cells", 2.3), ("40 cells", 0.31), ("80 cells", 0.093)]),
    (CELL, &[("40 cells", 0.18)]),
]);

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "pressed-ring",
        title: "A ring pressed between plates, t/R = 1/50",
        about: "A quarter of the ring under a plate that comes down to .3 R: the force at every level against the elastica, before the \
                crown flattens at P = 2.786 B/R² and after, where the ring touches along two lines that move apart. Thickness counts: the \
                middles of the sides are nearer than the plates by it.",
        citation: "quadratures of the inextensible elastica, after Frisch-Fay 1962",
        variants: vec![
            ring(STATIC, 20),
            ring(STATIC, 40),
            ring(STATIC, 80),
            // How many iterations a front of contact takes follows the last bits of a factor, and so the machine: the march alone is reviewed.
            ring(CELL, 40).set("analysis", "{ explicit = { quasi-static = { levels = 14 } } }").quick(),
        ],
        each,
        headline: Some(Headline::new(OFF, 0.05)),
        figures,
        ..Case::default()
    }
}

fn ring(method: &str, cells: usize) -> Variant {
    Variant::scene(method, SCENE, format!("{cells} cells"))
        .set("geometry.cylinder.particles", format!("[{}, 3]", cells + 1))
}

/// Force on a plate at a level \[N\].
fn exact(level: f64) -> f64 {
    BENDING * pressed_ring(2.0 * (1.0 - DOWN * level))
}

/// Levels and forces of a run.
fn forces(run: &Run) -> Result<Vec<(f64, f64)>, JudgeError> {
    let found = run.column("level")?.into_iter().zip(run.column("P")?);
    Ok(found.filter(|(level, _)| *level > 0.0).collect())
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let errors = forces(run)?.into_iter().map(|(level, force)| 100.0 * (force / exact(level) - 1.0).abs());
    let worst = errors.reduce(f64::max).filter(|_| run.done());
    let reason =
        "half a cell at the lines of contact, which stand between vertices; t/R = 1/50 stretches by .1 %";
    Ok(vec![Metric::error(OFF, worst, "%").near(MEASURED.of(run)?, reason)])
}

fn figures(runs: &Runs) -> Result<Vec<Figure>, JudgeError> {
    let levels = (1..=100).map(|i| 0.01 * f64::from(i));
    let curve = levels.map(|level| (2.0 * (1.0 - DOWN * level), exact(level) / BENDING)).collect();
    let mut series = vec![Series::line("elastica", curve, BLACK, Line::Dashed)];
    let looks = [GREEN, BLUE, VERMILION];
    for (number, run) in runs.iter().enumerate() {
        let points =
            forces(run)?.into_iter().map(|(level, force)| (2.0 * (1.0 - DOWN * level), force / BENDING));
        let label = format!("{}, {}", run.variant.method, run.variant.grid);
        series.push(Series::line(&label, points.collect(), looks[number % looks.len()], Line::Solid));
    }
    Ok(vec![Figure::Chart(Chart {
        title: "Force on a ring between plates".into(),
        caption: "H is the distance of the middles of the sides. The crown flattens at 1.436 R.".into(),
        x: Axis::linear("H/R"),
        y: Axis::linear("P R²/B"),
        series,
    })])
}
