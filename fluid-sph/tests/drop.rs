//! A drop without walls: momentum, and the ellipse it becomes.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

mod common;

use common::march;
use fluid_sph::{Fluid, Formulation, Liquid, Parts, Scheme, Start};
use sph_core::Vec3;

/// The drop of radius 1 m in the flow `v = 100 (−x, y)`.
fn drop(spacing: f64, smoothing: f64, scheme: Scheme) -> Fluid {
    let n = (1.0 / spacing).ceil() as usize + 1;
    let all = common::lattice(
        [-(n as f64) * spacing, -(n as f64) * spacing, -0.5 * spacing],
        [2 * n, 2 * n, 1],
        spacing,
    );
    let positions: Vec<Vec3> = all.into_iter().filter(|p| p.norm() < 1.0).collect();
    let velocities = positions.iter().map(|p| Vec3::new(-100.0 * p.x, 100.0 * p.y, 0.0)).collect();
    Fluid::new(Parts {
        dimensions: 2,
        spacing,
        positions,
        velocities,
        liquid: Liquid { density: 1000.0, sound_speed: 1400.0 },
        formulation: Formulation { smoothing, scheme, ..Formulation::default() },
        gravity: Vec3::zeros(),
        start: Start::Uniform,
        walls: Vec::new(),
        structures: Vec::new(),
        domain: None,
        threads: 1,
    })
    .unwrap()
}

/// The semi-axis of the incompressible drop that grows: `a'' = a (a'² − ...)`, by [monaghan1994] from dA/dt, dω/dt.
fn exact(until: f64) -> f64 {
    let (mut a, mut rate, steps) = (1.0_f64, 100.0_f64, 100_000);
    let dt = until / steps as f64;
    let derivative = |a: f64, rate: f64| {
        let a4 = a.powi(4);
        (a * rate, rate * rate * (1.0 - a4) / (1.0 + a4))
    };
    for _ in 0..steps {
        let (da, dr) = derivative(a, rate);
        let (ea, er) = derivative(a + 0.5 * dt * da, rate + 0.5 * dt * dr);
        a += dt * ea;
        rate += dt * er;
    }
    a
}

#[test]
fn shape() {
    for smoothing in [1.3, 2.0] {
        let mut fluid = drop(0.02, smoothing, Scheme::KickDriftKick);
        let before = fluid.energies();
        let t = std::time::Instant::now();
        let mut n = 0;
        march(&mut fluid, 0.0076, |_, _| n += 1);
        let e = t.elapsed().as_nanos() as f64 / (n * fluid.len()) as f64;
        let after = fluid.energies();
        let major = fluid.positions().iter().map(|p| p.y).fold(0.0, f64::max);
        let minor = fluid.positions().iter().map(|p| p.x).fold(0.0, f64::max);
        let a = exact(0.0076);
        println!(
            "h {smoothing} major {:.4} minor {:.4} steps {n} {e:.0} ns  {before:?} {after:?}  momentum {:?}",
            major / a,
            minor * a,
            fluid.momentum()
        );
        println!("bytes {} err {}", fluid.bytes_per_particle(), fluid.greatest_density_error());
    }
}
