//! fluid-scenes: the gate as a user runs it, by shell and by bonds, against the figures of its study.

use coque::{Event, Rendering, Scene, Shape, Simulation, render};
use sph_core::Vec3;

use super::measure::{SHELL, SOLID, peak};
use super::source_settings::GATE as GATE_OF_BONDS;
use crate::figures::{BLUE, Colour, Figure, GREY, Instant, Instants, VERMILION};
use crate::judge::{Case, Headline, Outcome, Runs, Variant};
use crate::{JudgeError, Metric};

const GATE: &str = include_str!("../../../../scenes/gate.toml");
const TRANSIENT: &str = "analysis.explicit.transient";
const PEAK: &str = "peak of dx";
/// The run that is drawn.
const OF_BONDS: &str = "gate of bonds, 4 across";
/// When it is drawn \[s\].
const INSTANTS: [f64; 6] = [0.04, 0.08, 0.12, 0.16, 0.20, 0.24];
/// The faces of the gate, and where the lintel begins over it \[m\].
const GATE_FACES: [f64; 2] = [0.1, 0.105];
const LINTEL: f64 = 0.08275;

/// The scenes, and what they have to give.
pub fn case() -> Case {
    Case {
        name: "fluid-scenes",
        title: "The templates of the gate against its study",
        about: "The gate is a study of bare models in its own case. Here the templates that `coque new` writes run with its \
                spacings, through scene, build, curve and checks of the application: figures have to be the same. Walls are \
                those of basins and blocks, steps a little shorter, speeds of sound rounded.",
        citation: "the case elastic-gate",
        variants: vec![gate(), gate_of_bonds()],
        headline: Some(Headline::new(PEAK, 0.01)),
        figures,
        ..Case::default()
    }
}

fn gate() -> Variant {
    Variant::scene(SHELL, GATE, "gate, 2 mm, to the peak")
        .set("bodies.water.fluid.geometry.block.spacing", 0.002)
        .set(TRANSIENT, "{ duration = 0.14, record_every = 0.002 }")
        .unsettled()
        .judged(|run, _| {
            let top = peak(&run.column("time")?, &run.column("dx")?, 0.14);
            let way = Metric::compared(PEAK, top.map(|top| 1e3 * top.1), "mm", 36.2);
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
            let way = Metric::compared(PEAK, top.map(|top| 1e3 * top.1), "mm", 36.2);
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
