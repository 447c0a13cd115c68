//! A drop without walls becomes an ellipse: its axes are known.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

mod common;

use common::march;
use fluid_sph::{Fluid, Formulation, Liquid, Parts, Start};
use sph_core::Vec3;

/// Rate of the flow at the start \[1/T\] and the speed of sound.
const RATE: f64 = 100.0;
const SOUND: f64 = 1400.0;

/// The drop of radius 1 in the flow `v = s (−x, y)`, in space `v = s (−x/2, −y/2, z)`.
fn drop(dimensions: usize, spacing: f64, smoothing: f64) -> Fluid {
    let n = (1.0 / spacing).ceil() as usize + 1;
    let (low, count) = (-(n as f64) * spacing, 2 * n);
    let all = if dimensions == 2 {
        common::lattice([low, low, -0.5 * spacing], [count, count, 1], spacing)
    } else {
        common::lattice([low; 3], [count; 3], spacing)
    };
    let positions: Vec<Vec3> = all.into_iter().filter(|p| p.norm() < 1.0).collect();
    let flow = |p: &Vec3| match dimensions {
        2 => Vec3::new(-p.x, p.y, 0.0),
        _ => Vec3::new(-0.5 * p.x, -0.5 * p.y, p.z),
    };
    Fluid::new(Parts {
        dimensions,
        spacing,
        velocities: positions.iter().map(|p| flow(p) * RATE).collect(),
        positions,
        liquid: Liquid { density: 1000.0, sound_speed: SOUND },
        formulation: Formulation { smoothing, ..Formulation::default() },
        gravity: Vec3::zeros(),
        start: Start::Uniform,
        walls: Vec::new(),
        structures: Vec::new(),
        domain: None,
        threads: 1,
    })
    .unwrap()
}

/// The axis a that grows, of a drop that keeps its volume: with the pressure `p₀(t)(1 − x²/b² − … − y²/a²)` Euler's
/// equations of both axes leave `s' = s² (b² − a²)/(a² + b²)` in a plane \[monaghan1994\] and
/// `s' = s² (b²/4 − a²)/(a² + b²/2)` in space, `a' = a s`.
fn exact(dimensions: usize, until: f64) -> f64 {
    let slope = |a: f64, s: f64| {
        let b2 = if dimensions == 2 { 1.0 / (a * a) } else { 1.0 / a };
        let turned = if dimensions == 2 {
            (b2 - a * a) / (a * a + b2)
        } else {
            (0.25 * b2 - a * a) / (a * a + 0.5 * b2)
        };
        (a * s, s * s * turned)
    };
    let (mut a, mut s, steps) = (1.0, RATE, 20_000);
    let dt = until / steps as f64;
    for _ in 0..steps {
        let (da, ds) = slope(a, s);
        let (ea, es) = slope(a + 0.5 * dt * da, s + 0.5 * dt * ds);
        (a, s) = (a + dt * ea, s + dt * es);
    }
    a
}

/// Both axes over the exact ones, by the extreme particles, and what is missing of the energy over that at the start.
fn march_drop(dimensions: usize, spacing: f64, smoothing: f64, until: f64) -> [f64; 3] {
    let mut fluid = drop(dimensions, spacing, smoothing);
    let reach = |fluid: &Fluid, k: usize| fluid.positions().iter().map(|p| p[k]).fold(0.0, f64::max);
    let (long, short) = (dimensions - 1, 0);
    let start = [reach(&fluid, long), reach(&fluid, short)];
    let before = fluid.energies();
    march(&mut fluid, until, |_, _| ());
    let after = fluid.energies();
    let total = after.kinetic + after.compression + after.viscous + after.diffusion;
    let a = exact(dimensions, until);
    let b = if dimensions == 2 { 1.0 / a } else { (1.0 / a).sqrt() };
    let scale = fluid.momentum().norm() / (fluid.mass() * fluid.len() as f64 * RATE);
    assert!(scale < 1e-15 * fluid.len() as f64, "{scale:e}");
    [reach(&fluid, long) / start[0] / a, reach(&fluid, short) / start[1] / b, total / before.kinetic - 1.0]
}

/// Measured 1.012, 1.104 with h = 1.3 Δx, 1.007, 1.000 with 2 Δx, and 1e-5 of energy (at half the spacing 0.998, 1.081
/// and 0.994, 0.994). A stretched lattice leaves gaps that a kernel of h = 1.3 Δx does not bridge: the short axis is too long by 8 %, which
/// h = 2 Δx cures. The energy closes to the error of the step.
#[test]
fn in_a_plane() {
    let [long, short, energy] = march_drop(2, 0.04, 1.3, 0.0076);
    assert!((long - 1.0).abs() < 0.02 && (short - 1.0).abs() < 0.12 && energy.abs() < 1e-4);
    let [long, short, energy] = march_drop(2, 0.04, 2.0, 0.0076);
    assert!((long - 1.0).abs() < 0.03 && (short - 1.0).abs() < 0.03 && energy.abs() < 1e-4);
}

/// The same in space; measured 1.009, 1.000, 1e-5.
#[test]
fn in_space() {
    let [long, short, energy] = march_drop(3, 0.1, 1.5, 0.004);
    assert!((long - 1.0).abs() < 0.03 && (short - 1.0).abs() < 0.03 && energy.abs() < 1e-4);
}
