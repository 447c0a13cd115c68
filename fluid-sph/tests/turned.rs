//! A flow turned by a quarter, or mirrored, is the same flow.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

mod common;

use common::{disorder, march, pool};
use fluid_sph::{Fluid, Formulation, Parts};
use sph_core::Vec3;

/// Water that falls in a basin, after a way of its own through space.
fn marched(dimensions: usize, way: impl Fn(&Vec3) -> Vec3) -> Fluid {
    let (size, basin) =
        if dimensions == 2 { ([0.5, 0.8, 0.0], [0.9, 0.8, 0.0]) } else { ([0.4; 3], [0.6; 3]) };
    let mut parts: Parts = pool(dimensions, size, basin, 0.1);
    parts.formulation = Formulation { kinematic_viscosity: 1e-3, ..parts.formulation };
    disorder(&mut parts, 0.2, 0.5);
    let lists = [&mut parts.positions, &mut parts.velocities, &mut parts.walls[0].points];
    lists.into_iter().for_each(|list| list.iter_mut().for_each(|v| *v = way(v)));
    parts.gravity = way(&parts.gravity);
    let mut fluid = Fluid::new(parts).unwrap();
    march(&mut fluid, 0.15, |_, _| ());
    fluid
}

/// The order of sums changes with the order of cells, so that round-off grows with the steps: measured 7e-16.
#[test]
fn quarters_and_mirrors() {
    for dimensions in [2, 3] {
        let plain = marched(dimensions, |v| *v);
        let ways = plain.positions().iter().zip(plain.rest()).map(|(now, rest)| (now - rest).norm());
        assert!(ways.fold(0.0, f64::max) > 0.05);
        let turn = |v: &Vec3| Vec3::new(-v.y, v.x, v.z);
        let mirror = |v: &Vec3| Vec3::new(-v.x, v.y, v.z);
        let tip =
            |v: &Vec3| if dimensions == 2 { Vec3::new(v.y, v.x, v.z) } else { Vec3::new(v.y, v.z, v.x) };
        let ways: [&dyn Fn(&Vec3) -> Vec3; 3] = [&turn, &mirror, &tip];
        for (number, way) in ways.into_iter().enumerate() {
            let other = marched(dimensions, way);
            let pairs = plain.positions().iter().zip(other.positions());
            let worst = pairs.map(|(a, b)| (way(a) - b).norm()).fold(0.0, f64::max);
            assert!(worst < 1e-13, "{dimensions} {number}: {worst:e}");
        }
    }
}
