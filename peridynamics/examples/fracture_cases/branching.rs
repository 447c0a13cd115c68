//! A notched glass plate 100 × 40 mm under sudden tension: its crack branches.

use std::ops::ControlFlow;
use std::time::Instant;

use explicit_dynamics::Amplitude;
use peridynamics::{AppliedLoad, Correction, Crack, Criterion, Elastic, Fracture, Law, Parts, Solid, Space};
use sph_core::Vec3;

use crate::measure::{length, rayleigh_speed, speeds};
use crate::support::{formulation, fracture_energy, lattice, march, nodes, parts, with_damage};

const ENERGY: f64 = 135.0;
const TENSION: f64 = 12e6;
const NOTCH: f64 = 0.05;
const SIZE: [f64; 2] = [0.1, 0.04];

pub struct Case {
    pub law: Law,
    pub horizon: f64,
    pub spacing: f64,
    pub correction: Correction,
    pub by_work: bool,
}

pub fn run(case: &Case) -> Result<(), Box<dyn std::error::Error>> {
    let started = Instant::now();
    let Case { law, horizon, spacing: dx, correction, by_work } = *case;
    let space = Space::PlaneStress;
    let poisson = if law == Law::BondBased { 1.0 / 3.0 } else { 0.22 };
    let material = Elastic { young: 72e9, poisson, density: 2440.0 };
    let counts = [SIZE[0], SIZE[1]].map(|length| (length / dx).round() as usize);
    let block = lattice(2, [counts[0], counts[1], 1], [dx, dx, 1e-3], Vec3::zeros());
    let edge = horizon * dx;
    let unbreakable = nodes(&block, |x| x.y < edge || x.y > SIZE[1] - edge);
    let pull = TENSION * dx * 1e-3;
    let forces = (0..block.len())
        .filter_map(|node| {
            let y = block.positions[node].y;
            let sign = if y < dx { -1.0 } else { 1.0 };
            (y < dx || y > SIZE[1] - dx).then_some((node as u32, Vec3::y() * (sign * pull)))
        })
        .collect();
    let criterion =
        if by_work { Criterion::EnergyByWork(ENERGY) } else { Criterion::EnergyByStretch(ENERGY) };
    let middle = 0.5 * SIZE[1];
    let mut body = Solid::new(Parts {
        fracture: Some(Fracture { criterion, unbreakable }),
        cracks: vec![Crack::Segment([Vec3::new(-dx, middle, 0.0), Vec3::new(NOTCH, middle, 0.0)])],
        loads: vec![AppliedLoad { forces, amplitude: Amplitude::Constant }],
        ..parts(block, material, formulation(space, law, horizon, correction))
    })?;
    let inside = |x: &Vec3| x.y > edge && x.y < SIZE[1] - edge && x.x < SIZE[0] - edge;
    let mut path = Vec::new();
    let mut balance: (f64, f64) = (0.0, 0.0);
    march(&mut body, 6e-5, 5e-7, 0.0, |body, record| {
        let tip = with_damage(body, |damaged| damaged.tip(inside)).unwrap_or(NOTCH);
        path.push((record.at.time, tip.max(NOTCH)));
        balance = (balance.0.max(record.balance_error.abs()), record.energy.external);
        if tip > SIZE[0] - edge - dx { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    })?;
    let bands = with_damage(&body, |damaged| damaged.bands(dx, |x| inside(x) && x.x > NOTCH));
    let branch = bands.iter().find(|(_, bands)| bands.len() > 1).map_or(f64::NAN, |(x, _)| *x);
    let at_end = bands.iter().filter(|(x, _)| *x > 0.9 * SIZE[0]).map(|(_, bands)| bands.len()).max();
    let [top, bottom] = [0, 1].map(|side| -> Vec<(f64, f64)> {
        let of = |bands: &[f64]| if side == 0 { bands[0] } else { bands[bands.len() - 1] };
        bands.iter().map(|(x, bands)| (*x, of(bands))).collect()
    });
    let joint: Vec<_> = top.iter().copied().filter(|(x, _)| !(*x > branch)).collect();
    let total = length(&top) + length(&bottom) - length(&joint);
    let asymmetry =
        top.iter().zip(&bottom).map(|(a, b)| (a.1 + b.1 - 2.0 * middle).abs()).fold(0.0, f64::max);
    let moduli = material.moduli(space)?;
    let speed = |modulus: f64| (modulus / material.density).sqrt();
    let rayleigh = rayleigh_speed(speed(moduli.lambda + 2.0 * moduli.mu), speed(moduli.mu));
    let [mean, most] = speeds(&path, 3e-6);
    println!(
        "{law:?} m {horizon} dx {:.2} mm {correction:?} work {by_work}: branch at {:.1} mm, {} bands at the end, mean \
         {:.3}, max {:.2} c_R ({rayleigh:.0} m/s), G of bonds / G0 {:.2} (length {:.1} mm), asymmetry {:.2} dx, balance \
         {:.1e} of work, {:.1} s",
        dx * 1e3,
        branch * 1e3,
        at_end.unwrap_or(0),
        mean / rayleigh,
        most / rayleigh,
        fracture_energy(&body) / (ENERGY * 1e-3 * total),
        total * 1e3,
        asymmetry / dx,
        balance.0 / balance.1,
        started.elapsed().as_secs_f64(),
    );
    Ok(())
}
