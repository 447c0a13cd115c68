//! growth: what a particle costs in every model, from 10³ particles to 10⁶: set-up, step or answer, memory.

use coque::{Rendering, RunOptions, Scene, SceneError, render};

use crate::figures::{
    Axis, BLUE, Chart, Colour, Figure, GREEN, Line, ORANGE, PURPLE, SKY, Series, VERMILION,
};
use crate::judge::{Case, Outcome, Recorded, Run, Runs, Solver, Variant};
use crate::support::stopwatch::{Look, Stopwatch};
use crate::support::studies::figure;
use crate::{JudgeError, Metric};

const SET_UP: &str = "set-up of a particle";
const COST: &str = "a particle-step or a particle's share of the answer";
const BYTES: &str = "memory of a particle";
const MORE: &str = "memory over that at 10⁴";
/// Steps before the clock runs.
const WARM: u64 = 3;
/// Particle-steps of a measurement, at least; and the least steps.
const WORK: f64 = 1e6;
const LEAST: u64 = 5;

/// A scene that grows.
struct Growing {
    model: &'static str,
    scene: &'static str,
    /// Key that says how fine it is.
    key: &'static str,
    /// Its value for `n` particles along an edge.
    value: fn(usize) -> String,
    /// Particles along an edge.
    edges: &'static [usize],
    colour: Colour,
}

const SQUARES: [usize; 4] = [32, 100, 316, 1000];

#[rustfmt::skip] // a table
static MODELS: [Growing; 6] = [
    Growing { model: "shell, step", scene: SHELL, key: PARTICLES, value: particles, edges: &SQUARES, colour: BLUE },
    Growing { model: "shell, linear answer", scene: SHELL_LINEAR, key: PARTICLES, value: particles, edges: &[32, 100, 200], colour: SKY },
    Growing { model: "bonds, step", scene: BONDS, key: OF_PLATE, value: spacing, edges: &SQUARES, colour: VERMILION },
    Growing { model: "state-based, step", scene: STATES, key: OF_PLATE, value: spacing, edges: &SQUARES, colour: ORANGE },
    Growing { model: "fluid, step", scene: FLUID, key: OF_WATER, value: spacing, edges: &SQUARES, colour: GREEN },
    Growing { model: "Galerkin, linear answer", scene: GALERKIN, key: OF_BAR, value: spacing, edges: &[6, 9, 13], colour: PURPLE },
];

const PARTICLES: &str = "geometry.plate.particles";
const OF_PLATE: &str = "bodies.plate.solid.geometry.block.spacing";
const OF_WATER: &str = "bodies.water.fluid.geometry.block.spacing";
const OF_BAR: &str = "bodies.bar.solid.geometry.block.spacing";

const SHELL: &str = r#"
title = "A free plate"
units = { length = "m", force = "N", time = "s" }
geometry.plate = { lengths = [1.0, 1.0], particles = [32, 32] }
material.elastic = { young = 1e6, poisson = 0.3, density = 1.0 }
section.homogeneous = { thickness = 0.01 }
loads = [{ on = "all", gravity = { acceleration = [0.0, 0.0, -1.0] } }]
analysis.explicit.transient = { duration = 1e3, record_every = 1e3 }
"#;

const SHELL_LINEAR: &str = r#"
title = "A clamped plate"
units = { length = "m", force = "N", time = "s" }
geometry.plate = { lengths = [1.0, 1.0], particles = [32, 32] }
material.elastic = { young = 1e6, poisson = 0.3, density = 1.0 }
section.homogeneous = { thickness = 0.01 }
supports = [{ on = "u0", clamped = {} }, { on = "u1", clamped = {} }]
loads = [{ on = "all", gravity = { acceleration = [0.0, 0.0, -1.0] } }]
analysis.linear = {}
"#;

const BONDS: &str = r#"
title = "A plate of bonds"
units = { length = "m", force = "N", time = "s" }
loads = [{ on = "all", gravity = { acceleration = [0.0, -1.0, 0.0] } }]
analysis.explicit.transient = { duration = 1e3, record_every = 1e3 }
[bodies.plate.solid]
geometry.block = { lengths = [1.0, 1.0], spacing = 0.03125 }
material.elastic = { young = 1e6, poisson = 0.3333, density = 1.0 }
formulation.bond-based = { horizon = 3.015, plane = "stress" }
"#;

const STATES: &str = r#"
title = "A plate of states"
units = { length = "m", force = "N", time = "s" }
loads = [{ on = "all", gravity = { acceleration = [0.0, -1.0, 0.0] } }]
analysis.explicit.transient = { duration = 1e3, record_every = 1e3 }
[bodies.plate.solid]
geometry.block = { lengths = [1.0, 1.0], spacing = 0.03125 }
material.elastic = { young = 1e6, poisson = 0.3333, density = 1.0 }
formulation.state-based = { horizon = 3.015, plane = "stress" }
"#;

const FLUID: &str = r#"
title = "A column of water"
units = { length = "m", force = "N", time = "s" }
loads = [{ on = "all", gravity = { acceleration = [0.0, -9.81, 0.0] } }]
analysis.explicit.transient = { duration = 1e3, record_every = 1e3 }
[bodies.water.fluid]
geometry.block = { lengths = [1.0, 1.0], spacing = 0.03125 }
material.liquid = { density = 1000.0, sound_speed = 62.6 }
[bodies.tank.walls]
geometry.basin = { min = [0.0, 0.0], max = [2.0, 1.5], open = ["y1"] }
"#;

const GALERKIN: &str = r#"
title = "A bar without elements"
units = { length = "m", force = "N", time = "s" }
supports = [{ on = "x0", clamped = {} }]
loads = [{ on = "all", gravity = { acceleration = [0.0, 0.0, -1.0] } }]
analysis.linear = {}
[bodies.bar.solid]
geometry.block = { lengths = [4.0, 1.0, 1.0], spacing = 0.2 }
material.elastic = { young = 1e6, poisson = 0.3, density = 1.0 }
formulation.galerkin = { basis = "linear", support.sphere = 1.8 }
"#;

fn particles(edge: usize) -> String {
    format!("[{edge}, {edge}]")
}

fn spacing(edge: usize) -> String {
    format!("{:e}", 1.0 / edge as f64)
}

/// Every model at every size.
pub fn case() -> Case {
    let variants = MODELS.iter().flat_map(|growing| {
        growing.edges.iter().map(move |&edge| {
            let grid = format!("edge {edge}");
            Variant::study(growing.model, &grid, move || measured(growing, edge))
                .alone()
                .full_if(growing.edges.last() == Some(&edge))
                .judged(judged)
        })
    });
    Case {
        name: "growth",
        title: "Cost of a particle from 10³ to 10⁶ particles",
        about: "Each model from its plainest scene: set-up from the text of the scene to a model, processor time of a particle and \
                a step after the first three, memory that is then held. Answers without time are whole: ordering, assembly, factor. A \
                line that rises has left a cache (steps) or multiplies more in its factor (answers: n^1.5 in a plate, n² in a \
                body). One thread; times follow the machine.",
        citation: "no reference: what a particle holds may not grow with their number",
        variants: variants.collect(),
        together,
        figures,
        ..Case::default()
    }
}

fn measured(growing: &Growing, edge: usize) -> Result<Outcome, String> {
    let set = [(growing.key.to_owned(), (growing.value)(edge))];
    let start = Look::now();
    let model = Scene::with_overrides(growing.scene, growing.model, &set).and_then(|scene| scene.build(1));
    let model = model.map_err(|error| shown(&error))?;
    let built = Look::now();
    let expected = model.body.body().configuration().rest.len();
    let steps = ((WORK / expected as f64) as u64).max(LEAST);
    let mut watch = Stopwatch::new(WARM, steps);
    let options = RunOptions { progress: &mut watch, checkpoints: None, fields: None, from: None };
    let run = model.run_with(options).map_err(|error| error.to_string())?;
    let end = Look::now();
    let outcome = Outcome::from(run);
    let count = outcome.particles;
    let set_up = 1e6 * (built.processor - start.processor).as_secs_f64() / count as f64;
    let mut figures = vec![(SET_UP, "µs", set_up)];
    match watch.looks().filter(|_| outcome.solver == Solver::Explicit) {
        Some([from, to]) => {
            let work = steps as f64 * count as f64;
            figures.push((COST, "µs", 1e6 * (to.processor - from.processor).as_secs_f64() / work));
            let held = start.heap.zip(to.heap).map(|(start, to)| (to.held - start.held) / count as f64);
            figures.extend(held.map(|held| (BYTES, "B", held)));
        }
        None => {
            figures.push((COST, "µs", 1e6 * (end.processor - built.processor).as_secs_f64() / count as f64))
        }
    }
    Ok(Outcome { failure: None, ..outcome }.showing(&figures))
}

fn shown(error: &SceneError) -> String {
    render(error, Rendering { width: 110, colour: false })
}

fn judged(run: &Run, _: &Runs) -> Result<Vec<Metric>, JudgeError> {
    let times = "a cost: times follow the machine and its neighbours";
    let mut metrics = vec![figure(run, SET_UP, "µs")?.shown(times), figure(run, COST, "µs")?.shown(times)];
    if has_bytes(run) {
        metrics.push(figure(run, BYTES, "B")?.shown("an account; that it does not grow is judged beside it"));
    }
    Ok(metrics)
}

fn has_bytes(run: &Run) -> bool {
    run.outcome.curve.columns.iter().any(|column| column.name == BYTES)
}

/// Memory of a particle over that at 10⁴, which may not grow.
fn together(runs: &Runs) -> Result<Vec<Recorded>, JudgeError> {
    let mut recorded = Vec::new();
    for growing in MODELS.iter().filter(|growing| growing.edges.contains(&100)) {
        let Some(usual) = runs.get(growing.model, "edge 100")?.filter(|run| has_bytes(run)) else { continue };
        let Some(usual) = usual.last(BYTES)? else { continue };
        for edge in growing.edges.iter().filter(|&&edge| edge > 100) {
            let Some(number) = runs.number(growing.model, &format!("edge {edge}"))? else { continue };
            let more = runs.chosen[number].last(BYTES)?.map(|bytes| bytes / usual);
            let reason =
                "rows of walls and rings of slots weigh less, not more, among more particles; vectors double";
            recorded.push((number, Metric::error(MORE, more, "-").within(1.2, reason)));
        }
    }
    Ok(recorded)
}

fn figures(runs: &Runs) -> Result<Vec<Figure>, JudgeError> {
    let chart = |title: &str, caption: &str, column: &str, unit: &str| -> Result<Figure, JudgeError> {
        let mut series = Vec::new();
        for growing in &MODELS {
            let mut points = Vec::new();
            for run in runs.iter().filter(|run| run.is(growing.model)) {
                if let Some(value) =
                    run.outcome.curve.columns.iter().any(|c| c.name == column).then(|| run.last(column))
                {
                    points.extend(value?.map(|value| (run.outcome.particles as f64, value)));
                }
            }
            if !points.is_empty() {
                series.push(Series::line(growing.model, points, growing.colour, Line::Solid));
            }
        }
        Ok(Figure::Chart(Chart {
            title: title.into(),
            caption: caption.into(),
            x: Axis::log("particles"),
            y: Axis::log(unit),
            series,
        }))
    };
    let (time, memory) = ("processor time [µs]", "memory [bytes]");
    Ok(vec![
        chart("Time of a particle", "Of a step, or of the whole answer without time.", COST, time)?,
        chart(
            "Set-up of a particle",
            "From the text of the scene to a model that can be run.",
            SET_UP,
            time,
        )?,
        chart("Memory of a particle", "Held between two steps, as the allocator counts it.", BYTES, memory)?,
    ])
}
