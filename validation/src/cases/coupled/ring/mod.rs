//! ring-in-fluid: an elastic ring swings as an oval inside a fluid that a rigid wall confines.

mod run;

use std::f64::consts::TAU;

use benchmarks_ref::fluid_structure_forms::RING;

use super::measure::{SHELL, Size, outcome};
use crate::figures::{Axis, BLACK, BLUE, Chart, Figure, Line, Series, VERMILION};
use crate::judge::{Case, Headline, Outcome, Runs, Variant};
use crate::support::studies::{SHOWN, figure};
use crate::{JudgeError, Metric};
use run::{Ring, swing};

const WAY: &str = "oval";
const BALANCE: &str = "missing energy";
const FREQUENCY: &str = "frequency";
const RATIO: &str = "wet over dry";
/// Waves around.
const WAVES: u32 = 2;
/// Densities of the fluid \[kg/m³\].
const LEVELS: [f64; 3] = [14.0, 140.0, 1400.0];

/// The ring, its closed forms, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "ring-in-fluid",
        title: "A ring that swings as an oval in a fluid annulus",
        about: "The ring starts round, with the velocities of its second mode, the fluid with those of its \
                potential flow. Frequencies come from the times at which the ring goes through its rest. \
                The fluid adds the mass of its potential flow to that of the ring: a tenth of it, as much, \
                ten times as much. There is no free surface; ring and wall do not pull, for with walls that \
                do (confined) the motion of the heaviest grows. The way is less than a twentieth of the \
                spacing: what is measured is the exchange of momentum alone.",
        citation: "thin ring in an annulus of potential flow; the dry continuum is .5 % lower",
        variants: variants(),
        together,
        headline: Some(Headline::new(RATIO, 0.1)),
        figures,
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    let dry = |layers: usize| {
        let ring = Ring { density: None, layers, period: TAU / RING.dry(WAVES) };
        Variant::study(SHELL, &grid(layers, None), move || study(&ring)).quick_if(layers == 2)
    };
    let wet = |layers: usize, density: f64| {
        let ring = Ring { density: Some(density), layers, period: TAU / RING.wet(WAVES, density, outer()) };
        Variant::study(SHELL, &grid(layers, Some(density)), move || study(&ring))
            .quick_if(layers == 2 && density == 140.0)
            .full_if(layers > 2)
    };
    let mut variants = Vec::new();
    for layers in [2, 4] {
        variants.push(dry(layers).judged(move |run, _| {
            let exact = RING.dry(WAVES);
            let found = Metric::compared(FREQUENCY, run.last(FREQUENCY)?, "1/s", exact);
            Ok(vec![
                found.within(0.01 * exact, "asked: 1 %; shear and rotary inertia lower it by half of that"),
            ])
        }));
        let densities: &[f64] = if layers == 2 { &LEVELS } else { &LEVELS[1..2] };
        variants.extend(densities.iter().map(|&density| {
            wet(layers, density).judged(move |run, _| {
                let exact = RING.wet(WAVES, density, outer());
                Ok(vec![
                    Metric::compared(FREQUENCY, run.last(FREQUENCY)?, "1/s", exact).shown(SHOWN),
                    figure(run, BALANCE, "J/m")?.shown(SHOWN),
                ])
            })
        }));
    }
    variants
}

fn grid(layers: usize, density: Option<f64>) -> String {
    let fluid = density.map_or_else(|| "dry".into(), |density| format!("in {density} kg/m³"));
    format!("{layers} across, {fluid}")
}

/// Radius at which the fluid acts \[m\].
fn outer() -> f64 {
    run::RADIUS + 0.5 * run::THICKNESS
}

fn study(ring: &Ring) -> Result<Outcome, String> {
    let oval = swing(ring).map_err(|error| error.to_string())?;
    let frequency = oval.frequency().ok_or("the ring does not swing")?;
    let size = Size {
        particles: oval.particles,
        spacing: run::THICKNESS / ring.layers as f64,
        steps: oval.steps,
        seconds: oval.seconds,
    };
    let columns = [("time", "s"), (WAY, "mm"), (BALANCE, "J/m"), (FREQUENCY, "1/s")];
    let rows: Vec<[f64; 4]> = oval.rows.iter().map(|&[t, way, lost]| [t, way, lost, frequency]).collect();
    Ok(outcome(size, columns, &rows))
}

fn together(runs: &Runs) -> Result<Vec<(usize, Metric)>, JudgeError> {
    let mut recorded = Vec::new();
    for layers in [2, 4] {
        let Some(dry) = runs.get(SHELL, &grid(layers, None))? else { continue };
        let Some(dry) = dry.last(FREQUENCY)? else { continue };
        for density in LEVELS {
            let Some(number) = runs.find(SHELL, &grid(layers, Some(density))) else { continue };
            let exact = RING.wet(WAVES, density, outer()) / RING.dry(WAVES);
            let ratio = runs.chosen[number].last(FREQUENCY)?.map(|wet| wet / dry);
            let found = Metric::compared(RATIO, ratio, "-", exact);
            recorded.push((
                number,
                found.within(0.03 * exact, "asked: 3 %; half a spacing of radius is 2 % of the mass"),
            ));
        }
    }
    Ok(recorded)
}

fn figures(runs: &Runs) -> Result<Vec<Figure>, JudgeError> {
    let mut series = Vec::new();
    for run in runs.iter().filter(|run| run.variant.grid.starts_with('2')) {
        let points = run.column("time")?.into_iter().zip(run.column(WAY)?).collect();
        let (colour, line) = match run.variant.grid.as_str() {
            grid if grid.ends_with("dry") => (BLACK, Line::Dashed),
            grid if grid.contains("1400") => (VERMILION, Line::Solid),
            grid if grid.contains("140 ") => (BLUE, Line::Solid),
            _ => (BLACK, Line::Solid),
        };
        series.push(Series::line(&run.variant.grid, points, colour, line));
    }
    Ok(vec![Figure::Chart(Chart {
        title: "The oval in time".into(),
        caption: "Half the difference of the ways outwards at 0° and at 90°.".into(),
        x: Axis::linear("time [s]"),
        y: Axis::linear("way [mm]"),
        series,
    })])
}
