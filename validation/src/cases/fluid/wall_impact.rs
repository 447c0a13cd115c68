//! wall-impact: a dam break hits a wall; when, and with what pressure, against an experiment.

use fluid_sph::Formulation;

use crate::figures::{Axis, BLACK, BLUE, Chart, Figure, GREEN, Line, Mark, ORANGE, SKY, Series, VERMILION};
use crate::judge::{Case, Headline, Run, Runs, Variant};
use crate::support::fluids::{
    CORRECTED, DENSITY, GRAVITY, KICKS, PUBLISHED, apart, formulation, mean, published, said,
};
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/dam-break.toml");
/// Height of the column, which is twice as wide, and place of the wall \[m\].
const HEIGHT: f64 = 0.3;
const WALL: f64 = 1.61;
/// Probes with their height over the bed \[m\] and their data.
const PROBES: [(&str, f64, &str); 3] = [
    ("P1", 0.003, "dambreak_lobovsky_p1"),
    ("P3", 0.03, "dambreak_lobovsky_p3"),
    ("P4", 0.08, "dambreak_lobovsky_p4"),
];
/// Times T = t √(g/H).
const UNTIL: f64 = 5.0;
const PLATEAU: [f64; 2] = [3.5, 4.95];
/// Pressure over ρgH by which the water has arrived.
const ARRIVED: f64 = 0.15;
/// Over which pressures are averaged \[s\], and how many records that takes.
const WINDOW: f64 = 2e-3;
const RECORDS: usize = 4;

const ARRIVAL: &str = "arrival";

/// The wall, and what is measured on it.
pub fn case() -> Case {
    Case {
        name: "wall-impact",
        title: "A dam break hits a wall",
        about: "Pressures at 3, 30 and 80 mm on the wall, means over 2 ms, in parts of ρgH over T = t √(g/H). Asked are the time of \
                arrival and the plateaus of the lower two probes; the peak is a water hammer, in proportion to the speed of sound, \
                and is shown. With α = 0.1 the thin front is braked.",
        citation: "Lobovský et al. 2014, 0.3 m of water",
        variants: variants(),
        headline: Some(Headline::new(ARRIVAL, 0.5)),
        figures,
        ..Case::default()
    }
}

#[rustfmt::skip] // one line a run
fn variants() -> Vec<Variant> {
    let usual = Formulation::default();
    [
        (KICKS, 15, usual, true),
        (KICKS, 30, usual, false),
        (KICKS, 60, usual, false),
        (KICKS, 30, Formulation { viscosity: 0.1, ..usual }, false),
        (CORRECTED, 15, formulation(CORRECTED), false),
        (CORRECTED, 30, formulation(CORRECTED), false),
        (PUBLISHED, 30, formulation(PUBLISHED), false),
    ]
    .into_iter()
    .map(|(method, high, formulation, quick)| {
        let named = if method == PUBLISHED { String::new() } else { apart(&formulation) };
        hit(method, high, &formulation)
            .named(format!("H/Δx {high}{named}"))
            .quick_if(quick)
            .full_if(high > 30 || (high > 15 && method != KICKS))
            .judged(move |run, _| judged(high, &formulation, run))
    })
    .collect()
}

fn hit(method: &str, high: usize, formulation: &Formulation) -> Variant {
    let dx = HEIGHT / high as f64;
    let water = format!("{{ lengths = [{}, {HEIGHT}], spacing = {dx} }}", 2.0 * HEIGHT);
    let march = format!("{{ duration = {}, record_every = {} }}", UNTIL * second(), WINDOW / RECORDS as f64);
    let scene = Variant::scene(method, SCENE, "")
        .set("bodies.water.fluid.geometry.block", water)
        .set("bodies.water.fluid.material.liquid.sound_speed", 20.0 * (GRAVITY * HEIGHT).sqrt())
        .set("bodies.water.fluid.formulation", said(formulation))
        .set("bodies.tank.walls.geometry.basin.max", format!("[{WALL}, {}]", 2.0 * HEIGHT))
        .set("analysis.explicit.transient", march)
        .unsettled();
    PROBES.iter().fold(scene, |scene, (name, height, _)| {
        let at =
            format!("name = \"{name}\", of = \"pressure\", on = \"water.all\", at = [{WALL}, {height}, 0.0]");
        scene.set("curve[+]", format!("{{ {at} }}"))
    })
}

/// The time T = 1 \[s\].
fn second() -> f64 {
    (HEIGHT / GRAVITY).sqrt()
}

/// Means of the pressure at a probe over the window, over times; as a wall feels it, which does not pull.
fn pressures(run: &Run, probe: &str) -> Result<Vec<(f64, f64)>, JudgeError> {
    let (times, read) = (run.column("time")?, run.column(probe)?);
    let head = DENSITY * GRAVITY * HEIGHT;
    let mean = |(times, read): (&[f64], &[f64])| {
        let sum: f64 = read.iter().map(|pressure| pressure.max(0.0) / head).sum();
        ((times[RECORDS - 1] - 0.5 * WINDOW) / second(), sum / RECORDS as f64)
    };
    Ok(times.chunks_exact(RECORDS).zip(read.chunks_exact(RECORDS)).map(mean).collect())
}

/// When a pressure first is that of water that has arrived.
fn arrival(points: &[(f64, f64)]) -> Option<f64> {
    points.iter().find(|(_, pressure)| *pressure >= ARRIVED).map(|point| point.0)
}

fn peak(points: &[(f64, f64)]) -> Option<f64> {
    points.iter().map(|point| point.1).max_by(f64::total_cmp)
}

fn judged(high: usize, formulation: &Formulation, run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let asked = high >= 30 && formulation.viscosity == 0.02;
    let beside = "stands beside the default set at 30 particles a height, of which it is asked";
    let mut metrics = Vec::new();
    for (number, (probe, _, data)) in PROBES.into_iter().enumerate() {
        let (seen, found) = (published(data, [0, 1])?, pressures(run, probe)?);
        if let (0, Some(exact)) = (number, arrival(&seen)) {
            let late = Metric::compared(ARRIVAL, arrival(&found), "-", exact);
            let part = if high < 60 { 0.1 } else { 0.05 };
            metrics.push(if asked {
                late.within(
                    part * exact,
                    "asked: 10 % at 30 particles a height, 5 % from 60 on: a thin front",
                )
            } else {
                late.shown(beside)
            });
        }
        if let Some(exact) = mean(&seen, PLATEAU) {
            let level = Metric::compared(format!("plateau of {probe}"), mean(&found, PLATEAU), "-", exact);
            metrics.push(match (asked, number) {
                (false, _) => level.shown(beside),
                (true, 0 | 1) => level
                    .within(0.25 * exact, "asked of the lower probes: one experiment, one sheet of water"),
                (true, _) => level.shown("a thin sheet runs up the wall there: a few particles"),
            });
        }
        if let Some(exact) = peak(&seen) {
            let most = Metric::compared(format!("peak of {probe}"), peak(&found), "-", exact);
            metrics.push(
                most.shown("a water hammer, in proportion to the speed of sound and the size of a particle"),
            );
        }
    }
    let denser = run.outcome.fluid.as_ref().map(|fluid| 100.0 * fluid.greatest_density_error);
    metrics.extend([
        Metric::error("density error", denser, "%")
            .shown("where the front hits the wall; the speed of sound sets it"),
        Metric::error("balance", Some(run.outcome.balance), "%")
            .shown("the ledger of a flow that breaks on a wall"),
    ]);
    Ok(metrics)
}

fn figures(runs: &Runs) -> Result<Vec<Figure>, JudgeError> {
    let looks = [SKY, BLUE, GREEN, VERMILION, ORANGE];
    let mut charts = Vec::new();
    for (probe, height, data) in PROBES {
        let mut series = vec![Series::marks("experiment", published(data, [0, 1])?, BLACK, Mark::Circle)];
        for (number, run) in runs.iter().enumerate() {
            let label = format!("{}, {}", run.variant.method, run.variant.grid);
            let line = if number < looks.len() { Line::Solid } else { Line::Dashed };
            series.push(Series::line(&label, pressures(run, probe)?, looks[number % looks.len()], line));
        }
        charts.push(Figure::Chart(Chart {
            title: format!("Pressure {} mm over the bed", 1e3 * height),
            caption: "Means over 2 ms.".into(),
            x: Axis::linear("T = t √(g/H)").between(2.0, UNTIL),
            y: Axis::linear("p/ρgH").between(-0.5, 4.0),
            series,
        }));
    }
    Ok(charts)
}
