//! box-in-waves: a box that floats in regular waves, held, free to rise, and on a soft mooring, beside linear potential flow.
//!
//! ```text
//!  ▌  ~  ~  ~  ~ ┌─────┐ ~  ~  ~ |
//!  ▌→            └─────┘    beach|
//!  └─────────────────────────────┘
//! ```

use std::f64::consts::TAU;

use benchmarks_ref::box_in_waves::{BoxInWaves, Coefficients, Response, Ways};

use super::regular_waves::RegularWaves;
use crate::figures::{Axis, BLACK, BLUE, Chart, Figure, Line, ORANGE, Series};
use crate::judge::{Case, Headline, Run, Runs, Variant};
use crate::methods::RIGID;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/box-in-waves.toml");
const FLUME: &str = include_str!("../../../../scenes/wave-flume.toml");
const HEAVE: &str = "heave over the height of the waves";
const SWAY: &str = "sway over the height of the waves";
const ROLL: &str = "roll over the slope of the waves";
const PUSH: &str = "push of the waves over ρg times their amplitude";
const LIFT: &str = "lift of the waves over ρg times their amplitude";
const BEHIND: &str = "height behind the box over that of the waves";
const DRIFT: &str = "mean push over ρg times the square of the amplitude";
/// Density of water times gravity \[N/m³\], by which forces of a metre of width are.
const WEIGHT: f64 = 9810.0;
/// When boxes that move have settled: waves grow for two periods, their groups take 2.3 s to the box; little of them comes back from there.
const SETTLED: RegularWaves = RegularWaves { period: 1.0, depth: 0.3, from: 5.0, periods: 2.0 };
/// A box that is held sends three quarters of the height back: from when the full waves are there until what it has sent is back from the piston, by the speed of their groups.
const HELD: RegularWaves = RegularWaves { from: 4.4, ..SETTLED };
const DURATION: &str = "7.0";
/// Middle of the box \[m\], and the gauges of the flume without it before its beach, decimetres from the wall, with those between the two of a pair.
const MIDDLE: f64 = 2.11;
const GAUGES: std::ops::RangeInclusive<u32> = 12..=26;
const APART: usize = 4;
/// The box; its mooring is 10 N/m for a width of .1 m.
const BOX: BoxInWaves =
    BoxInWaves { depth: 0.3, section: [0.3, 0.12], draught: 0.06, mooring: 0.1, gravity: 9.81 };
/// Functions below the box: heave and sway are within .03 %, roll within .15 %.
const TERMS: usize = 40;

/// A box, its reference, and how far it may be off.
pub fn case() -> Case {
    let mut variants = Vec::new();
    for (spacing, name) in [(0.02, "3 spacings of draught"), (0.01, "6 spacings of draught")] {
        let scene = |text, what: &str| {
            let run = Variant::scene(RIGID, text, format!("{what}, {name}"))
                .set("analysis.explicit.transient.duration", DURATION)
                .set("bodies.water.fluid.geometry.block.spacing", spacing)
                .set("output", "{}")
                .unsettled();
            if spacing < 0.02 { run.heavy() } else { run.full_if(true) }
        };
        let boxed = |supports: &str, what: &'static str, free: Ways<bool>| {
            let (flume, waves) = (format!("no box, {name}"), if free[1] { SETTLED } else { HELD });
            scene(SCENE, what).set("supports", supports).judged(move |run, runs| {
                let height = runs.get(RIGID, &flume)?.map(|flume| incident(flume, &waves)).transpose()?;
                judged(run, &waves, height.flatten(), free)
            })
        };
        let upright = "[{ on = 'box.all', held = { displacement = [[1, 0, 0]], director = [[1, 0, 0]] } }]";
        variants.extend([
            scene(FLUME, "no box")
                .set("bodies.water.fluid.geometry.block.lengths", "[4.0, 0.3]")
                .set("bodies.water.fluid.beach.from", "[2.6, 0.0, 0.0]")
                .set("bodies.flume.walls.geometry.basin.max", "[4.0, 0.45]")
                .set("curve", gauges()),
            boxed(upright, "rises alone", [false, true, false]),
            boxed("[{ on = 'box.all', clamped = {} }]", "held", [false; 3]),
            boxed("[]", "moored", [true; 3]),
        ]);
    }
    Case {
        name: "box-in-waves",
        title: "A box in waves",
        about: "Regular waves come to a box that floats, which rises alone, is held or swings on a soft mooring. Their height at its place is that of the same flume without it. Held \
                against linear potential flow by eigenfunctions: how it moves, what it bears, what goes on behind it, and the mean force that drives it along.",
        citation: "linear potential flow, benchmarks-ref/src/box_in_waves; mean force [maruo1960]",
        variants,
        headline: Some(Headline::new(HEAVE, 0.1)),
        figures,
        ..Case::default()
    }
}

fn places() -> Vec<(f64, String)> {
    GAUGES.map(|place| (0.1 * f64::from(place), format!("h{place}"))).collect()
}

/// The gauges as columns of the curve.
fn gauges() -> String {
    let of = |(x, name): &(f64, String)| {
        format!("{{ name = \"{name}\", of = \"level\", on = \"water.all\", at = [{x:.1}, 0.0, 0.0] }}")
    };
    format!("[{}]", places().iter().map(of).collect::<Vec<String>>().join(", "))
}

/// Height of the waves at the place of the box, without it \[m\].
fn incident(flume: &Run, waves: &RegularWaves) -> Result<Option<f64>, JudgeError> {
    let course = waves.course(flume, &places(), APART)?.filter(|_| flume.done());
    Ok(course.map(|[start, rate]| start * libm::exp(-rate * MIDDLE)))
}

/// What linear theory has.
fn theory(free: Ways<bool>) -> Option<(Coefficients, Response)> {
    let water = BOX.coefficients(TAU / SETTLED.period, TERMS)?;
    let response = BOX.response(&water, free)?;
    Some((water, response))
}

/// Swing from one end to the other of the first harmonic of a column, without the way that it drifts from one period to the next.
fn swing(run: &Run, waves: &RegularWaves, name: &str) -> Result<Option<f64>, JudgeError> {
    let (time, all) = (run.column("time")?, run.column(name)?);
    let kept = waves.kept(&time, &all);
    let (first, last) = kept.split_at(kept.len() / 2);
    let mean = |rows: &[[f64; 2]]| rows.iter().map(|row| row[1]).sum::<f64>() / rows.len() as f64;
    let drift = (mean(last) - mean(first)) / (0.5 * waves.periods * waves.period);
    let still: Vec<f64> = time.iter().zip(&all).map(|(t, x)| x - drift * t).collect();
    let found = waves.harmonic(&time, &still).filter(|_| run.done());
    Ok(found.map(|[x, y]| libm::hypot(x, y)))
}

/// Mean of a column over the periods that are measured.
fn mean(run: &Run, waves: &RegularWaves, name: &str) -> Result<Option<f64>, JudgeError> {
    let kept = waves.kept(&run.column("time")?, &run.column(name)?);
    let found = kept.iter().map(|row| row[1]).sum::<f64>() / kept.len() as f64;
    Ok(Some(found).filter(|_| run.done() && !kept.is_empty()))
}

fn judged(
    run: &Run,
    waves: &RegularWaves,
    height: Option<f64>,
    free: Ways<bool>,
) -> Result<Vec<Metric>, JudgeError> {
    let Some((water, response)) = theory(free) else { return Ok(Vec::new()) };
    // A swing over that of the surface, in this unit.
    let over = |name: &str, unit: f64| -> Result<Option<f64>, JudgeError> {
        Ok(swing(run, waves, name)?.zip(height).map(|(found, height)| found / height / unit))
    };
    let compared = |name: &str, found: Option<f64>, exact: f64| Metric::compared(name, found, "-", exact);
    let part = |exact: f64, part: f64| part * exact;
    let mut metrics = Vec::new();
    if free[1] {
        let exact = response.moved[1].norm();
        metrics.push(compared(HEAVE, over("heave", 1.0)?, exact).within(
            part(exact, 0.1),
            "vortices leave the corners, which takes more of high waves than of low ones, and 20 mm have what 10 mm have: measured −5 to −7 % at both; asked 10 %",
        ));
    }
    if free[0] {
        let [sway, roll] = [0, 2].map(|way| response.moved[way].norm());
        metrics.push(
            compared(SWAY, over("sway", 1.0)?, sway)
                .within(part(sway, 0.1), "measured 1 % at both spacings; asked 10 %"),
        );
        metrics.push(compared(ROLL, over("roll", water.number)?, roll / water.number).within(
            part(roll / water.number, 0.3),
            "its own swing of .81 s, begun by the first waves, is not gone by then: from second to second it is 3 % above to 13 % below; measured 9 and 2 %",
        ));
    }
    if free == [false; 3] {
        let scaled = |way: usize| water.push[way].norm() / BOX.gravity;
        let reason = "lost at the corners to vortices, as the height behind it, which was not looked at apart; measured 5 to 6 % with 20 mm; asked 10 %";
        for (name, column, way) in [(PUSH, "push", 0), (LIFT, "lift", 1)] {
            let exact = scaled(way);
            metrics.push(compared(name, over(column, WEIGHT)?, exact).within(part(exact, 0.1), reason));
        }
        let behind = water.held[1].norm();
        metrics.push(compared(BEHIND, over("h_behind", 1.0)?, behind).within(
            part(behind, 0.1),
            "lost on the way, and to vortices at the corners; measured 4 % with 20 mm; asked 10 %",
        ));
        let drift = response.drift / BOX.gravity;
        let pushed = mean(run, waves, "push_mean")?.zip(height);
        let found = pushed.map(|(push, height)| 4.0 * push / (WEIGHT * height * height));
        metrics.push(compared(DRIFT, found, drift).within(
            part(drift, 0.5),
            "along the waves, as they go; of the second order, as levels are that a flume without an end at rest does not have; measured 31 % with 20 mm",
        ));
    }
    Ok(metrics)
}

fn figures(runs: &Runs) -> Result<Vec<Figure>, JudgeError> {
    let rising: Vec<_> = runs.iter().filter(|run| run.variant.grid.starts_with("rises")).collect();
    let Some(first) = rising.first() else { return Ok(Vec::new()) };
    let mut series = Vec::new();
    for (run, colour) in rising.iter().zip([BLUE, ORANGE]) {
        let points = run.column("time")?.into_iter().zip(run.column("heave")?).collect();
        series.push(Series::line(&run.variant.grid, points, colour, Line::Solid));
    }
    let size = theory([false, true, false]).map_or(f64::NAN, |(_, response)| 0.02 * response.moved[1].norm());
    let bound = |sign: f64| vec![(0.0, sign * size), (7.0, sign * size)];
    series.push(Series::line("linear potential flow, waves of 40 mm", bound(1.0), BLACK, Line::Dashed));
    series.push(Series::line("", bound(-1.0), BLACK, Line::Dashed));
    Ok(vec![Figure::Chart(Chart {
        title: first.variant.method.clone(),
        caption: "Heave of the box that rises alone.".into(),
        x: Axis::linear("t [s]"),
        y: Axis::linear("heave [m]"),
        series,
    })])
}
