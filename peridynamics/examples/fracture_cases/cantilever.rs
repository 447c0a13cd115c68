//! A double cantilever opened slowly: the energy release by its compliance, against G₀.

use std::ops::ControlFlow;
use std::time::Instant;

use explicit_dynamics::Amplitude;
use peridynamics::{
    Correction, Crack, Criterion, Elastic, Fracture, Law, Parts, Solid, Space, Support, Supported,
};
use sph_core::Vec3;

use crate::support::{formulation, fracture_energy, lattice, march, nodes, parts, with_damage};

const ENERGY: f64 = 1000.0;
const LENGTH: f64 = 0.08;
const ARM: f64 = 0.01;
const NOTCH: f64 = 0.025;
const THICKNESS: f64 = 1e-3;

/// Of a law with so many nodes across an arm.
pub fn run(law: Law, across: usize, by_work: bool) -> Result<(), Box<dyn std::error::Error>> {
    let started = Instant::now();
    let (space, horizon, dx) = (Space::PlaneStress, 3.015, ARM / across as f64);
    let poisson = if law == Law::BondBased { 1.0 / 3.0 } else { 0.25 };
    let material = Elastic { young: 70e9, poisson, density: 2700.0 };
    let counts = [(LENGTH / dx).round() as usize, 2 * across, 1];
    let block = lattice(2, counts, [dx, dx, THICKNESS], Vec3::zeros());
    let upper = nodes(&block, |x| x.x < 2.0 * dx && x.y > ARM);
    let lower = nodes(&block, |x| x.x < 2.0 * dx && x.y < ARM);
    // Beam theory: G = 9 E h³ Δ²/(64 a⁴) = G₀ at the start; the crack is to grow to one and a half times a.
    let start = (64.0 * ENERGY * NOTCH.powi(4) / (9.0 * material.young * ARM.powi(3))).sqrt();
    let opening = 3.5 * start;
    let duration = 0.012;
    let moved = |sign: f64| Support::Moved {
        direction: Vec3::y() * sign,
        by: 0.5 * opening,
        amplitude: Amplitude::Ramp(duration),
    };
    let fixed = Support::Held { displacement: vec![Vec3::x()], director: Vec::new() };
    let criterion =
        if by_work { Criterion::EnergyByWork(ENERGY) } else { Criterion::EnergyByStretch(ENERGY) };
    let tail = nodes(&block, |x| x.x > LENGTH - dx);
    let mut body = Solid::new(Parts {
        fracture: Some(Fracture {
            criterion,
            // A straight crack is wanted; only bonds near the middle may break.
            unbreakable: nodes(&block, |x| (x.y - ARM).abs() > 4.0 * dx || x.x < 0.6 * NOTCH),
        }),
        cracks: vec![Crack::Segment([Vec3::new(-dx, ARM, 0.0), Vec3::new(NOTCH, ARM, 0.0)])],
        supports: vec![
            Supported { nodes: upper.clone(), support: moved(1.0) },
            Supported { nodes: lower, support: moved(-1.0) },
            Supported { nodes: tail, support: fixed },
        ],
        ..parts(block, material, formulation(space, law, horizon, Correction::Even))
    })?;
    // Half of critical damping of the arms' first mode keeps ringing away.
    let arm = 3.516 / (1.4 * NOTCH).powi(2) * (material.young / material.density / 12.0).sqrt() * ARM;
    let mut rows = Vec::new();
    let mut kinetic = 0.0_f64;
    march(&mut body, duration, duration / 120.0, arm, |body, record| {
        let tip = with_damage(body, |damaged| damaged.tip(|x| x.x < LENGTH - 4.0 * dx)).unwrap_or(NOTCH);
        let force: f64 = upper.iter().map(|&node| body.reaction(node as usize).y).sum();
        let wide = opening * record.at.time / duration;
        rows.push([wide, force, tip.max(NOTCH), fracture_energy(body)]);
        if tip > NOTCH + 2.0 * dx {
            kinetic = kinetic.max(record.energy.kinetic / record.energy.internal);
        }
        if tip > LENGTH - 2.0 * ARM { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    })?;
    // C^⅓ is a straight line over a (beams on an elastic foundation); G = P²/(2h) dC/da.
    let grown: Vec<_> = rows.iter().filter(|r| r[2] > NOTCH + 2.0 * dx && r[1] > 0.0).collect();
    let (mut n, mut sa, mut sc, mut saa, mut sac) = (0.0, 0.0, 0.0, 0.0, 0.0);
    for [wide, force, a, _] in grown.iter().map(|row| **row) {
        let c = libm::cbrt(wide / force);
        (n, sa, sc, saa, sac) = (n + 1.0, sa + a, sc + c, saa + a * a, sac + a * c);
    }
    let slope = (n * sac - sa * sc) / (n * saa - sa * sa);
    let constant = (sc - slope * sa) / n;
    // By the opening, which does not ring: G = Δ²/(2h) (dC/da)/C².
    let released = |row: &[f64; 4]| {
        let c = slope * row[2] + constant;
        row[0] * row[0] / (2.0 * THICKNESS) * 3.0 * slope / c.powi(4) / ENERGY
    };
    let values: Vec<f64> = grown.iter().map(|row| released(row)).collect();
    let mean = values.iter().sum::<f64>() / n;
    let spread = values.iter().fold(0.0_f64, |most, value| most.max((value - mean).abs()));
    let beam: f64 = grown
        .iter()
        .map(|row| 9.0 * material.young * ARM.powi(3) * row[0] * row[0] / (64.0 * row[2].powi(4)) / ENERGY)
        .sum::<f64>()
        / n;
    let (first, last) = (grown[0], grown[grown.len() - 1]);
    let of_bonds = (last[3] - first[3]) / (ENERGY * THICKNESS * (last[2] - first[2]));
    println!(
        "cantilever {law:?} {across} across an arm, work {by_work}: crack {:.1} to {:.1} mm, G by compliance / G0 {mean:.3} (+- \
         {spread:.3}), by beam {beam:.2}, of broken bonds {of_bonds:.3}, shift {:.2} arms, kinetic/stored {kinetic:.1e}, {:.1} s",
        first[2] * 1e3,
        last[2] * 1e3,
        constant / slope / ARM,
        started.elapsed().as_secs_f64()
    );
    Ok(())
}
