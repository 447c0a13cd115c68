//! collapsed-ring: a ring under external pressure that buckles, comes onto itself and presses its walls together.
//!
//! ```text
//!    ↓ ↓ ↓ ↓ p ↓ ↓ ↓
//!   ╭───╮       ╭───╮
//!   │    ╲─────╱    │
//!   │    ╱─────╲    │
//!   ╰───╯       ╰───╯
//!    ↑ ↑ ↑ ↑ p ↑ ↑ ↑
//! ```

use benchmarks_ref::touching::{Collapsed, collapsed_rings};

use crate::figures::{Axis, BLACK, Chart, Figure, GREEN, Line, Series, VERMILION};
use crate::judge::{Case, Headline, Measured, Run, Runs, Variant};
use crate::methods::STATIC;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/ring-in-itself.toml");
const OPENING: &str = "opening before it touches";
const FORCE: &str = "force between the walls at p = 7 B/R³";
/// Thickness of the walls over R, and B times the width of the ring \[N m²/m\].
const THICKNESS: f64 = 0.05;
const BENDING: f64 = 1.2e6 * 0.05 * 0.05 * 0.05 / 12.0 * 0.1;
/// p R³/B at level one, and the force F R²/B of the pinch at that level.
const PRESSURE: f64 = 10.0;
const PINCH: f64 = 0.02;

/// Greatest errors of half of the opening from p = 3.5 B/R³ on \[% of R\].
const OF_OPENING: Measured = Measured(&[(STATIC, &[("40 cells", 0.35), ("80 cells", 0.32)])]);
/// Errors of the force \[%\].
const OF_FORCE: Measured = Measured(&[(STATIC, &[("40 cells", 0.99), ("80 cells", 0.18)])]);

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "collapsed-ring",
        title: "A ring under pressure that touches itself, t/R = 1/20",
        about: "Half of a ring under follower pressure: how far its walls are from each other before they touch, at p = 5.103 B/R³, and \
                with which force they press on each other after. Two small forces say which way it buckles; the walls bear them as well.",
        citation: "inextensible elastica by shooting; Flaherty, Keller, Rubinow 1972",
        variants: vec![ring(40), ring(80)],
        each,
        headline: Some(Headline::new(FORCE, 0.1)),
        figures,
        ..Case::default()
    }
}

fn ring(cells: usize) -> Variant {
    Variant::scene(STATIC, SCENE, format!("{cells} cells"))
        .set("geometry.cylinder.particles", format!("[{}, 3]", cells + 1))
}

/// Pressures, openings and forces of a run, as the reference has them.
fn found(run: &Run) -> Result<Vec<Collapsed>, JudgeError> {
    let levels = run.column("level")?.into_iter();
    let rows = levels.zip(run.column("b")?).zip(run.column("F")?);
    let ring = |((level, opening), force): ((f64, f64), f64)| Collapsed {
        pressure: PRESSURE * level,
        opening,
        force: force / BENDING - PINCH * level,
    };
    Ok(rows.map(ring).collect())
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let (found, exact) = (found(run)?, collapsed_rings(THICKNESS)?);
    let same = |ring: &Collapsed| exact.iter().find(|row| (row.pressure - ring.pressure).abs() < 1e-9);
    let pairs = || found.iter().filter_map(|ring| Some((ring, same(ring)?)));
    let free = pairs().filter(|(ring, exact)| exact.force == 0.0 && ring.pressure > 3.4);
    let opening = free.map(|(ring, exact)| 100.0 * (ring.opening - exact.opening).abs()).reduce(f64::max);
    let pressed = pairs().find(|(ring, _)| (ring.pressure - 7.0).abs() < 1e-9);
    let force = pressed.map(|(ring, exact)| 100.0 * (ring.force / exact.force - 1.0).abs());
    let done = |number: Option<f64>| number.filter(|_| run.done());
    Ok(vec![
        Metric::error(OPENING, done(opening), "% of R").near(
            OF_OPENING.of(run)?,
            "cells of a polygon, and walls that stretch and shear, which the elastica leaves out",
        ),
        Metric::error(FORCE, done(force), "%")
            .near(OF_FORCE.of(run)?, "the same, and what the pinch adds to the buckling"),
    ])
}

fn figures(runs: &Runs) -> Result<Vec<Figure>, JudgeError> {
    let exact = collapsed_rings(THICKNESS)?.into_iter().map(|ring| (ring.pressure, ring.opening));
    let mut series = vec![Series::line("elastica", exact.collect(), BLACK, Line::Dashed)];
    for (number, run) in runs.iter().enumerate() {
        let points = found(run)?.into_iter().map(|ring| (ring.pressure, ring.opening)).collect();
        let label = format!("{}, {}", run.variant.method, run.variant.grid);
        series.push(Series::line(&label, points, [GREEN, VERMILION][number % 2], Line::Solid));
    }
    Ok(vec![Figure::Chart(Chart {
        title: "Opening of a ring under pressure".into(),
        caption: "Its walls touch where half of the opening is half of the thickness.".into(),
        x: Axis::linear("p R³/B"),
        y: Axis::linear("b/R"),
        series,
    })])
}
