//! hydrostatic-column: two metres of water put at once on an aluminium strip that is clamped at both ends.

mod run;

use benchmarks_ref::fluid_structure_forms::WATER_STRIP;

use super::measure::{SHELL, SOLID, Size, mean_and_deviation, outcome};
use crate::figures::{Axis, BLACK, BLUE, Chart, Figure, Line, Series, VERMILION};
use crate::judge::{Case, Headline, Run, Runs, Variant};
use crate::support::coupled::{GRAVITY, WATER};
use crate::support::studies::{SHOWN, figure};
use crate::{JudgeError, Metric};
pub use run::{Body, Column, sag};

/// Names of columns of the curve.
pub const WAY: &str = "deflection";
pub const KINETIC: &str = "kinetic energy of the plate";
const STORED: &str = "stored energy of the plate";
const BALANCE: &str = "missing energy";
const MEAN: &str = "mean of the deflection";
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
        citation: "q L⁴/(384 D) with the weight of the strip; published particle codes are 16 % below to 8 % above",
        variants: variants(),
        headline: Some(Headline::new(MEAN, 0.1)),
        figures,
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    [(Body::Shell, 2), (Body::Shell, 4), (Body::Solid, 4), (Body::Solid, 8)]
        .into_iter()
        .map(|(body, layers)| {
            let column = Column::published(body, layers);
            let method = if body == Body::Shell { SHELL } else { SOLID };
            let variant = Variant::study(method, &format!("{layers} across"), move || column.study());
            let variant = match (body, layers) {
                (Body::Shell, 2) => variant.quick(),
                (Body::Solid, 8) => variant.heavy(),
                _ => variant.full_if(true),
            };
            variant.judged(move |run, _| judged(body, layers, run))
        })
        .collect()
}

impl Column {
    /// The curve of a run.
    ///
    /// # Errors
    /// A motion that diverges, in words.
    pub fn study(&self) -> Result<crate::judge::Outcome, String> {
        let sag = sag(self).map_err(|error| error.to_string())?;
        let size = Size {
            particles: sag.particles,
            spacing: run::THICKNESS / self.layers as f64,
            steps: sag.steps,
            seconds: sag.seconds,
        };
        let columns = [("time", "s"), (WAY, "m"), (KINETIC, "J/m"), (STORED, "J/m"), (BALANCE, "J/m")];
        Ok(outcome(size, columns, &sag.rows))
    }
}

/// Deflection of a strip of some density under the water and itself \[m\].
pub fn exact(density: f64) -> f64 {
    let strip = WATER_STRIP;
    strip.clamped_middle(GRAVITY * (WATER * run::WATER[1] + density * strip.thickness))
}

fn judged(body: Body, layers: usize, run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let (times, ways) = (run.column("time")?, run.column(WAY)?);
    let late = mean_and_deviation(&times, &ways, [0.2, 0.4]);
    let mean = Metric::compared(MEAN, late.map(|found| found.0), "m", exact(WATER_STRIP.density));
    let swing = Metric::error(SWING, late.map(|found| 100.0 * found.1 / found.0), "% of the mean");
    let soft = "bonds of four layers with ends held over three rows are softer than a clamped plate";
    let mean = if (body, layers) == (Body::Solid, 4) {
        mean.within(0.12 * exact(WATER_STRIP.density), soft)
    } else {
        mean.within(
            0.05 * exact(WATER_STRIP.density),
            "asked: 5 %, half of what published particle codes are off",
        )
    };
    Ok(vec![
        mean,
        swing.within(5.0, "asked: a coupling that feeds the plate swings more and more"),
        figure(run, BALANCE, "J/m")?.shown(SHOWN),
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
