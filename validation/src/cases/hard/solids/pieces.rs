//! solid-pieces: a node without bonds flies on; two blocks hit each other, and one of them a wall.

use std::error::Error;
use std::ops::ControlFlow;
use std::time::Instant;

use peridynamics::{Contact, Correction, Crack, Elastic, Law, Parts, Solid, Space};
use sph_core::{Block, Vec3};

use crate::judge::{Case, Headline, Outcome, Run, Variant};
use crate::support::marched::{Balanced, LAWS, march, marched};
use crate::support::solids::{formulation, lattice, parts};
use crate::support::studies::figure;
use crate::{JudgeError, Metric};

const DX: f64 = 1e-3;
/// Nodes of a block along its edges.
const CELLS: [usize; 2] = [12, 10];
const SPEED: f64 = 20.0;

const FLIGHT: &str = "distance from free flight";
const LEFT: &str = "speed of the block it left";
const MOMENTUM: &str = "momentum lost";
const BALANCE: &str = "balance";
const REBOUND: &str = "momentum after over before";
const LEAST: &str = "least height over the wall";

/// The pieces, and what they have to keep.
pub fn case() -> Case {
    Case {
        name: "solid-pieces",
        title: "A loose node, two blocks that collide, a wall",
        about: "All bonds of a corner node are cut: thrown away it has to fly on for ever, and the block it left to stay at rest. \
                A block runs into another at rest: momentum stays, and energy. With a wall behind the second both are thrown \
                back; no node passes the wall.",
        citation: "reference: free flight, momentum and energy at the start",
        variants: variants(),
        headline: Some(Headline::new(BALANCE, 1e-3)),
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    let mut variants = Vec::new();
    for (method, law) in LAWS {
        variants.extend([
            Variant::study(method, "loose node", move || loose(law).map_err(|e| e.to_string())).judged(flies),
            Variant::study(method, "two blocks", move || collide(law, None).map_err(|e| e.to_string()))
                .judged(|run, _| hit(run, None)),
            Variant::study(method, "two blocks and a wall", move || {
                collide(law, Some([Vec3::zeros(), Vec3::x()])).map_err(|e| e.to_string())
            })
            .judged(|run, _| hit(run, Some(LEAST))),
        ]);
    }
    variants.into_iter().map(Variant::quick).collect()
}

fn material(law: Law) -> Elastic {
    Elastic { young: 70e9, poisson: if law == Law::BondBased { 1.0 / 3.0 } else { 0.3 }, density: 2700.0 }
}

/// A block of nodes with its first corner at a height over the wall.
fn block(height: f64) -> Result<Block, Box<dyn Error>> {
    let [length, width] = CELLS.map(|count| count as f64 * DX);
    Ok(lattice(2, Vec3::x() * height, [length, width, DX], DX).block()?)
}

fn loose(law: Law) -> Result<Outcome, Box<dyn Error>> {
    let started = Instant::now();
    // The first node stands at half a spacing from both edges, its neighbours beyond this line.
    let cut = Crack::Segment([Vec3::new(-10.0 * DX, 11.5 * DX, 0.0), Vec3::new(11.5 * DX, -10.0 * DX, 0.0)]);
    let mut body = Solid::new(Parts {
        cracks: vec![cut],
        ..parts(block(0.0)?, material(law), formulation(Space::PlaneStress, law, Correction::Even))
    })?;
    let (from, thrown) = (body.position(0), Vec3::new(-SPEED, -0.5 * SPEED, 0.0));
    body.set_velocity(0, thrown);
    let duration = 1e-3;
    let mut off = 0.0_f64;
    let steps = march(&mut body, duration, 0.1 * duration, |body, record| {
        off = off.max((body.position(0) - from - thrown * record.at.time).norm());
        ControlFlow::Continue(())
    })?;
    let left = (1..body.len()).map(|node| body.velocity(node).norm()).fold(0.0, f64::max);
    let figures = [(FLIGHT, "-", off / (SPEED * duration)), (LEFT, "-", left / SPEED)];
    Ok(marched(&body, steps, started, &figures))
}

fn flies(run: &Run, _: &crate::judge::Runs) -> Result<Vec<Metric>, JudgeError> {
    Ok(vec![
        figure(run, FLIGHT, "-")?
            .within(1e-10, "nothing acts on it: rounding of some thousand steps is left"),
        figure(run, LEFT, "-")?.within(1e-10, "nothing acts on the block: rounding is left"),
    ])
}

/// A block runs into one at rest, which a wall may stand behind.
fn collide(law: Law, wall: Option<[Vec3; 2]>) -> Result<Outcome, Box<dyn Error>> {
    let started = Instant::now();
    let gap = 3.0 * DX;
    let mut both = block(gap)?;
    let half = both.len();
    let second = block(2.0 * gap + CELLS[0] as f64 * DX)?;
    both.positions.extend(second.positions);
    both.volumes.extend(second.volumes);
    both.cells.clear();
    both.faces = Default::default();
    let mut body = Solid::new(Parts {
        contact: Some(Contact { distance: 1.0, walls: wall.into_iter().collect() }),
        ..parts(both, material(law), formulation(Space::PlaneStress, law, Correction::Even))
    })?;
    (half..body.len()).for_each(|node| body.set_velocity(node, Vec3::x() * -SPEED));
    let momentum =
        |body: &Solid| -> f64 { (0..body.len()).map(|node| body.mass(node) * body.velocity(node).x).sum() };
    let before = momentum(&body);
    let (mut balanced, mut least) = (Balanced::default(), f64::INFINITY);
    let steps = march(&mut body, 6e-4, 1e-6, |body, record| {
        balanced.see(record);
        least = (0..body.len()).map(|node| body.position(node).x).fold(least, f64::min);
        ControlFlow::Continue(())
    })?;
    let after = momentum(&body) / before;
    let figures = [
        (MOMENTUM, "-", 1.0 - after),
        (REBOUND, "-", after),
        (LEAST, "Δx", least / DX),
        (BALANCE, "%", balanced.percent()),
    ];
    Ok(marched(&body, steps, started, &figures))
}

fn hit(run: &Run, wall: Option<&str>) -> Result<Vec<Metric>, JudgeError> {
    let balance = figure(run, BALANCE, "%")?
        .near(0.4, "a stiff touch of some steps: central differences swing within it");
    let Some(least) = wall else {
        let lost =
            figure(run, MOMENTUM, "-")?.within(1e-10, "forces of contact come in pairs: rounding is left");
        return Ok(vec![lost, balance]);
    };
    Ok(vec![
        Metric::at_least(least, run.last(least)?, "Δx", 0.0).within(0.0, "a wall lets no node pass"),
        Metric::compared(REBOUND, run.last(REBOUND)?, "-", -1.0)
            .shown("all of it comes back but what the blocks keep as vibration"),
        balance,
    ])
}
