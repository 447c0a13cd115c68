//! hemisphere-on-flat: a hemisphere pressed by a smooth flat.
//!
//! ```text
//!   ▓▓▓▓▓▓▓▓▓   ↓ δ
//!    ╭─────╮
//!   ╱       ╲
//!   ─────────
//! ```

use benchmarks_ref::on_flats::hemisphere_on_flat;

use crate::figures::{Axis, BLACK, BLUE, Chart, Figure, Line, Series, VERMILION};
use crate::judge::{Case, Headline, Measured, Run, Runs, Variant};
use crate::methods::STATIC;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/hemisphere-on-flat.toml");
const OFF: &str = "greatest error of the force";
/// Approach at level one over the thickness; E t³/R is one.
const DOWN: f64 = 1.5;
/// Approach from which errors count: below it a disc of few cells touches.
const FROM: f64 = 0.3;

/// Errors \[% of the force\].
const MEASURED: Measured = Measured(&[(STATIC, &[("60 by 4 cells", 3.2), ("120 by 8 cells", 0.51)])]);

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "hemisphere-on-flat",
        title: "A hemisphere pressed by a flat, R/t = 100",
        about: "A quarter of a hemisphere, its equator in a plane of symmetry, under a flat that comes down to 1.5 t: the force from .4 t on, while contact \
                is a disc. Beyond 2 t the disc may snap to a dimple.",
        citation: "axisymmetric elements of CalculiX; the problem of Updike and Kalnins 1970, 1972",
        variants: vec![sphere(60, 4), sphere(120, 8)],
        each,
        headline: Some(Headline::new(OFF, 0.1)),
        figures,
        ..Case::default()
    }
}

fn sphere(cells: usize, around: usize) -> Variant {
    Variant::scene(STATIC, SCENE, format!("{cells} by {around} cells"))
        .set("geometry.sphere.particles", format!("[{}, {}]", cells + 1, around + 1))
}

/// Approaches over the thickness and forces of a run.
fn forces(run: &Run) -> Result<Vec<[f64; 2]>, JudgeError> {
    let found = run.column("level")?.into_iter().zip(run.column("F")?);
    Ok(found.map(|(level, force)| [DOWN * level, force]).collect())
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let known = hemisphere_on_flat().unwrap_or_default();
    let error = |[down, force]: [f64; 2]| {
        let row = known.iter().find(|row| (row[0] - down).abs() < 1e-6)?;
        (down > FROM).then(|| 100.0 * (force / row[1] - 1.0).abs())
    };
    let worst = forces(run)?.into_iter().filter_map(error).reduce(f64::max).filter(|_| run.done());
    let reason = "cells of a polygon that bends over √(Rt), the elements' own .3 %, a squeeze of the solid's thickness of .005 t";
    Ok(vec![Metric::error(OFF, worst, "%").near(MEASURED.of(run)?, reason)])
}

fn figures(runs: &Runs) -> Result<Vec<Figure>, JudgeError> {
    let known = hemisphere_on_flat().unwrap_or_default();
    let known = known.into_iter().filter(|row| row[0] <= DOWN).map(|[down, force]| (down, force)).collect();
    let mut series = vec![Series::line("elements", known, BLACK, Line::Dashed)];
    let looks = [BLUE, VERMILION];
    for (number, run) in runs.iter().enumerate() {
        let points = forces(run)?.into_iter().map(|[down, force]| (down, force)).collect();
        series.push(Series::line(&run.variant.grid, points, looks[number % looks.len()], Line::Solid));
    }
    Ok(vec![Figure::Chart(Chart {
        title: "Force of a flat on a hemisphere".into(),
        caption: "The approach δ counts from the first touch of the outer face.".into(),
        x: Axis::linear("δ/t"),
        y: Axis::linear("F R/(E t³)"),
        series,
    })])
}
