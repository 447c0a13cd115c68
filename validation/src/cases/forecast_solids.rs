//! accuracy-forecast-solids: what `coque check --accuracy` forecasts for solids, held against closed forms.

use std::ops::ControlFlow;
use std::time::Duration;

use coque::Scene;
use coque::accuracy::{Asked, ClimbError, Rung};

use crate::judge::{Case, Outcome, Run, Solver, Variant};
use crate::support::studies::figure;
use crate::{JudgeError, Metric};

const ERROR: &str = "error over what was asked";
const PARTICLES: &str = "nodes over those forecast";
const FINEST: &str = "error over the one forecast, finest of four lattices";

/// Lattices that the forecast rests on.
const LATTICES: usize = 4;
/// Nodes beyond which a lattice that is forecast is not run.
const MOST: f64 = 10_000.0;

/// A solid whose answer has a closed form.
struct Problem {
    name: &'static str,
    text: &'static str,
    set: &'static [(&'static str, &'static str)],
    /// The column, and the last number that it should have.
    known: (&'static str, f64),
    /// Accuracies that are asked, each in words.
    asked: &'static [(f64, &'static str)],
    /// Whether its runs take more than seconds.
    long: bool,
}

const BEAM: &str = r#"
title = "Cantilever of a square section under a shear at its end"
units = { length = "m", force = "N", time = "s" }
bodies.beam.solid.geometry.block = { lengths = [10.0, 1.0, 1.0], spacing = [1.0, 0.5, 0.5] }
bodies.beam.solid.material.elastic = { young = 1200.0, poisson = 0.0, density = 1.0 }
bodies.beam.solid.formulation.galerkin = { basis = "quadratic", support.ellipsoid = 2.5 }
sets.tip.nearest = [10.0, 0.5, 0.5]
supports = [{ on = "x0", clamped = {} }]
loads = [{ on = "x1", traction = { value = [0.0, 0.0, 0.01] } }]
analysis.linear = {}
curve = [{ name = "w", of = "displacement", on = "tip", direction = [0.0, 0.0, 1.0] }]
"#;
/// P L³/3EI + 6/5 P L/GA for a force of .01: ν = 0 leaves nothing of the clamp but the warp of its section.
const BEAM_TIP: f64 = 0.01 * (1000.0 / 300.0 + 1.2 * 10.0 / 600.0);

const BAR: &str = r#"
title = "Bar in plane stress, drawn out by a layer at its end"
units = { length = "m", force = "N", time = "s" }
bodies.bar.solid.geometry.block = { lengths = [5.0, 1.0], thickness = 1.0, spacing = 0.25 }
bodies.bar.solid.material.elastic = { young = 1000.0, poisson = 0.0, density = 1.0 }
bodies.bar.solid.formulation.state-based.plane = "stress"
sets.root.layer = { face = "x0", depth = 0.5 }
sets.end.layer = { face = "x1", depth = 0.5 }
supports = [
    { on = "root", clamped = {} },
    { on = "end", moved = { direction = [1.0, 0.0, 0.0], by = 0.01 } },
]
analysis.linear = {}
curve = [{ name = "P", of = "reaction", on = "root", direction = [-1.0, 0.0, 0.0] }]
"#;
/// E A u/L between the layers.
const BAR_FORCE: f64 = 1000.0 * 0.01 / 4.0;

const PLATE: &str = include_str!("../../../scenes/plate-pd.toml");
const RING: &str = include_str!("../../../scenes/thick-ring-solid.toml");
const FLAT: (&str, &str) = ("bodies.plate.solid.imperfection.amplitude", "0.0");
/// E t b u/((1 − ν²) a) of the plate with its sides held \[N\].
const PLATE_FORCE: f64 = 69_000.0 * 2.0 * 200.0 * 1.2 / ((1.0 - 0.33 * 0.33) * 300.0);
/// Its first critical force \[N\], as in plate-stability.
const CRITICAL: f64 = 6863.0;

const CAREFUL: &str = "a forecast may not be smaller than the error; the safety of 1.25 covers an order that is not yet constant";
#[rustfmt::skip] // a line a problem
static PROBLEMS: [Problem; 5] = [
    Problem { name: "two sheets, buckling", text: PLATE, set: &[FLAT, ("analysis", "{ buckling.modes = 1 }")], known: ("level", CRITICAL / PLATE_FORCE),
        asked: &[(0.02, "2 %"), (0.01, "1 %")], long: false },
    Problem { name: "two sheets, shortened", text: PLATE, set: &[FLAT, ("analysis", "{ linear = {} }")], known: ("P", PLATE_FORCE),
        asked: &[(0.01, "1 %"), (0.003, ".3 %")], long: false },
    Problem { name: "bonds, bar", text: BAR, set: &[], known: ("P", BAR_FORCE),
        asked: &[(0.04, "4 %"), (0.02, "2 %")], long: false },
    Problem { name: "galerkin, beam", text: BEAM, set: &[], known: ("w", BEAM_TIP),
        asked: &[(0.01, "1 %"), (0.003, ".3 %")], long: true },
    // Winkler's beam, of which the finest meshes of the scene are .11 % short.
    Problem { name: "galerkin, thick ring", text: RING, set: &[("bodies.ring.solid.geometry.arc.cells", "[6, 2, 2]")], known: ("w_crown", 0.17909),
        asked: &[(0.01, "1 %")], long: true },
];

/// The problems, each at its accuracies.
pub fn case() -> Case {
    Case {
        name: "accuracy-forecast-solids",
        title: "What an accuracy takes of solids, forecast and held against closed forms",
        about: "From runs on four coarse lattices the lattice is forecast on which bonds, sheets of bonds and Galerkin solids are \
                within an accuracy; it is run where it has ten thousand nodes at most, and held against a closed form, as \
                the finest of the four is. What is forecast beyond is not run, and says how careful a forecast is: lattices of two layers tell no order.",
        citation: "beams of Timoshenko and Winkler, the classical plate: closed forms",
        variants: variants(),
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    let mut variants = Vec::new();
    for problem in &PROBLEMS {
        for &(accuracy, words) in problem.asked {
            let run = move || forecast(problem, accuracy).map_err(|error| error.to_string());
            let variant = Variant::study("forecast", &format!("{}, {words}", problem.name), run);
            variants.push(variant.full_if(problem.long).judged(|run, _| judged(run)));
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
    let silent = || ClimbError::Silent("nothing was forecast".into());
    let forecast = forecasts.first().ok_or_else(silent)?;
    let finest = forecast.ladder.rungs.last().ok_or_else(silent)?;
    let (column, known) = problem.known;
    let off = |rung: &Rung| rung.off(column, known).ok_or_else(silent);
    let mut figures = vec![(FINEST, "-", off(finest)? / finest.error.ok_or_else(silent)?)];
    let (mut particles, mut spacing, mut wall_seconds) = (finest.particles, finest.spacing, finest.seconds);
    if let Some(needed) = forecast.needed.as_ref().filter(|needed| needed.particles <= MOST) {
        let reached = Rung::at(&scene, 1.0 / needed.spacing, 1)?;
        figures.push((ERROR, "-", off(&reached)? / accuracy));
        figures.push((PARTICLES, "-", reached.particles as f64 / needed.particles));
        (particles, spacing, wall_seconds) = (reached.particles, reached.spacing, reached.seconds);
    }
    Ok(Outcome { particles, spacing, wall_seconds, steps: 1, ..Outcome::row(Solver::Static, &figures) })
}

fn judged(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let mut metrics = vec![figure(run, FINEST, "-")?.within(1.0, CAREFUL)];
    if run.outcome.curve.columns.iter().any(|column| column.name == ERROR) {
        metrics.push(figure(run, ERROR, "-")?.within(1.0, "what was asked, and no more"));
        let cells = "whole numbers of cells, even for even, along short edges";
        metrics.push(Metric::compared(PARTICLES, run.last(PARTICLES)?, "-", 1.0).within(0.25, cells));
    }
    Ok(metrics)
}
