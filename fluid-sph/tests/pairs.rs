//! What pairs do to each other sums to nothing, in a plane and in space, with walls and without.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

mod common;

use common::{disorder, pool};
use explicit_dynamics::{Dynamics, Instant, Step};
use fluid_sph::{Fluid, Formulation};
use sph_core::Vec3;

/// A disordered block in motion, with laminar friction too, in a basin or without.
fn block(dimensions: usize, basin: bool) -> Fluid {
    let water = if dimensions == 2 { [1.0, 1.0, 0.0] } else { [0.6; 3] };
    let mut parts = pool(dimensions, water, water, 0.05);
    parts.formulation = Formulation { kinematic_viscosity: 0.01, ..Formulation::default() };
    disorder(&mut parts, 0.4, 1.0);
    if !basin {
        parts.walls.clear();
    }
    Fluid::new(parts).unwrap()
}

/// A kick of one unit of time from rest: what it adds to velocities are the accelerations.
fn accelerations(fluid: &mut Fluid) -> Vec<Vec3> {
    let at = Instant { time: 0.0, level: 1.0 };
    fluid.evaluate(at);
    let before = fluid.velocities().to_vec();
    fluid.kick(&Step { from: at, to: Instant { time: 1.0, level: 1.0 }, kick: 1.0, damping: 0.0 });
    fluid.velocities().iter().zip(before).map(|(new, old)| new - old).collect()
}

/// Round-off: every pair is opposite to the bit, sums differ by their order only. Measured 1.6e-16 to 1.9e-15.
#[test]
fn forces_sum_to_the_weight_and_what_walls_bear() {
    for dimensions in [2, 3] {
        for basin in [false, true] {
            let mut fluid = block(dimensions, basin);
            let accelerations = accelerations(&mut fluid);
            let total: Vec3 = accelerations.iter().sum::<Vec3>() * fluid.mass();
            let scale: f64 = accelerations.iter().map(|a| a.norm()).sum::<f64>() * fluid.mass();
            let weight = fluid_gravity(dimensions) * (fluid.mass() * fluid.len() as f64);
            let borne = if basin { fluid.wall_force(0) } else { Vec3::zeros() };
            assert_eq!(basin, borne.norm() > 0.0);
            let lack = (total + borne - weight).norm() / scale;
            assert!(lack < 6e-15, "{dimensions} {basin}: {lack:e}");
        }
    }
}

/// Forces act along lines of centres: their moments about any point sum to those of the weight and of what walls bear.
#[test]
fn moments_sum_to_the_weight_and_what_walls_bear() {
    for dimensions in [2, 3] {
        for basin in [false, true] {
            let mut fluid = block(dimensions, basin);
            let accelerations = accelerations(&mut fluid);
            let about = Vec3::new(0.3, -0.7, if dimensions == 3 { 0.2 } else { 0.0 });
            let gravity = fluid_gravity(dimensions);
            let (mut lack, mut scale) = (Vec3::zeros(), 0.0);
            for (place, a) in fluid.positions().iter().zip(&accelerations) {
                let moment = (place - about).cross(&(a - gravity)) * fluid.mass();
                lack += moment;
                scale += moment.norm();
            }
            if basin {
                lack += fluid.wall_moment(0, about);
            }
            assert!(lack.norm() < 2e-14 * scale, "{dimensions} {basin}: {:e}", lack.norm() / scale);
        }
    }
}

fn fluid_gravity(dimensions: usize) -> Vec3 {
    let mut gravity = Vec3::zeros();
    gravity[dimensions - 1] = -common::GRAVITY;
    gravity
}

/// Measured 1.3e-16.
#[test]
fn a_block_that_flies_keeps_its_momentum() {
    for dimensions in [2, 3] {
        let mut parts = pool(dimensions, [0.5, 0.5, if dimensions == 2 { 0.0 } else { 0.5 }], [0.5; 3], 0.05);
        parts.walls.clear();
        parts.gravity = Vec3::zeros();
        disorder(&mut parts, 0.3, 1.0);
        let mut fluid = Fluid::new(parts).unwrap();
        let before = fluid.momentum();
        let scale: f64 = fluid.velocities().iter().map(|v| v.norm()).sum::<f64>() * fluid.mass();
        common::march(&mut fluid, 0.1, |_, _| ());
        let change = (fluid.momentum() - before).norm() / scale;
        assert!(change < 1e-14, "{dimensions}: {change:e}");
    }
}
