//! accuracy-forecast: lattices that `coque check --accuracy` predicts from four coarse ones, run and held against finer ones.

use std::ops::ControlFlow;
use std::time::Duration;

use coque::Scene;
use coque::accuracy::{Asked, ClimbError, Rung};

use crate::judge::{Case, Effort, Outcome, Run, Runs, Solver, Variant};
use crate::support::scenes;
use crate::support::studies::figure;
use crate::{JudgeError, Metric};

const ERROR: &str = "error over what was asked";
const FORECAST: &str = "error that was forecast over the one found";
const PARTICLES: &str = "particles over those forecast";
const TIME: &str = "time over that forecast";

/// Lattices that the forecast rests on.
const LATTICES: usize = 4;
/// How much finer the lattice is that stands for the answer, and what its own error adds at the second order: 4/3.
const FINER: f64 = 2.0;
const TAIL: f64 = 4.0 / 3.0;

/// A scene, values that are replaced in it, and whether it is in the quick set.
struct Problem {
    name: &'static str,
    text: &'static str,
    set: &'static [(&'static str, &'static str)],
    quick: bool,
}

#[rustfmt::skip] // a line a problem
static PROBLEMS: [Problem; 8] = [
    Problem { name: "Scordelis–Lo roof", text: include_str!("../../../scenes/scordelis-lo.toml"), set: &[], quick: true },
    Problem { name: "pinched cylinder", text: include_str!("../../../scenes/pinched-cylinder.toml"), set: &[], quick: true },
    Problem { name: "twisted beam", text: include_str!("../../../scenes/twisted-beam.toml"), set: &[], quick: true },
    Problem { name: "clamped plate", text: include_str!("../../../scenes/plate-clamped.toml"), set: &[], quick: true },
    Problem { name: "six frequencies of a plate", text: scenes::PLATE, set: &[("analysis.modal.modes", "6")], quick: false },
    Problem { name: "column, buckling", text: include_str!("../../../scenes/column-buckling.toml"), set: &[], quick: false },
    Problem { name: "ring, static", text: scenes::RING, set: &[("analysis.static.levels", "4")], quick: true },
    Problem { name: "hemisphere to .8 R", text: scenes::HEMISPHERE, set: &[("analysis.static.levels", "8")], quick: false },
];

/// The problems at two accuracies.
pub fn case() -> Case {
    Case {
        name: "accuracy-forecast",
        title: "What an accuracy takes, forecast and run",
        about: "From runs on four coarse lattices the lattice is forecast on which a scene's answers are within 1 and .3 % of what they \
                approach; it is run, and held against one of half its spacing.",
        citation: "no reference: a method against itself on a finer lattice",
        variants: variants(),
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    let mut variants = Vec::new();
    for problem in &PROBLEMS {
        for (accuracy, words) in [(0.01, "1 %"), (0.003, ".3 %")] {
            let run = move || forecast(problem, accuracy).map_err(|error| error.to_string());
            let grid = format!("{}, {words}", problem.name);
            let quick = problem.quick && accuracy == 0.01;
            variants.push(Variant::study("forecast", &grid, run).quick_if(quick).judged(judged));
        }
    }
    variants
}

fn forecast(problem: &Problem, accuracy: f64) -> Result<Outcome, ClimbError> {
    let set: Vec<_> = problem.set.iter().map(|(key, value)| (key.to_string(), value.to_string())).collect();
    let scene = Scene::with_overrides(problem.text, problem.name, &set)?;
    // The number of lattices ends the runs, not the time: the same forecast on any machine.
    let asked = Asked { accuracy, within: Duration::from_secs(3600), lattices: LATTICES, threads: 1 };
    let forecasts = scene.forecast(&asked, &mut |_, _| ControlFlow::Continue(()))?;
    let needed = forecasts.first().and_then(|forecast| forecast.needed.clone());
    let needed = needed.ok_or_else(|| ClimbError::Silent("nothing was forecast".into()))?;
    let reached = Rung::at(&scene, 1.0 / needed.spacing, 1)?;
    let finer = Rung::at(&scene, FINER / needed.spacing, 1)?;
    let error = reached.distance_from(&finer).map_or(f64::NAN, |distance| TAIL * distance);
    let figures = [
        (ERROR, "-", error / accuracy),
        (FORECAST, "-", needed.error / error),
        (PARTICLES, "-", reached.particles as f64 / needed.particles),
        (TIME, "-", reached.seconds / needed.seconds),
    ];
    let (particles, wall_seconds) = (reached.particles, reached.seconds);
    let spacing = reached.spacing;
    Ok(Outcome { particles, spacing, wall_seconds, steps: 1, ..Outcome::row(Solver::Static, &figures) })
}

fn judged(run: &Run, _: &Runs) -> Result<Vec<Metric>, JudgeError> {
    let within =
        "what was asked, and no more: estimates carry a safety of 1.25 where an order was found, 3 where not";
    let mut metrics = vec![
        figure(run, ERROR, "-")?.within(1.0, within),
        figure(run, FORECAST, "-")?.shown("how careful it is: the least lattice would have one"),
        Metric::compared(PARTICLES, run.last(PARTICLES)?, "-", 1.0)
            .within(0.2, "whole numbers of cells, even for even, along short edges"),
    ];
    // Runs of the quick set are held against stored ones, which have no times.
    if run.variant.effort != Effort::Quick {
        metrics.push(figure(run, TIME, "-")?.shown("times follow the machine and what else it does"));
    }
    Ok(metrics)
}
