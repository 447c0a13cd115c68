//! elastic-wedge: two aluminium plates, joined at 10°, go into water at 30 m/s.

mod run;

use benchmarks_ref::fluid_structure::{WedgeQuantity, wedge};

use super::measure::{SHELL, Size, mean_and_deviation, outcome, peak, value_at};
use crate::figures::{Axis, BLUE, Chart, Colour, Figure, GREEN, Line, ORANGE, SKY, Series};
use crate::judge::{Case, Headline, Outcome, Run, Runs, Variant};
use crate::support::studies::{SHOWN, figure};
use crate::{JudgeError, Metric};
use run::{Wedge, entry};

const BENT: &str = "deflection at B";
const APEX: &str = "pressure at the apex";
const OUTSIDE: &str = "pressure at C";
const ALONE: &str = "pressure at C, one column";
const BALANCE: &str = "missing energy";
/// Sound speed of water \[m/s\].
const WATER: f64 = 1500.0;
/// Layers, sound speed \[m/s\] and deflection at 2 ms \[mm\] of runs that were measured.
const KNOWN: [(usize, f64, f64); 3] = [(2, WATER, 13.1), (4, WATER, 11.8), (4, 0.5 * WATER, 11.1)];
/// End \[s\].
const END: f64 = 2.2e-3;

/// The wedge, the published answers, and how far it may be from them.
pub fn case() -> Case {
    Case {
        name: "elastic-wedge",
        title: "An elastic wedge goes into water at 30 m/s",
        about: "Ends and apex of the plates go down at constant speed. Published answers do not agree on \
                how the plates are held: here they are joined at the apex, which symmetry then keeps \
                from turning, and hinged at their outer ends; hinges at the apex too are shown. Water is \
                compressed from two kernel radii on, before a face touches it, the more the faster its \
                sound: the wet part runs ahead, with rigid plates too.",
        citation: "Scolan 2004 (semi-analytical); Oger 2010, Fourey 2010, Li 2015, Khayyer 2018 (particles)",
        variants: variants(),
        headline: Some(Headline::new("deflection at 2 ms", 2.0)),
        figures,
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    [(2, true, WATER), (4, true, WATER), (4, true, 0.5 * WATER), (4, false, WATER)]
        .into_iter()
        .map(|(layers, joined, sound)| {
            let wedge = Wedge { layers, joined, sound };
            let held = if joined { "joined" } else { "hinged" };
            let grid = format!("{layers} across, {held}, sound at {sound} m/s");
            Variant::study(SHELL, &grid, move || study(&wedge))
                .full_if(layers > 2)
                .judged(move |run, _| judged(&wedge, run))
        })
        .collect()
}

fn study(wedge: &Wedge) -> Result<Outcome, String> {
    let found = entry(wedge, END).map_err(|error| error.to_string())?;
    let size = Size {
        particles: found.particles,
        spacing: run::THICKNESS / wedge.layers as f64,
        steps: found.steps,
        seconds: found.seconds,
    };
    let columns =
        [("time", "ms"), (BENT, "mm"), (APEX, "MPa"), (OUTSIDE, "MPa"), (ALONE, "MPa"), (BALANCE, "J/m")];
    Ok(outcome(size, columns, &found.rows))
}

fn judged(wedge: &Wedge, run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let times = run.column("time")?;
    let (bent, apex, outside) = (run.column(BENT)?, run.column(APEX)?, run.column(OUTSIDE)?);
    let arrival = times.iter().zip(run.column(ALONE)?).find(|(_, p)| *p > 1.0).map(|(t, _)| *t);
    let deflection = Metric::compared("deflection at 2 ms", value_at(&times, &bent, 2.0), "mm", 10.2);
    let mean = mean_and_deviation(&times, &apex, [0.4, 1.6]).map(|found| found.0);
    let mean = Metric::compared("mean pressure at the apex, .4 to 1.6 ms", mean, "MPa", 5.25);
    let top = peak(&times, &outside, 2.2).map(|top| top.1);
    let top = Metric::compared("greatest pressure at C", top, "MPa", 24.0);
    let arrival = Metric::compared("arrival at C", arrival, "ms", 1.90);
    if !wedge.joined {
        let reason = "how the plates are held at the apex: shown beside those that are joined";
        return Ok(vec![
            deflection.shown(reason),
            mean.shown(reason),
            top.shown(reason),
            arrival.shown(reason),
        ]);
    }
    let mut metrics = Vec::new();
    if let Some(&(.., known)) =
        KNOWN.iter().find(|(layers, sound, _)| (*layers, *sound) == (wedge.layers, wedge.sound))
    {
        let found = value_at(&times, &bent, 2.0);
        let found = Metric::compared("deflection at 2 ms against the one known", found, "mm", known);
        metrics
            .push(found.within(0.5, "a figure to notice a change by: half of what half the spacing changes"));
    }
    metrics.extend([
        deflection.shown(
            "asked 8.7 to 10.2; missed while the water is compressed before it is touched: less so with a slower sound",
        ),
        mean.shown("asked 4.0 to 6.5 MPa; measured 6.0 to 6.4"),
        top.shown("published: 18 to 30 MPa; a peak that passes in a few steps"),
        arrival.shown("asked within 5 %; missed by 7 to 13 %: a rigid wedge arrives as early, for the same reason"),
        figure(run, BALANCE, "J/m")?.shown(SHOWN),
    ]);
    Ok(metrics)
}

fn figures(runs: &Runs) -> Result<Vec<Figure>, JudgeError> {
    let colours: [Colour; 3] = [GREEN, ORANGE, SKY];
    let mut charts = Vec::new();
    for (title, name, quantity, scale) in [
        ("Deflection in the middle of a plate [mm]", BENT, WedgeQuantity::Deflection, 1e3),
        ("Pressure three quarters out [MPa]", OUTSIDE, WedgeQuantity::PressureOutside, 1e-6),
    ] {
        let mut series = Vec::new();
        for ((who, points), colour) in wedge(quantity)?.iter().zip(colours) {
            let points = points.iter().map(|[t, value]| (1e3 * t, scale * value)).collect();
            series.push(Series::line(who, points, colour, Line::Dashed));
        }
        for run in runs.iter() {
            let points = run.column("time")?.into_iter().zip(run.column(name)?).collect();
            let line = if run.variant.grid.contains("hinged") { Line::Dashed } else { Line::Solid };
            series.push(Series::line(&run.variant.grid, points, BLUE, line));
        }
        charts.push(Figure::Chart(Chart {
            title: title.into(),
            caption: "Published answers dashed.".into(),
            x: Axis::linear("time from contact [ms]"),
            y: Axis::linear(title),
            series,
        }));
    }
    Ok(charts)
}
