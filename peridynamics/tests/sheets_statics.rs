//! The thin plate of 300 × 200 × 2 on a lattice of 20: forces and critical loads near those of plate theory, relaxation
//! against Newton's method, mirror images.

mod plates;

use std::ops::ControlFlow;

use explicit_dynamics::Amplitude;
use implicit_statics::{
    BucklingOptions, Damping, Equilibrium, Newton, NewtonOptions, RelaxationOptions, linear_buckling, relax,
};
use peridynamics::{Solid, StaticSolid, Support, Supported};
use plates::{ALUMINIUM, hinged, parts};
use sph_core::{Block, Vec3, rotated};

const LENGTHS: [f64; 2] = [300.0, 200.0];

/// All edges keep their places across x, the end x = 300 moves by so much.
fn supports(block: &Block, way: f64) -> Vec<Supported> {
    let on = |face: usize| -> Vec<u32> { block.faces[face].iter().map(|&(node, _)| node).collect() };
    let held = |face: usize, direction: Vec3| Supported {
        nodes: on(face),
        support: Support::Held { displacement: vec![direction], director: Vec::new() },
    };
    let mut out = hinged(block);
    out.extend((0..4).map(|face| held(face, Vec3::y())));
    out.push(held(0, Vec3::x()));
    let moved = Support::Moved { direction: Vec3::x(), by: way, amplitude: Amplitude::default() };
    out.push(Supported { nodes: on(1), support: moved });
    out
}

/// The plate with one half-wave of deflection at rest.
fn plate(way: f64, deflection: f64) -> StaticSolid {
    let mut block = plates::block(LENGTHS, 2.0, 20.0);
    let supports = supports(&block, way);
    let pi = std::f64::consts::PI;
    for x in &mut block.positions {
        x.z = deflection * (libm::sin(pi * x.x / LENGTHS[0]) * libm::sin(pi * x.y / LENGTHS[1]));
    }
    let mut parts = parts(block, ALUMINIUM);
    parts.supports = supports;
    StaticSolid::new(Solid::new(parts).expect("a plate"))
}

fn end_force(plate: &mut StaticSolid, end: usize, level: f64) -> f64 {
    plate.evaluate(level);
    let solid = plate.solid();
    solid.block().faces[end].iter().map(|&(node, _)| solid.reaction(node as usize).x).sum()
}

fn balance(plate: &mut StaticSolid, level: f64) {
    let mut newton = Newton::new(plate, &NewtonOptions::default()).expect("options");
    newton.at_level(plate, level).expect("a balance");
}

#[test]
fn a_plate_shortened_in_its_plane_is_as_stiff_as_theory_has_it() {
    let mut plate = plate(-1.2e-4, 0.0);
    balance(&mut plate, 1.0);
    let [left, right] = [0, 1].map(|end| end_force(&mut plate, end, 1.0));
    let theory = -69_000.0 / (1.0 - 0.33 * 0.33) * 400.0 * 1.2e-4 / 300.0;
    // .87 % too soft at this spacing, .44 % at half of it; the ends differ by what Newton's method left.
    assert!((right / theory - 1.0).abs() <= 0.026, "{right} against {theory}");
    assert!((left / right + 1.0).abs() <= 2e-9, "{left} against {right}");
}

#[test]
fn a_plate_buckles_at_its_critical_load() {
    let mut plate = plate(-1.2, 0.0);
    let options = BucklingOptions::new(2);
    let modes =
        linear_buckling(&mut plate, 0.0, &options, &mut |_| ControlFlow::Continue(())).expect("modes").modes;
    // k π² D/b², k = [(b/a)² + 1]²/[(b/a)² + ν] for one half-wave, over the stress of the unit level.
    let theory = |m: f64| {
        let ratio = (m * LENGTHS[1] / LENGTHS[0]).powi(2);
        let k = (ratio + 1.0).powi(2) / (ratio + 0.33);
        k * std::f64::consts::PI.powi(2) / 12.0 * (2.0 / LENGTHS[1]).powi(2) / (1.2 / 300.0)
    };
    for (mode, m) in modes.iter().zip([1.0, 2.0]) {
        // The level counts shortening, for which the plate is .87 % too soft: 1.8 and 1.6 % above.
        assert!((mode.level / theory(m) - 1.0).abs() <= 0.054, "{m}: {} against {}", mode.level, theory(m));
    }
}

#[test]
fn relaxation_finds_what_newton_finds() {
    // Flat with viscous damping in 36 iterations, buckled with kinetic damping in 237.
    for (deflection, way, damping, iterations) in
        [(0.0, -0.12, Damping::Rayleigh, 110), (0.2, -0.12, Damping::Kinetic, 720)]
    {
        let mut plate = plate(way, deflection);
        let rest = plate.save();
        for level in 1..=4 {
            balance(&mut plate, 0.25 * f64::from(level));
        }
        let exact = end_force(&mut plate, 1, 1.0);
        plate.restore(&rest);
        let solid = plate.solid_mut();
        for node in 0..solid.len() {
            let x = solid.position(node);
            solid.put(node, x + Vec3::x() * (way * x.x / LENGTHS[0]));
        }
        let options =
            RelaxationOptions { tolerance: 1e-5, damping, ramp: 1, iterations, ..Default::default() };
        relax(&mut plate, &options, (1.0, 1.0), |_| ControlFlow::Continue(())).expect("at rest");
        let load = end_force(&mut plate, 1, 1.0);
        // 7e-6 and 5e-5, what a residual of 1e-5 leaves.
        assert!((load / exact - 1.0).abs() <= 1e-4, "{load} against {exact}");
    }
}

#[test]
fn a_plate_and_its_mirror_image_buckle_to_the_same_bits() {
    let mut loads = [0.0; 2];
    let mut deflections = [Vec::new(), Vec::new()];
    for (side, sign) in [1.0, -1.0].into_iter().enumerate() {
        let mut plate = plate(-0.12, sign * 0.2);
        for level in 1..=4 {
            balance(&mut plate, 0.25 * f64::from(level));
        }
        loads[side] = end_force(&mut plate, 1, 1.0);
        let solid = plate.solid();
        deflections[side] = (0..solid.len()).map(|node| sign * solid.position(node).z).collect::<Vec<f64>>();
    }
    assert_eq!(loads[0].to_bits(), loads[1].to_bits());
    assert_eq!(deflections[0], deflections[1]);
}

/// An end that turns, places and directors, takes the rest of the plate along; where the other end is clamped it is twisted.
#[test]
fn a_plate_goes_with_its_turned_end() {
    let (axis, point, by) = (Vec3::new(0.2, 0.9, 0.3), Vec3::new(10.0, -5.0, 20.0), 0.8);
    let mut parts = parts(plates::block(LENGTHS, 20.0, 50.0), ALUMINIUM);
    let on = |face: usize| parts.block.faces[face].iter().map(|&(node, _)| node).collect();
    let support = Support::Turned { axis, point, by, amplitude: Amplitude::default() };
    parts.supports = vec![Supported { nodes: on(0), support }];
    let mut plate = StaticSolid::new(Solid::new(parts).expect("a plate"));
    let mut newton = Newton::new(&plate, &NewtonOptions::default()).expect("options");
    for step in 1..=32 {
        newton.at_level(&mut plate, f64::from(step) / 32.0).expect("a balance");
    }
    let (solid, angle) = (plate.solid(), axis.normalize() * by);
    for node in 0..solid.len() {
        let place = point + rotated(&(solid.block().positions[node] - point), &angle);
        assert!((solid.position(node) - place).norm() < 1e-5, "{:?}", solid.position(node) - place);
        let director = solid.director(node).expect("a director");
        assert!((director - rotated(&Vec3::z(), &angle)).norm() < 1e-7, "{director:?}");
    }
}
