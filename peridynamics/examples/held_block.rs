//! A block of pairwise bonds, held on one face and pulled by a body force from rest: how far its end comes, and what a step costs.
//!
//! ```text
//! cargo run --release -p peridynamics --example held_block -- SIDE THREADS
//! ```
//!
//! Horizon of 3.015 spacings, whole volumes, no bond breaks: what xtask/peers/lammps-block.in models, so that `cargo xtask peers`
//! can hold the two side by side. Prints one line of JSON: the mean way of the end \[m\], ns a directed bond and step by the clock and,
//! on one thread of Linux, by the processor, bytes a node, bonds.

use std::error::Error;
use std::fs;
use std::time::Instant;

use explicit_dynamics::{Amplitude, Clock};
use peridynamics::{
    AppliedLoad, Correction, Elastic, Formulation, Idealisation, Influence, Law, Parts, Solid, Space,
    Support, Supported, Volumes,
};
use sph_core::{Block, Vec3};

/// Spacing of nodes \[m\].
const SPACING: f64 = 0.01;
/// What pulls \[m/s²\].
const PULL: f64 = 1e5;
/// How long for each node of a side \[s\]: a wave of √(E/ρ) goes there and back.
const DURATION: f64 = 2e-5;

/// Nodes of a cube, x counting fastest, and a force on each.
fn block(side: usize, threads: usize) -> Result<Solid, Box<dyn Error>> {
    let mut block = Block { dimensions: 3, spacing: [SPACING; 3], ..Block::default() };
    for node in 0..side.pow(3) {
        let [i, j, k] = [node % side, node / side % side, node / side.pow(2)];
        block.positions.push(Vec3::new(i as f64, j as f64, k as f64) * SPACING);
        block.volumes.push(SPACING.powi(3));
    }
    let nodes = 0..u32::try_from(side.pow(3))?;
    let force = Vec3::x() * (PULL * SPACING.powi(3));
    let displacement = vec![Vec3::x(), Vec3::y(), Vec3::z()];
    Ok(Solid::new(Parts {
        block,
        material: Elastic { young: 1e6, poisson: 0.25, density: 1.0 },
        formulation: Idealisation::Bonds(Formulation {
            space: Space::Solid,
            law: Law::BondBased,
            horizon: 3.015,
            volumes: Volumes::Whole,
            // The force of a bond is as its stretch: by extension that is 1/r.
            influence: Influence::Inverse,
            correction: Correction::None,
        }),
        plastic: None,
        fracture: None,
        cracks: Vec::new(),
        contact: None,
        supports: vec![Supported {
            nodes: nodes.clone().step_by(side).collect(),
            support: Support::Held { displacement, director: Vec::new() },
        }],
        loads: vec![AppliedLoad {
            forces: nodes.map(|node| (node, force)).collect(),
            amplitude: Amplitude::Constant,
        }],
        threads,
    })?)
}

/// Time of the processor on this thread \[s\], where the system tells it.
fn processor() -> Option<f64> {
    let text = fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    Some(1e-9 * text.split(' ').next()?.parse::<f64>().ok()?)
}

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<usize> = std::env::args().skip(1).map(|word| word.parse()).collect::<Result<_, _>>()?;
    let [side, threads] = words[..] else { return Err("two numbers are wanted: SIDE THREADS".into()) };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build()?;
    let mut solid = block(side, threads)?;
    let mut clock = Clock::start(&mut solid, 1.0, 0.9, 0.0)?;
    let duration = DURATION * side as f64;
    let mut march = || -> Result<(), Box<dyn Error + Send + Sync>> {
        while clock.now.time < duration * (1.0 - 1e-9) {
            clock.step(&mut solid, duration - clock.now.time, |_| 1.0)?;
        }
        Ok(())
    };
    let (before, start) = (processor(), Instant::now());
    if threads == 1 { march() } else { pool.install(&mut march) }.map_err(|error| error.to_string())?;
    let seconds = start.elapsed().as_secs_f64();
    let processor = before.zip(processor()).filter(|_| threads == 1).map(|(before, now)| now - before);
    let end = (0..solid.len()).skip(side - 1).step_by(side);
    let way: f64 = end.map(|node| solid.position(node).x - (side - 1) as f64 * SPACING).sum();
    let nanoseconds = |seconds: f64| 1e9 * seconds / (clock.steps as f64 * solid.bonds() as f64);
    println!(
        r#"{{ "answers": [{:e}], "cost": {:e}, "processor": {}, "bytes": {}, "bonds": {} }}"#,
        way / side.pow(2) as f64,
        nanoseconds(seconds),
        processor.map_or("null".to_owned(), |seconds| format!("{:e}", nanoseconds(seconds))),
        solid.bytes_per_particle(),
        solid.bonds(),
    );
    Ok(())
}
