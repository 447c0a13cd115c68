//! Water that comes in and goes out: plug flow, counts of what passes, levels, pulses, energies, the same bits however it is run.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

mod common;

use common::{GRAVITY, lattice, march};
use explicit_dynamics::Amplitude;
use fluid_sph::{Fluid, Formulation, Given, Liquid, Opening, Parts, Periods, Start, Wall};
use sph_core::Vec3;

const SPACING: f64 = 0.02;

fn opening(x: f64, into: f64, given: Given) -> Opening {
    Opening { at: Vec3::x() * x, into: Vec3::x() * into, given }
}

fn velocity(into: f64) -> Given {
    Given::Velocity { into, course: Amplitude::Constant, profile: Vec::new(), level: None }
}

fn level(level: f64) -> Given {
    Given::Pressure { at_level: 0.0, level }
}

/// A channel of a length, so deep, whose bed goes on five spacings beyond its ends, with the water at a velocity.
fn channel(length: f64, rows: usize, at_start: f64, openings: Vec<Opening>, threads: usize) -> Fluid {
    let columns = (length / SPACING).round() as usize;
    let positions = lattice([0.0, 0.0, -0.5 * SPACING], [columns, rows, 1], SPACING);
    let bed = lattice([-5.0 * SPACING, -3.0 * SPACING, -0.5 * SPACING], [columns + 10, 3, 1], SPACING);
    let depth = rows as f64 * SPACING;
    let mut fluid = Fluid::new(Parts {
        dimensions: 2,
        spacing: SPACING,
        velocities: vec![Vec3::x() * at_start; positions.len()],
        positions,
        liquid: Liquid { density: 1000.0, sound_speed: 12.0 * (GRAVITY * depth).sqrt() },
        formulation: Formulation { viscosity: 0.002, ..Formulation::default() },
        gravity: Vec3::y() * -GRAVITY,
        start: Start::Hydrostatic,
        walls: vec![Wall { points: bed, motion: None }],
        structures: Vec::new(),
        domain: None,
        threads,
    })
    .unwrap();
    let count = fluid.len();
    fluid.open(openings, 2 * count).unwrap();
    fluid
}

/// Water without gravity that goes through a periodic channel, in at one end and out at the other.
fn plug(speed: f64, last: Given) -> Fluid {
    let positions = lattice([0.0, 0.0, -0.5 * SPACING], [20, 10, 1], SPACING);
    let mut fluid = Fluid::repeated(
        Parts {
            dimensions: 2,
            spacing: SPACING,
            velocities: vec![Vec3::x() * speed; positions.len()],
            positions,
            liquid: Liquid { density: 1000.0, sound_speed: 10.0 },
            formulation: Formulation { confined: true, ..Formulation::default() },
            gravity: Vec3::zeros(),
            start: Start::Uniform,
            walls: Vec::new(),
            structures: Vec::new(),
            domain: None,
            threads: 1,
        },
        Periods { low: Vec3::zeros(), lengths: Vec3::y() * 0.2 },
    )
    .unwrap();
    let ends = vec![opening(0.0, 1.0, velocity(speed)), opening(0.4, -1.0, last)];
    fluid.open(ends, 400).unwrap();
    fluid
}

#[test]
fn a_plug_keeps_its_speed_and_pressure() {
    for last in [Given::Free, velocity(-0.5), Given::Pressure { at_level: 0.0, level: 0.0 }] {
        let mut fluid = plug(0.5, last.clone());
        march(&mut fluid, 1.2, |_, _| ());
        let [[came, back], [wrong, went]] = fluid.passed()[..] else { panic!("two openings") };
        let here: Vec<usize> = (0..fluid.len()).filter(|&i| fluid.is_here(i)).collect();
        let slowest = here.iter().map(|&i| (fluid.velocities()[i] - Vec3::x() * 0.5).norm()).fold(0.0, f64::max);
        let pressure = here.iter().map(|&i| fluid.pressures()[i].abs()).fold(0.0, f64::max);
        eprintln!("{last:?}: in {came}, out {went}, {} here, {slowest:e}, {pressure:e}", here.len());
        assert_eq!((back, wrong), (0, 0));
        assert_eq!(200 + came - went, here.len() as u64);
        assert_eq!((came, went), (300, 300));
        assert!(slowest < 1e-9 && pressure < 1e-6, "{last:?}: {slowest:e} {pressure:e}");
    }
}

#[test]
fn a_channel_is_steady() {
    let (depth, speed) = (0.2, 0.5);
    let ends = vec![opening(0.0, 1.0, velocity(speed)), opening(2.0, -1.0, level(depth))];
    let mut fluid = channel(2.0, 10, speed, ends, 1);
    let mut depths = [0.0; 3];
    let mut count = 0.0;
    march(&mut fluid, 6.0, |clock, fluid| {
        if clock.now.time > 2.0 && clock.steps.is_multiple_of(50) {
            depths = [0, 1, 2].map(|k| depths[k] + fluid.level_at(Vec3::x() * [0.3, 1.0, 1.7][k]));
            count += 1.0;
        }
        if clock.steps.is_multiple_of(400) {
            let at = [0.3, 1.0, 1.7].map(|x| (fluid.level_at(Vec3::x() * x) * 1e4).round() / 1e4);
            eprintln!("{:.3} {:?} {} {at:?}", clock.now.time, fluid.passed(), fluid.held());
        }
    });
    let depths = depths.map(|sum| sum / count / depth);
    eprintln!("{depths:?}");
    assert!(depths.iter().all(|own| (own - 1.0).abs() < 0.02), "{depths:?}");
}

#[test]
fn zz_probe() {
    let (depth, speed) = (0.2, 0.5);
    let ends = vec![opening(0.0, 1.0, velocity(speed)), opening(2.0, -1.0, level(depth))];
    let mut fluid = channel(2.0, 10, speed, ends, 1);
    let mut next = 0.0;
    march(&mut fluid, 6.0, |clock, fluid| {
        if clock.now.time < next { return; }
        next += 1.0;
        eprintln!("t {:.2}", clock.now.time);
        for bin in 0..20 {
            let (a, b) = (0.1 * f64::from(bin), 0.1 * f64::from(bin + 1));
            let all: Vec<usize> = (0..fluid.len()).filter(|&i| fluid.is_here(i) && fluid.positions()[i].x >= a && fluid.positions()[i].x < b).collect();
            let n = all.len() as f64;
            let u = all.iter().map(|&i| fluid.velocities()[i].x).sum::<f64>() / n;
            let low: Vec<&usize> = all.iter().filter(|i| fluid.positions()[**i].y < 0.05).collect();
            let ul = low.iter().map(|i| fluid.velocities()[**i].x).sum::<f64>() / low.len() as f64;
            let h = n * SPACING * SPACING / 0.1;
            let level = fluid.level_at(Vec3::x() * (a + 0.05));
            let p = fluid.pressure_at(Vec3::new(a + 0.05, 0.05, 0.0)).unwrap_or(0.0) / (1000.0 * GRAVITY) + 0.05;
            eprintln!("{a:.1} n {n} h {h:.4} level {level:.4} head(p) {p:.4} u {u:.4} low {ul:.4}");
        }
    });
}
