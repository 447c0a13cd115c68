//! hydrostatic-column: two metres of water put at once on an aluminium strip that is clamped at both ends.

use benchmarks_ref::fluid_structure_forms::WATER_STRIP;

use super::measure::{SHELL, SOLID, mean_and_deviation};
use crate::figures::{Axis, BLACK, BLUE, Chart, Figure, Line, Series, VERMILION};
use crate::judge::{Case, Headline, Run, Runs, Variant};
use crate::support::coupled::{GRAVITY, WATER, raised};
use crate::{JudgeError, Metric};

const STRIP: &str = include_str!("../../../../scenes/shell-in-water.toml");
const BONDS: &str = include_str!("column-of-bonds.toml");
const WATER_ALONE: &str = "measured .2 % at two particles a thickness and .1 at four, three times that: the water bears as it weighs";
const RAISED: &str = "measured .35 % with four layers, 1.6 % with eight, three times that: the modulus is raised for bending, and shear with it; ends held over three rows";
/// Depth of the water, and thickness of the plate \[m\].
const DEPTH: f64 = 2.0;
const THICKNESS: f64 = 0.05;

/// Speed of sound of the water in both scenes \[m/s\].
pub const SOUND: f64 = 50.0;
/// The deflection in the curve.
pub const WAY: &str = "w";
const MEAN: &str = "mean of the deflection";
const THIN: &str = "the same over the closed form of a thin strip";
const SWING: &str = "standard deviation of the deflection";

/// The column, the closed form, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "hydrostatic-column",
        title: "Two metres of water on a clamped strip",
        about: "The plate and the water are at rest, the water under its hydrostatic pressure, and the \
                plate is let go: it swings about its deflection under the weight of both. Mean and \
                standard deviation are those of the deflection in the middle between .2 and .4 s; an \
                exchange of forces that feeds the plate with energy has a mean too.",
        citation: "q L⁴/(384 D) + q L²/(8 κ G t) with the weight of the strip; published: the first part alone, of which \
                   particle codes are 16 % below to 8 % above",
        variants: vec![
            strip(2, WATER_STRIP.density, 0.4).quick().judged(|run, _| judged(run, 0.006, WATER_ALONE)),
            strip(4, WATER_STRIP.density, 0.4).full_if(true).judged(|run, _| judged(run, 0.006, WATER_ALONE)),
            bonds(4).full_if(true).judged(|run, _| judged(run, 0.015, RAISED)),
            bonds(8).heavy().judged(|run, _| judged(run, 0.045, RAISED)),
        ],
        headline: Some(Headline::new(MEAN, 0.1)),
        figures,
        ..Case::default()
    }
}

/// A strip of shell of some density with so many particles of the fluid over its thickness, its stations as far apart.
pub fn strip(layers: usize, density: f64, duration: f64) -> Variant {
    let dx = THICKNESS / layers as f64;
    let march = format!("{{ safety = 0.9, transient = {{ duration = {duration}, record_every = 0.002 }} }}");
    Variant::scene(SHELL, STRIP, format!("{layers} across"))
        .set("analysis.explicit", march)
        .set("bodies.water.fluid.geometry.block.spacing", dx)
        .set("bodies.plate.shell.geometry.plate.particles", format!("[{}, 2]", 20 * layers + 1))
        .set("bodies.plate.shell.material.elastic.density", format!("{density:e}"))
        .unsettled()
}

/// A plate of layers of nodes, its modulus raised by what so many layers lose in bending.
fn bonds(layers: usize) -> Variant {
    let dx = THICKNESS / layers as f64;
    let held = 3.0 * dx;
    let block = format!(
        "{{ lengths = [{}, {THICKNESS}], origin = [{}, {}], spacing = {dx} }}",
        1.0 + 2.0 * held,
        -held,
        -THICKNESS
    );
    // The nodes about the middle.
    let (low, high) = (-0.5 * THICKNESS - 0.6 * dx, -0.5 * THICKNESS + 0.6 * dx);
    let middle = format!("{{ min = [{}, {low}, 0.0], max = [{}, {high}, 0.0] }}", 0.5 - dx, 0.5 + dx);
    Variant::scene(SOLID, BONDS, format!("{layers} across"))
        .set("bodies.water.fluid.geometry.block.spacing", dx)
        .set("bodies.plate.solid.geometry.block", block)
        .set("bodies.plate.solid.material.elastic.young", format!("{:e}", raised(67.5e9, layers)))
        .set("sets.left.layer.depth", held)
        .set("sets.right.layer.depth", held)
        .set("sets.middle.box", middle)
        .unsettled()
}

/// Deflection of a strip of some density, which shears too, under the water and itself \[m\].
pub fn exact(density: f64) -> f64 {
    let strip = WATER_STRIP;
    let pressure = GRAVITY * (WATER * DEPTH + density * strip.thickness);
    strip.clamped_middle(pressure) + strip.clamped_shear(pressure)
}

/// Asks that the mean be right to a part of it.
fn judged(run: &Run, part: f64, reason: &str) -> Result<Vec<Metric>, JudgeError> {
    let late = mean_and_deviation(&run.column("time")?, &run.column(WAY)?, [0.2, 0.4]);
    let exact = exact(WATER_STRIP.density);
    let mean = Metric::compared(MEAN, late.map(|found| found.0), "m", exact);
    let swing = Metric::error(SWING, late.map(|found| 100.0 * found.1 / found.0), "% of the mean");
    let thin =
        WATER_STRIP.clamped_middle(GRAVITY * (WATER * DEPTH + WATER_STRIP.density * WATER_STRIP.thickness));
    let over = Metric::compared(THIN, late.map(|found| found.0 / thin), "-", 1.0);
    Ok(vec![
        mean.within(part * exact, reason),
        over.shown("what is published; a strip a twentieth as thick as it is long shears by 3.6 % of it"),
        swing.within(5.0, "asked: a coupling that feeds the plate swings more and more"),
    ])
}

fn figures(runs: &Runs) -> Result<Vec<Figure>, JudgeError> {
    let mut series = vec![Series::line(
        "closed form",
        vec![(0.0, 1e6 * exact(WATER_STRIP.density)), (0.4, 1e6 * exact(WATER_STRIP.density))],
        BLACK,
        Line::Dashed,
    )];
    for run in runs.iter() {
        let ways = run.column(WAY)?.into_iter().map(|way| 1e6 * way);
        let points = run.column("time")?.into_iter().zip(ways).collect();
        let colour = if run.is(SHELL) { BLUE } else { VERMILION };
        let label = format!("{}, {}", run.variant.method, run.variant.grid);
        let line = if run.variant.grid.starts_with('2') { Line::Dashed } else { Line::Solid };
        series.push(Series::line(&label, points, colour, line));
    }
    Ok(vec![Figure::Chart(Chart {
        title: "Deflection of the middle".into(),
        caption: "The plate is let go at time zero; what it swings with goes into the water as sound.".into(),
        x: Axis::linear("time [s]"),
        y: Axis::linear("deflection [µm]"),
        series,
    })])
}
