//! fluid-scenes: templates as a user runs them, against the figures that the same problems have as studies.

use coque::{Event, Rendering, Scene, Shape, Simulation, render};
use sph_core::Vec3;

use super::measure::{SHELL, SOLID, mean_and_deviation, peak, value_at};
use super::source_settings::GATE as GATE_OF_BONDS;
use crate::figures::{BLUE, Colour, Figure, GREY, Instant, Instants, VERMILION};
use crate::judge::{Case, Headline, Outcome, Run, Runs, Variant};
use crate::methods::PAIRWISE;
use crate::support::coupled::GRAVITY;
use crate::support::fluids::KICKS;
use crate::{JudgeError, Metric};

const DAM: &str = include_str!("../../../../scenes/dam-break.toml");
const PLATE: &str = include_str!("../../../../scenes/shell-in-water.toml");
const GATE: &str = include_str!("../../../../scenes/gate.toml");
const BAFFLE: &str = include_str!("../../../../scenes/baffle.toml");

const SPACING: &str = "bodies.water.fluid.geometry.block.spacing";
const TRANSIENT: &str = "analysis.explicit.transient";
/// The run that is drawn.
const OF_BONDS: &str = "gate of bonds, 4 across";
/// When it is drawn \[s\].
const INSTANTS: [f64; 6] = [0.04, 0.08, 0.12, 0.16, 0.20, 0.24];
/// The faces of the gate, and where the lintel begins over it \[m\].
const GATE_FACES: [f64; 2] = [0.1, 0.105];
const LINTEL: f64 = 0.08275;
/// Width of the column that breaks, and its height in particles \[m\].
const COLUMN: (f64, f64) = (0.146, 24.0);
/// Fronts of dam-break-front with as many particles: T = t √(2g/L) and Z = x/L.
const FRONTS: [(f64, f64); 5] = [(1.0, 1.424), (1.5, 1.894), (2.0, 2.459), (2.5, 3.090), (3.0, 3.756)];
const FRONT: &str = "Z at T = 2";

/// The scenes, and what they have to give.
pub fn case() -> Case {
    Case {
        name: "fluid-scenes",
        title: "Templates of fluids against studies of the same problems",
        about: "Dam break, plate under water, gate and baffle are studies of the bare models in their own cases. Here the templates that \
                `coque new` writes run with the spacings of those studies, through scene, build, curve and checks of the \
                application: figures have to be the same, but that the pool bends the baffle from the start. Walls are those of basins and blocks, steps a little shorter, \
                speeds of sound rounded.",
        citation: "the cases dam-break-front, hydrostatic-column, elastic-gate and baffle-breaks",
        variants: vec![dam(), plate(), gate(), gate_of_bonds(), baffle(), coarse_baffle()],
        headline: Some(Headline::new(FRONT, 0.01)),
        figures,
        ..Case::default()
    }
}

fn dam() -> Variant {
    let high = COLUMN.1;
    Variant::scene(KICKS, DAM, format!("dam-break, H/Δx {high}"))
        .set(SPACING, 2.0 * COLUMN.0 / high)
        .set("bodies.tank.walls.geometry.basin.max", "[0.876, 0.5]")
        .set(TRANSIENT, "{ duration = 0.28, record_every = 0.0025 }")
        .unsettled()
        .judged(|run, _| fronts(run))
}

fn fronts(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let (width, high) = COLUMN;
    let second = (width / (2.0 * GRAVITY)).sqrt();
    let (times, fronts) = (run.column("time")?, run.column("front")?);
    let metric = |(time, asked): (f64, f64)| {
        // A particle ends half a spacing before its place.
        let front = value_at(&times, &fronts, time * second).map(|x| x / width + 1.0 / high);
        let reason =
            "that of the study of the bare fluid; a third of a spacing for its smoother record and its sound";
        Metric::compared(format!("Z at T = {time}"), front, "-", asked).within(0.03, reason)
    };
    Ok(FRONTS.into_iter().map(metric).collect())
}

fn plate() -> Variant {
    Variant::scene(SHELL, PLATE, "shell-in-water, 2 across")
        .set(SPACING, 0.025)
        .set("bodies.plate.shell.geometry.plate.particles", "[41, 2]")
        .set(TRANSIENT, "{ duration = 0.4, record_every = 0.002 }")
        .unsettled()
        .judged(|run, _| {
            let exact = super::column::exact(2700.0);
            let late = mean_and_deviation(&run.column("time")?, &run.column("w")?, [0.2, 0.4]);
            let mean = Metric::compared("mean of the deflection", late.map(|found| found.0), "m", exact);
            let swing = late.map(|found| 100.0 * found.1 / found.0);
            Ok(vec![
                mean.within(0.05 * exact, "asked of the study: 1.031 of the closed form there"),
                Metric::error("standard deviation of the deflection", swing, "% of the mean")
                    .within(5.0, "asked of the study: a coupling that feeds the plate swings more and more"),
            ])
        })
}

fn gate() -> Variant {
    Variant::scene(SHELL, GATE, "gate, 2 mm, to the peak")
        .set(SPACING, 0.002)
        .set(TRANSIENT, "{ duration = 0.14, record_every = 0.002 }")
        .unsettled()
        .judged(|run, _| {
            let top = peak(&run.column("time")?, &run.column("dx")?, 0.14);
            let way = Metric::compared("peak of dx", top.map(|top| 1e3 * top.1), "mm", 36.2);
            let time = Metric::compared("time of the peak", top.map(|top| top.0), "s", 0.104);
            Ok(vec![
                way.within(1.5, "that of the study within 4 %; the scene has a tank that ends nearer"),
                time.within(0.008, "four records: the top is flat"),
            ])
        })
}

/// The gate in the source's own model, through its peak to the last of the instants that the source shows.
fn gate_of_bonds() -> Variant {
    Variant::study(SOLID, OF_BONDS, watched)
        .judged(|run, _| {
            let top = peak(&run.column("time")?, &run.column("dx")?, 0.114);
            let way = Metric::compared("peak of dx", top.map(|top| 1e3 * top.1), "mm", 36.2);
            let time = Metric::compared("time of the peak", top.map(|top| top.0), "s", 0.104);
            let level = Metric::compared("level beside the gate at the start", run.column("depth")?.first().copied(), "m", 0.14);
            Ok(vec![
                way.within(2.5, "that of the shell; four layers, whose modulus was raised by what they lack in an endless strip, are 1.3 mm stiffer"),
                time.within(0.012, "six records: the top is flat"),
                level.within(0.00125, "a spacing"),
            ])
        })
}

/// The scene, led from record to record so that its shapes are kept at rest and when it is drawn.
fn watched() -> Result<Outcome, String> {
    let set = [(TRANSIENT.to_owned(), "{ duration = 0.24, record_every = 0.002 }".to_owned())];
    let model = Scene::with_overrides(GATE_OF_BONDS, "gate-bonds.toml", &set)
        .and_then(|scene| scene.build(1))
        .map_err(|error| render(&error, Rendering { width: 110, colour: false }))?;
    let mut simulation = Simulation::new(model);
    let rest = simulation.body().configuration().rest.to_vec();
    let mut shapes = vec![Shape { time: 0.0, level: 0.0, positions: rest }];
    loop {
        match simulation.advance().map_err(|failure| failure.to_string())? {
            Event::Step => {}
            Event::End => break,
            Event::Record => {
                let time = simulation.stands_at().time;
                if INSTANTS.iter().any(|instant| (instant - time).abs() < 1e-6) {
                    let positions = simulation.body().configuration().present;
                    shapes.push(Shape { time, level: 1.0, positions });
                }
            }
        }
    }
    Ok(Outcome { shapes, ..Outcome::from(simulation.finish()) })
}

/// Which of the three that are drawn a particle is of, by its place at rest: water, gate, walls.
fn group(x: &Vec3) -> usize {
    let (in_water, in_gate) = (0.0..GATE_FACES[0], GATE_FACES[0]..GATE_FACES[1]);
    match x.y > 0.0 {
        true if in_water.contains(&x.x) => 0,
        true if in_gate.contains(&x.x) && x.y < LINTEL => 1,
        _ => 2,
    }
}

/// Water and gate at six instants, the first of them that of the source's figure 3.
fn figures(runs: &Runs) -> Result<Vec<Figure>, JudgeError> {
    let Some(run) = runs.get(SOLID, OF_BONDS)? else { return Ok(Vec::new()) };
    let Some((rest, shapes)) = run.outcome.shapes.split_first() else { return Ok(Vec::new()) };
    let groups: Vec<usize> = rest.positions.iter().map(group).collect();
    let frame = |shape: &Shape| {
        let mut points = vec![Vec::new(); 3];
        for (x, &group) in shape.positions.iter().zip(&groups) {
            points[group].push([x.x, x.y]);
        }
        Instant { label: format!("{:.2} s", shape.time), points }
    };
    let of = |name: &str, colour: Colour| (name.to_owned(), colour);
    Ok(vec![Figure::Instants(Instants {
        title: "Water and a gate of bonds at six instants (Shi et al. 2022, figure 3)".into(),
        caption: "Four layers of nodes. The gate opens to its peak at .11 s and swings back while the water leaves; the source and the \
                  experiment have the peak at .16 s: the case elastic-gate says which modulus does that."
            .into(),
        window: [[-0.005, -0.005], [0.3, 0.15]],
        spacing: 0.00125,
        groups: vec![of("water", BLUE), of("gate", VERMILION), of("walls", GREY)],
        frames: shapes.iter().map(frame).collect(),
    })])
}

/// The first time at which a column is more than a value \[s\].
fn when(run: &Run, column: &str, more: f64) -> Result<Option<f64>, JudgeError> {
    let pairs = run.column("time")?.into_iter().zip(run.column(column)?);
    Ok(pairs.into_iter().find(|(_, value)| *value > more).map(|(time, _)| time))
}

fn baffle() -> Variant {
    let baffle = Variant::scene(PAIRWISE, BAFFLE, "baffle, 4 across")
        .set(TRANSIENT, "{ duration = 0.8, record_every = 0.01 }")
        .full_if(true)
        .unsettled();
    baffle.judged(|run, _| {
        let arrival = Metric::compared("arrival at the baffle", when(run, "front", 1.975)?, "s", 0.335);
        let first = Metric::compared("first broken bond", when(run, "damage", 0.0)?, "s", 0.5);
        let foot = Metric::compared("mean damage of the lowest row", run.last("foot")?, "-", 0.475);
        Ok(vec![
            arrival.within(0.035, "asked of the study: .30 to .37 s"),
            first.within(0.1, "asked of the study: .40 to .60 s"),
            foot.within(0.125, "asked of the study: .35 to .60 when it cracks"),
            Metric::compared("energy of broken bonds", run.last("spent")?, "J/m", 258.0)
                .shown("that of the study, which lets the pool bend the baffle first, at .7 s"),
        ])
    })
}

/// The same on a lattice twice as coarse, two layers across and so without a claim on its bending: arrival and crack show that
/// water and bonds meet.
fn coarse_baffle() -> Variant {
    Variant::scene(PAIRWISE, BAFFLE, "baffle, 2 across")
        .set(TRANSIENT, "{ duration = 0.7, record_every = 0.01 }")
        .set("bodies.water.fluid.geometry.blocks.spacing", 0.05)
        .set("bodies.tank.walls.geometry.basin.min", "[0.0, -0.15]")
        .set("bodies.floor.walls.geometry.block", "{ lengths = [2.0, 0.15], origin = [0.0, -0.15] }")
        .set("bodies.bed.walls.geometry.block", "{ lengths = [1.9, 0.15], origin = [2.1, -0.15] }")
        .set(
            "bodies.baffle.solid.geometry.block",
            "{ lengths = [0.1, 1.15], origin = [2.0, -0.15], spacing = 0.05 }",
        )
        .set("sets.below.layer.depth", 0.15)
        .set("sets.foot.box.max", "[2.1, 0.05, 0.0]")
        .unsettled()
        .judged(|run, _| {
            let arrival = Metric::compared("arrival at the baffle", when(run, "front", 1.95)?, "s", 0.335);
            let first = Metric::compared("first broken bond", when(run, "damage", 0.0)?, "s", 0.5);
            Ok(vec![
                arrival.within(0.035, "asked of the study: .30 to .37 s"),
                first.within(0.1, "asked of the study: .40 to .60 s"),
                Metric::error("mean damage of the lowest row", run.last("foot")?, "-")
                    .shown("two layers: what the finer lattices are asked"),
            ])
        })
}
