//! solid-same-damage: a notched square plate torn on 1, 2 and 4 threads, and turned by 90°.

use std::error::Error;
use std::ops::ControlFlow;
use std::time::Instant;

use explicit_dynamics::Amplitude;
use peridynamics::{AppliedLoad, Correction, Crack, Criterion, Elastic, Fracture, Law, Parts, Solid, Space};
use sph_core::Vec3;

use crate::Metric;
use crate::judge::{Case, Headline, Outcome, Variant};
use crate::support::marched::{LAWS, march, marched};
use crate::support::solids::{formulation, lattice, nodes, parts};
use crate::support::studies::figure;

/// Nodes along an edge.
const COUNT: usize = 48;
const DX: f64 = 5e-4;
const ENERGY: f64 = 135.0;
const TENSION: f64 = 20e6;
const DURATION: f64 = 1.4e-5;

const OTHER: &str = "numbers with other bits";
const TURNED: &str = "damage of the turned plate";
const BROKEN: &str = "mean damage";

/// The plate, held against itself.
pub fn case() -> Case {
    Case {
        name: "solid-same-damage",
        title: "A notched square plate torn on 1, 2, 4 threads and turned by 90°: the same damage",
        about: "Sudden tension tears a square of 48² nodes. Positions, velocities and broken bonds are compared bit for bit \
                with those of one thread. Of the plate turned with its notch and its loads the damage is compared node by \
                node: sums run in another order there, so that its motion differs by rounding.",
        citation: "reference: the run on one thread",
        variants: LAWS
            .into_iter()
            .map(|(method, law)| {
                Variant::study(method, "48 × 48", move || run(law).map_err(|e| e.to_string()))
            })
            .collect(),
        each: |run| {
            Ok(vec![
                figure(run, OTHER, "-")?.within(0.0, "equal bit for bit across 1, 2 and 4 threads"),
                figure(run, TURNED, "-")?
                    .within(0.0, "no bond breaks that does not break in the plate turned"),
                Metric::at_least(BROKEN, run.last(BROKEN)?, "%", 1.0)
                    .within(0.0, "it tears: else nothing is compared"),
            ])
        },
        headline: Some(Headline::new(OTHER, 0.0)),
        ..Case::default()
    }
}

/// The plate with its notch along `along`, after it was torn.
fn torn(law: Law, along: Vec3, threads: usize) -> Result<(Solid, u64), Box<dyn Error>> {
    let side = COUNT as f64 * DX;
    let corner = Vec3::new(-0.5 * side, -0.5 * side, 0.0);
    let block = lattice(2, corner, [side, side, 1e-3], DX).block()?;
    let across = Vec3::new(-along.y, along.x, 0.0);
    let height = |x: &Vec3| x.dot(&across);
    let (edge, reach) = (0.5 * side, 3.015 * DX);
    let forces = nodes(&block, |x| height(x).abs() > edge - DX)
        .into_iter()
        .map(|node| {
            let sign = height(&block.positions[node as usize]).signum();
            (node, across * (sign * TENSION * DX * 1e-3))
        })
        .collect();
    let poisson = if law == Law::BondBased { 1.0 / 3.0 } else { 0.22 };
    let unbreakable = nodes(&block, |x| height(x).abs() > edge - reach);
    let mut body = Solid::new(Parts {
        fracture: Some(Fracture { criterion: Criterion::EnergyByStretch(ENERGY), unbreakable }),
        cracks: vec![Crack::Segment([along * (-edge - DX), Vec3::zeros()])],
        loads: vec![AppliedLoad { forces, amplitude: Amplitude::Constant }],
        threads,
        ..parts(
            block,
            Elastic { young: 72e9, poisson, density: 2440.0 },
            formulation(Space::PlaneStress, law, Correction::Even),
        )
    })?;
    let steps = march(&mut body, DURATION, DURATION, |_, _| ControlFlow::Continue(()))?;
    Ok((body, steps))
}

fn run(law: Law) -> Result<Outcome, Box<dyn Error>> {
    let started = Instant::now();
    let (one, steps) = torn(law, Vec3::x(), 1)?;
    let mut other = 0;
    for threads in [2, 4] {
        other += different(&one, &torn(law, Vec3::x(), threads)?.0);
    }
    let (turned, _) = torn(law, Vec3::y(), 1)?;
    // The node at (x, y) stands at (−y, x) in the turned plate.
    let place = |node: usize| (COUNT - 1 - node % COUNT) * COUNT + node / COUNT;
    let apart = |node: usize| (one.damage(node) - turned.damage(place(node))).abs();
    let worst = (0..one.len()).map(apart).fold(0.0, f64::max);
    let broken = (0..one.len()).map(|node| one.damage(node)).sum::<f64>() / one.len() as f64;
    // Sums of volumes in another order differ by rounding.
    let worst = if worst < 1e-12 { 0.0 } else { worst };
    let figures = [(OTHER, "-", other as f64), (TURNED, "-", worst), (BROKEN, "%", 100.0 * broken)];
    Ok(marched(&one, steps, started, &figures))
}

/// How many numbers of the motion and of the broken bonds have other bits.
fn different(one: &Solid, other: &Solid) -> usize {
    let numbers = |body: &Solid| -> Vec<u64> {
        let moving = body.motion().into_iter().flatten().flatten().map(|x| x.to_bits());
        moving.chain(body.broken().iter().flatten().map(|x| x.to_bits())).collect()
    };
    let (one, other) = (numbers(one), numbers(other));
    one.iter().zip(&other).filter(|(a, b)| a != b).count() + one.len().abs_diff(other.len())
}
