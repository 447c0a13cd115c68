//! Kalthoff and Winkler's plate: struck between two notches it cracks at about 68° to them.

use std::ops::ControlFlow;
use std::time::Instant;

use explicit_dynamics::Amplitude;
use peridynamics::{
    Correction, Crack, Criterion, Elastic, Fracture, Law, Parts, Solid, Space, Support, Supported,
};
use sph_core::Vec3;

use crate::support::{formulation, fracture_energy, lattice, march, nodes, parts, with_damage};

const ENERGY: f64 = 22.2e3;
const DURATION: f64 = 9e-5;
/// Depth behind the struck edge, height, thickness.
const SIZE: [f64; 3] = [0.1, 0.2, 0.009];
const NOTCH: f64 = 0.05;
const HEIGHTS: [f64; 2] = [0.075, 0.125];

pub struct Case {
    pub space: Space,
    pub law: Law,
    pub horizon: f64,
    pub spacing: f64,
    pub correction: Correction,
    pub by_work: bool,
    pub speed: f64,
}

pub fn run(case: &Case) -> Result<(), Box<dyn std::error::Error>> {
    let started = Instant::now();
    let Case { space, law, horizon, spacing: dx, correction, by_work, speed } = *case;
    let poisson = if law == Law::BondBased { space.pairwise_poisson() } else { 0.3 };
    let material = Elastic { young: 190e9, poisson, density: 8000.0 };
    // An odd number of cells puts rows on the notches, an even one between.
    let counts = [SIZE[0], SIZE[1], SIZE[2]].map(|length| (length / dx).round() as usize);
    let steps = [SIZE[0] / counts[0] as f64, SIZE[1] / counts[1] as f64];
    let block = match space {
        Space::Solid => lattice(3, counts, [steps[0], steps[1], SIZE[2] / counts[2] as f64], Vec3::zeros()),
        _ => lattice(2, [counts[0], counts[1], 1], [steps[0], steps[1], SIZE[2]], Vec3::zeros()),
    };
    let struck = nodes(&block, |x| x.x < steps[0] && x.y > HEIGHTS[0] && x.y < HEIGHTS[1]);
    let cracks = HEIGHTS.map(|y| {
        let at = |x: f64, z: f64| Vec3::new(x, y, z);
        match space {
            Space::Solid => {
                Crack::Polygon(vec![at(-dx, -1.0), at(NOTCH, -1.0), at(NOTCH, 1.0), at(-dx, 1.0)])
            }
            _ => Crack::Segment([at(-dx, 0.0), at(NOTCH, 0.0)]),
        }
    });
    let criterion =
        if by_work { Criterion::EnergyByWork(ENERGY) } else { Criterion::EnergyByStretch(ENERGY) };
    let driven = Support::Moved {
        direction: Vec3::x(),
        by: speed * DURATION,
        amplitude: Amplitude::Table(vec![[0.0, 0.0], [DURATION, 1.0]]),
    };
    let mut body = Solid::new(Parts {
        fracture: Some(Fracture { criterion, unbreakable: Vec::new() }),
        cracks: cracks.to_vec(),
        supports: vec![Supported { nodes: struck, support: driven }],
        ..parts(block, material, formulation(space, law, horizon, correction))
    })?;
    let mut balance = (0.0_f64, 0.0_f64);
    march(&mut body, DURATION, 5e-6, 0.0, |_, record| {
        balance = (balance.0.max(record.balance_error.abs()), record.energy.external);
        ControlFlow::Continue(())
    })?;
    let margin = horizon * dx;
    let angles = [0, 1].map(|side| {
        let y = HEIGHTS[side];
        let tip = Vec3::new(NOTCH, y, 0.0);
        let outward = |x: &Vec3| if side == 0 { y - x.y } else { x.y - y };
        with_damage(&body, |damaged| {
            let zone = |x: &Vec3| {
                outward(x) > 0.0 && x.x > NOTCH - margin && x.x < SIZE[0] - margin && x.z < SIZE[2]
            };
            let mut found = damaged.direction(tip, 0.04, zone);
            found[0] *= 1e3;
            found
        })
    });
    let broken: f64 = (0..body.len()).map(|node| body.damage(node)).sum::<f64>() / body.len() as f64;
    println!(
        "{space:?} {law:?} m {horizon} dx {:.2} mm {correction:?} work {by_work}, {speed} m/s: length, chord, fit: {:.1} mm \
         {:.1} ({:.1}) / {:.1} mm {:.1} ({:.1}) deg, damage {broken:.3}, energy {:.1} J, {} fragments, balance {:.1e}, {} \
         bonds, {:.1} s",
        dx * 1e3,
        angles[0][0],
        angles[0][1],
        angles[0][2],
        angles[1][0],
        angles[1][1],
        angles[1][2],
        fracture_energy(&body),
        body.fragments().len(),
        balance.0 / balance.1,
        body.bonds(),
        started.elapsed().as_secs_f64(),
    );
    Ok(())
}
