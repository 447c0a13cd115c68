//! PySPH: a column of water that falls, in the plane.

use std::process::Command;

use super::place::{Place, python};
use super::program;
use super::reading::{Found, Reading};
use super::row::{Comparison, Peer, Side};

const PYSPH: Peer = Peer {
    name: "PySPH",
    install: "python3 -m venv target/peers/pysph && target/peers/pysph/bin/pip install 'numpy<2' 'cython<3.1' setuptools pysph",
    threaded: true,
    find: |place| python(place, "pysph", "import pysph; print(pysph.__version__)"),
};

/// Spacing of particles \[m\]: a column of 100 × 200.
const SPACING: f64 = 0.01;
/// How long it falls \[s\].
const DURATION: f64 = 0.06;
/// Particles of the water.
const PARTICLES: f64 = 20_000.0;

/// All comparisons with PySPH.
pub fn comparisons() -> Vec<Comparison> {
    vec![Comparison {
        problem: "falling column of water in the plane, 20 000 particles",
        peer: PYSPH,
        unit: "ns a step and fluid particle",
        answers: "front [m], kinetic energy [J/m] after .06 s",
        // Walls differ: ours extrapolate pressures, theirs are particles that repel.
        share: 3.5,
        ours: Side { by: "one sweep a step".to_owned(), run: Box::new(|place, _| ours(place)) },
        theirs: Side { by: "wcsph, predicts and corrects".to_owned(), run: Box::new(theirs) },
    }]
}

/// The column of scenes/dam-break.toml in metres, with the sound and the viscosity of the other one.
fn ours(place: &Place) -> Result<Reading, String> {
    let scene = place.root.join("scenes/dam-break.toml");
    let water = "bodies.water.fluid";
    let sets = [
        format!("{water}.geometry.block={{ lengths = [1.0, 2.0], spacing = {SPACING} }}"),
        format!("{water}.material.liquid.sound_speed={}", 10.0 * (2.0_f64 * 9.81 * 2.0).sqrt()),
        format!("{water}.formulation.weakly-compressible={{ viscosity = 0.1 }}"),
        "bodies.tank.walls.geometry.basin.max=[6.0, 3.0]".to_owned(),
        format!("analysis.explicit.transient={{ duration = {DURATION}, record_every = {DURATION} }}"),
    ];
    let run = place.scene(&scene, "ours-dam", &sets.each_ref().map(String::as_str))?;
    let last = |name: &str| run.column(name)?.last().copied().ok_or(format!("no row of {name}"));
    let number =
        |key: &str| run.summary[key].as_f64().ok_or_else(|| format!("summary.json has no number {key}"));
    let each = 1e9 / (number("steps")? * PARTICLES);
    Ok(Reading {
        answers: vec![last("front")? + 0.5 * SPACING, last("kinetic")?],
        cost: number("wall_seconds")? * each,
        // Of the whole program, set-up included.
        processor: run.reading.processor.map(|seconds| seconds * each),
        ..run.reading
    })
}

fn theirs(place: &Place, found: &Found) -> Result<Reading, String> {
    let folder = place.at("pysph-dam")?;
    let mut command = Command::new(&found.program);
    command.arg(place.deck("pysph_dam.py"));
    command.args([SPACING.to_string(), DURATION.to_string(), place.threads.to_string()]).arg(&folder);
    Reading::of_line(&program::run(&mut command, &folder, place.threads)?)
}
