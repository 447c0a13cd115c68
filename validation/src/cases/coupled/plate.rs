//! dam-break-on-plate: a column of water breaks on an elastic plate that stands on the floor.

use benchmarks_ref::fluid_structure::{plate_envelope, plate_tips};

use super::measure::{SHELL, peak, value_at};
use crate::figures::{
    Axis, BLUE, Chart, Colour, Figure, GREEN, GREY, Line, ORANGE, PURPLE, SKY, Series, VERMILION,
};
use crate::judge::{Case, Headline, Run, Runs, Variant};
use crate::support::misses::Miss;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("dam-break-on-plate.toml");
/// Way of the upper end \[mm\].
const WAY: &str = "dx";
const PEAK: &str = "first peak";
const END: f64 = 0.5;

/// The plate, six published answers, and how far it may be from them.
pub fn case() -> Case {
    Case {
        name: "dam-break-on-plate",
        title: "A dam breaks on an elastic plate",
        about: "There is no experiment: six published codes give a first peak of 41 to 49 mm at .217 to \
                .260 s, and an envelope for later. The wave bends the plate over, leaves it as a jet, \
                and meets it again.",
        citation: "Idelsohn et al. 2008; Ryzhakov 2010, Liu 2013, Bogaers 2016, Meduri 2018, Sun 2019",
        variants: variants(),
        headline: Some(Headline::new(PEAK, 1.0)),
        figures,
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    [(2, 0.25, true), (2, END, false), (3, END, false), (4, END, false)]
        .into_iter()
        .map(|(layers, duration, quick)| {
            let to = if quick { ", to the peak" } else { "" };
            let dx = 0.012 / f64::from(layers);
            // In whole spacings, so that the particles of floor and sides are as far apart as those of the water.
            let [width, depth, long, tall] =
                [0.146, 0.292, 0.584, 0.7].map(|length: f64| (length / dx).round() * dx);
            let water = format!("{{ lengths = [{width}, {depth}], spacing = {dx} }}");
            Variant::scene(SHELL, SCENE, format!("{layers} across{to}"))
                .set("bodies.water.fluid.geometry.block", water)
                .set("bodies.tank.walls.geometry.basin.max", format!("[{long}, {tall}]"))
                .set("analysis.explicit.transient.duration", duration)
                .quick_if(quick)
                .full_if(layers > 2)
                .unsettled()
                .judged(|run, _| judged(run))
        })
        .collect()
}

/// The one time and run up to the first peak that miss what is asked \[s, %\].
const LATE: (f64, &str, Miss) = (
    0.2,
    "2 across",
    Miss {
        measured: 15.46,
        margin: 1.0,
        cause: "the front comes 5 ms later than with the narrower kernel of 1.3 spacings, which kept to the envelope; on two particles across the \
                plate the kernel is wider than the plate. Not isolated",
    },
);

/// How far a way is outside the envelope of the published ones, in parts of its edge \[%\]; none of a time
/// beyond the run.
fn outside(run: &Run, at: f64) -> Result<Option<f64>, JudgeError> {
    let Some(way) = value_at(&run.column("time")?, &run.column(WAY)?, at) else { return Ok(None) };
    let [least, most] = plate_envelope(at)?.map(|way| 1e3 * way);
    let off = if way > most {
        (way - most) / most.abs()
    } else if way < least {
        (least - way) / least.abs()
    } else {
        0.0
    };
    Ok(Some(100.0 * off))
}

fn judged(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let (times, ways) = (run.column("time")?, run.column(WAY)?);
    let last = times.last().copied().unwrap_or(0.0);
    let top = peak(&times, &ways, 0.3);
    let mut metrics = vec![
        Metric::compared(PEAK, top.map(|top| top.1), "mm", 45.0).within(7.0, "published codes: 41 to 49 mm"),
        Metric::compared("time of the first peak", top.map(|top| top.0), "s", 0.24)
            .within(0.04, "published codes: .217 to .260 s"),
    ];
    for at in [0.16, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.5].into_iter().filter(|at| *at < last + 1e-9) {
        let (name, off) = (format!("outside the envelope at {at} s"), outside(run, at)?);
        let found = Metric::error(name.as_str(), off, "%");
        if at == LATE.0 && run.variant.grid.starts_with(LATE.1) {
            metrics.push(found.shown(format!("asked 15 %; known to miss it: {}", LATE.2.cause)));
            metrics.push(LATE.2.judged(&name, off, "%"));
            continue;
        }
        let (bound, reason) = if at <= 0.25 {
            (15.0, "asked up to the first peak")
        } else {
            (25.0, "asked after it, where published codes part")
        };
        metrics.push(if at > 0.45 {
            found.shown("published codes are too far from each other")
        } else {
            found.within(bound, reason)
        });
    }
    Ok(metrics)
}

fn figures(runs: &Runs) -> Result<Vec<Figure>, JudgeError> {
    let colours: [Colour; 6] = [GREEN, ORANGE, SKY, GREY, PURPLE, VERMILION];
    let mut series = Vec::new();
    for ((who, curve), colour) in plate_tips()?.iter().zip(colours) {
        let points = curve.x().iter().zip(curve.y()).filter(|(t, _)| **t <= END);
        let points = points.map(|(&t, &way)| (t, 1e3 * way)).collect();
        series.push(Series::line(who, points, colour, Line::Dashed));
    }
    for run in runs.iter() {
        let points = run.column("time")?.into_iter().zip(run.column(WAY)?).collect();
        let line = if run.variant.grid.starts_with('2') { Line::Dashed } else { Line::Solid };
        series.push(Series::line(&format!("shell, {}", run.variant.grid), points, BLUE, line));
    }
    Ok(vec![Figure::Chart(Chart {
        title: "Upper end of the plate, downstream".into(),
        caption: "Published simulations dashed.".into(),
        x: Axis::linear("time [s]"),
        y: Axis::linear("displacement [mm]"),
        series,
    })])
}
