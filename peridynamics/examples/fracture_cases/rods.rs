//! Rods without fracture: a wave along a slender bar, and torsional vibration of a clamped one.

use std::f64::consts::PI;
use std::ops::ControlFlow;
use std::time::Instant;

use explicit_dynamics::Amplitude;
use peridynamics::{Correction, Elastic, Law, Parts, Solid, Space, Support, Supported};
use sph_core::Vec3;

use crate::support::{formulation, lattice, march, nodes, parts};

/// A wave of one sine of velocity in a bar 2 mm square, with so many nodes across.
pub fn wave(law: Law, across: usize, correction: Correction) -> Result<(), Box<dyn std::error::Error>> {
    let started = Instant::now();
    let (length, width, period, speed) = (0.2, 0.002, 1e-5, 2.0);
    let material = Elastic { young: 210e9, poisson: 0.25, density: 7850.0 };
    let dx = width / across as f64;
    let block = lattice(3, [(length / dx).round() as usize, across, across], [dx; 3], Vec3::zeros());
    let end = nodes(&block, |x| x.x < dx);
    // The way of one sine of velocity: 1 − cos, there and back.
    let way = |i: usize| [period * i as f64 / 200.0, 0.5 * (1.0 - libm::cos(2.0 * PI * i as f64 / 200.0))];
    let driven = Support::Moved {
        direction: Vec3::x(),
        by: speed * period / PI,
        amplitude: Amplitude::Table((0..=200).map(way).collect()),
    };
    let mut body = Solid::new(Parts {
        supports: vec![Supported { nodes: end, support: driven }],
        ..parts(block, material, formulation(Space::Solid, law, 3.015, correction))
    })?;
    let columns = (length / dx).round() as usize;
    let mut places = Vec::new();
    march(&mut body, 3e-5, 1.5e-5, 0.0, |body, record| {
        if record.at.time < 1e-5 {
            return ControlFlow::Continue(());
        }
        let size = across * across;
        let mean = |column: usize| {
            (column * size..(column + 1) * size).map(|node| body.velocity(node).x).sum::<f64>() / size as f64
        };
        let profile: Vec<f64> = (0..columns).map(mean).collect();
        let peak = (0..columns).fold(0, |best, i| if profile[i] > profile[best] { i } else { best });
        let crosses = |from: usize, step: isize, level: f64| {
            let mut i = from as isize;
            while profile[(i + step) as usize] > level {
                i += step;
            }
            let (a, b) = (profile[i as usize], profile[(i + step) as usize]);
            (i as f64 + 0.5 + step as f64 * (a - level) / (a - b)) * dx
        };
        places.push([crosses(peak, 1, 0.5 * profile[peak]), crosses(peak, -1, 0.0)]);
        ControlFlow::Continue(())
    })?;
    let c0 = (material.young / material.density).sqrt();
    let [front, crossing] = [0, 1].map(|k| (places[1][k] - places[0][k]) / 1.5e-5 / c0 - 1.0);
    println!(
        "wave {law:?} {correction:?} {across} across: front {:+.2} %, zero crossing {:+.2} % of c0, {:.1} s",
        100.0 * front,
        100.0 * crossing,
        started.elapsed().as_secs_f64()
    );
    Ok(())
}

/// Torsion of a clamped square rod six widths long, to an angle in degrees at its end.
pub fn torsion(law: Law, across: usize, degrees: f64) -> Result<(), Box<dyn std::error::Error>> {
    let started = Instant::now();
    let (width, length, ghosts) = (0.02, 0.12, 4);
    let material =
        Elastic { young: 210e9, poisson: if law == Law::BondBased { 0.25 } else { 0.3 }, density: 7850.0 };
    let dx = width / across as f64;
    let origin = Vec3::new(-(ghosts as f64) * dx, -0.5 * width, -0.5 * width);
    let block = lattice(3, [6 * across + ghosts, across, across], [dx; 3], origin);
    let clamped = nodes(&block, |x| x.x < 0.0);
    let end = nodes(&block, |x| x.x > length - dx);
    let held = Support::Held { displacement: vec![Vec3::x(), Vec3::y(), Vec3::z()], director: Vec::new() };
    let mut body = Solid::new(Parts {
        supports: vec![Supported { nodes: clamped, support: held }],
        ..parts(block, material, formulation(Space::Solid, law, 3.015, Correction::Even))
    })?;
    let shear = material.moduli(Space::Solid)?.mu;
    // Torsion constant over polar moment of a square: 0.1406 · 6.
    let omega = 0.5 * PI / length * (0.8436 * shear / material.density).sqrt();
    let first = omega * degrees.to_radians();
    for node in 0..body.len() {
        let x = body.block().positions[node];
        if x.x > 0.0 {
            let rate = first * libm::sin(0.5 * PI * x.x / length);
            body.set_velocity(node, Vec3::new(0.0, -x.z, x.y) * rate);
        }
    }
    let period = 2.0 * PI / omega;
    let mut angles = Vec::new();
    let mut balance = 0.0_f64;
    let mut total = 0.0;
    march(&mut body, 0.7 * period, 0.01 * period, 0.0, |body, record| {
        let (mut sine, mut cosine) = (0.0, 0.0);
        for &node in &end {
            let (from, to) = (body.block().positions[node as usize], body.position(node as usize));
            sine += from.y * to.z - from.z * to.y;
            cosine += from.y * to.y + from.z * to.z;
        }
        angles.push((record.at.time, libm::atan2(sine, cosine).to_degrees()));
        if total == 0.0 {
            total = record.energy.kinetic;
        }
        balance = balance.max(record.balance_error.abs());
        ControlFlow::Continue(())
    })?;
    let most = angles.iter().map(|at| at.1).fold(0.0, f64::max);
    let back = angles.windows(2).find(|w| w[0].1 > 0.0 && w[1].1 <= 0.0).ok_or("no zero crossing")?;
    let half = back[0].0 + (back[1].0 - back[0].0) * back[0].1 / (back[0].1 - back[1].1);
    println!(
        "torsion {law:?} Even {across} across, {degrees} deg: f/f0 {:.3}, amplitude {:+.1} %, balance {:.1e}, {:.1} s",
        0.5 * period / half,
        100.0 * (most / degrees - 1.0),
        balance / total,
        started.elapsed().as_secs_f64()
    );
    Ok(())
}
