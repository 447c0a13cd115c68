//! A strip between clamped edges, stretched before it is notched: mode I at a known energy release.

use std::ops::ControlFlow;
use std::time::Instant;

use peridynamics::{
    Correction, Crack, Criterion, Elastic, Fracture, Law, Parts, Solid, Space, Support, Supported,
};
use sph_core::Vec3;

use crate::measure::{rayleigh_speed, speeds};
use crate::support::{formulation, fracture_energy, lattice, march, nodes, parts, with_damage};

const ENERGY: f64 = 30.0;
const HEIGHT: f64 = 0.04;
const LENGTH: f64 = 0.12;
const NOTCH: f64 = 0.03;

/// Of a law and an energy release over G₀.
pub fn run(law: Law, release: f64, correction: Correction) -> Result<(), Box<dyn std::error::Error>> {
    let started = Instant::now();
    let (space, dx, horizon) = (Space::PlaneStress, 5e-4, 3.015);
    let poisson = if law == Law::BondBased { 1.0 / 3.0 } else { 0.25 };
    let material = Elastic { young: 32e9, poisson, density: 2500.0 };
    let edge = 4;
    let counts = [(LENGTH / dx) as usize, (HEIGHT / dx) as usize + 2 * edge, 1];
    let middle = 0.5 * HEIGHT;
    let block = lattice(2, counts, [dx, dx, 1e-3], Vec3::new(0.0, -(edge as f64) * dx, 0.0));
    let ends = nodes(&block, |x| x.y < 0.0 || x.y > HEIGHT);
    let held = Support::Held { displacement: vec![Vec3::x(), Vec3::y()], director: Vec::new() };
    let mut body = Solid::new(Parts {
        fracture: Some(Fracture {
            criterion: Criterion::EnergyByStretch(ENERGY),
            unbreakable: nodes(&block, |x| x.y < horizon * dx || x.y > HEIGHT - horizon * dx),
        }),
        cracks: vec![Crack::Segment([Vec3::new(-dx, middle, 0.0), Vec3::new(NOTCH, middle, 0.0)])],
        supports: vec![Supported { nodes: ends, support: held }],
        ..parts(block, material, formulation(space, law, horizon, correction))
    })?;
    let strain = (2.0 * release * ENERGY * (1.0 - poisson * poisson) / (material.young * HEIGHT)).sqrt();
    for node in 0..body.len() {
        let x = body.block().positions[node];
        // The held rows move as one with the edges, which lie between rows.
        let y = x.y.clamp(0.0, HEIGHT) - middle;
        body.put(node, x + Vec3::y() * (strain * y));
    }
    let inside = |x: &Vec3| x.x < LENGTH - horizon * dx;
    let mut path = Vec::new();
    let mut balance = (0.0_f64, 0.0_f64);
    march(&mut body, 1e-4, 1e-6, 0.0, |body, record| {
        let tip = with_damage(body, |damaged| damaged.tip(inside)).unwrap_or(NOTCH);
        path.push((record.at.time, tip.max(NOTCH)));
        balance = (balance.0.max(record.balance_error.abs()), balance.1.max(record.energy.internal));
        if tip > LENGTH - (horizon + 2.0) * dx { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    })?;
    let moduli = material.moduli(space)?;
    let speed = |modulus: f64| (modulus / material.density).sqrt();
    let rayleigh = rayleigh_speed(speed(moduli.lambda + 2.0 * moduli.mu), speed(moduli.mu));
    let [mean, most] = speeds(&path, 3e-6);
    let bands = with_damage(&body, |damaged| damaged.bands(dx, |x| inside(x) && x.x > NOTCH));
    let off = bands.iter().flat_map(|(_, b)| b).map(|y| (y - middle).abs()).fold(0.0, f64::max);
    let grown = path.last().map_or(0.0, |at| at.1 - NOTCH);
    println!(
        "{law:?} {correction:?} G/G0 {release}: grew {:.1} mm, mean {:.3}, max {:.2} c_R, off axis {:.1} dx, most bands {}, G of \
         bonds / G0 {:.2}, balance {:.1e}, {:.1} s",
        grown * 1e3,
        mean / rayleigh,
        most / rayleigh,
        off / dx,
        bands.iter().map(|(_, b)| b.len()).max().unwrap_or(0),
        fracture_energy(&body) / (ENERGY * 1e-3 * grown),
        balance.0 / balance.1,
        started.elapsed().as_secs_f64(),
    );
    Ok(())
}
