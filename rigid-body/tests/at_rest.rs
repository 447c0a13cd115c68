//! Rigid bodies without time: tangent, equilibria, modes on springs.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use explicit_dynamics::Amplitude;
use implicit_statics::{Equilibrium, Joinable};
use rigid_body::{Load, Parts, RestingBody, RigidBody, RotationHold, Spring, Support, cuboid};
use sph_core::Vec3;

/// A block on springs at its corners, loaded at one of them.
fn block(supports: Vec<Support>) -> RestingBody {
    let outline = cuboid([0.0; 3], [1.0, 2.0, 3.0], 5.0);
    let mass = outline.filled(0.5).unwrap();
    let direction = |a: usize| Vec3::new(1.0 + a as f64, 2.0, 3.0 - (a * a) as f64 / 10.0).normalize();
    let spring = |a: usize| Spring { particle: a as u32, stiffness: 3.0 + a as f64, direction: direction(a) };
    let springs = (0..8).map(spring).collect();
    let force = Load {
        forces: vec![(3, Vec3::new(0.4, -0.7, 0.2))],
        acceleration: Vec3::new(0.0, 0.0, -0.3),
        ..Load::default()
    };
    RestingBody::new(RigidBody::new(Parts { outline, mass, supports, loads: vec![force], springs }).unwrap())
}

/// Tangent and load rate against central differences of forces, in a turned state with forces of others: 4e-9 and 2e-10 measured. The
/// unsymmetric part of the derivative is that of turns that do not commute.
#[test]
fn the_tangent_is_the_symmetric_derivative_of_the_forces() {
    let moved =
        Support::Moved { direction: Vec3::new(1.0, 1.0, 0.0), by: 0.3, amplitude: Amplitude::Constant };
    let turned = Support::Rotated { axis: Vec3::new(0.0, 1.0, 1.0), by: 0.4, amplitude: Amplitude::Constant };
    for supports in [vec![], vec![moved.clone()], vec![moved, turned]] {
        let mut body = block(supports);
        let (count, level) = (body.unknowns(), 0.8);
        let increment: Vec<f64> = (0..count).map(|k| 0.1 - 0.05 * k as f64).collect();
        body.update(&increment);
        body.put(level);
        body.exert(&[2, 5], &[[0.1, 0.2, -0.3], [0.0, 0.4, 0.1]]);
        // Forces of others are dead: they go with the places on which they act.
        let lacking = |body: &mut RestingBody, level: f64| {
            body.release();
            body.put(level);
            body.exert(&[2, 5], &[[0.1, 0.2, -0.3], [0.0, 0.4, 0.1]]);
            let (mut internal, mut external) = (vec![0.0; count], vec![0.0; count]);
            body.internal(level, &mut internal);
            body.external(level, &mut external);
            internal.iter().zip(&external).map(|(i, e)| i - e).collect::<Vec<f64>>()
        };
        let mut values = vec![0.0; body.pattern().len()];
        body.tangent(level, &mut values);
        let (saved, h) = (body.save(), 1e-6);
        let mut columns = Vec::new();
        for k in 0..count {
            let [plus, minus] = [h, -h].map(|by| {
                let mut step = vec![0.0; count];
                step[k] = by;
                body.update(&step);
                let found = lacking(&mut body, level);
                body.restore(&saved);
                found
            });
            columns.push(plus.iter().zip(&minus).map(|(p, m)| (p - m) / (2.0 * h)).collect::<Vec<f64>>());
        }
        for ((row, column), value) in body.pattern().into_iter().zip(&values) {
            let symmetric = 0.5 * (columns[column][row] + columns[row][column]);
            assert!((value - symmetric).abs() < 1e-7, "{row} {column}: {value} {symmetric}");
        }
        let mut rate = vec![0.0; count];
        lacking(&mut body, level);
        body.load_rate(level, &mut rate);
        let [plus, minus] = [level + h, level - h].map(|level| lacking(&mut body, level));
        for k in 0..count {
            let exact = -(plus[k] - minus[k]) / (2.0 * h);
            assert!((rate[k] - exact).abs() < 1e-6, "{k}: {} {exact}", rate[k]);
        }
    }
}

/// A mass on a spring, and a body that turns about an axis on two springs: ω² = k/m and 2kr²/J.
#[test]
fn frequencies_on_springs_are_those_of_mass_and_inertia() {
    let outline = cuboid([-0.5, -1.0, -1.5], [0.5, 1.0, 1.5], 9.0);
    let mass = outline.filled(2.0).unwrap();
    let springs = (0..8).map(|particle| Spring { particle, stiffness: 1.5, direction: Vec3::z() }).collect();
    let held =
        Support::Held { displacement: vec![Vec3::x(), Vec3::y()], rotation: RotationHold::About(Vec3::x()) };
    let parts = Parts { outline, mass, supports: vec![held], loads: Vec::new(), springs };
    let mut body = RestingBody::new(RigidBody::new(parts).unwrap());
    let mut values = vec![0.0; 3];
    body.tangent(0.0, &mut values);
    let masses = body.vibrating_masses();
    let m = 2.0 * 6.0;
    let inertia = m / 12.0 * (4.0 + 9.0);
    assert!((values[0] / masses[0] - 8.0 * 1.5 / m).abs() < 1e-12, "{values:?} {masses:?}");
    assert!((values[2] / masses[1] - 8.0 * 1.5 / inertia).abs() < 1e-12, "{values:?} {masses:?}");
    assert!(values[1].abs() < 1e-12);
    assert!(body.name_unknown(1).contains("turning about (1.00, 0.00, 0.00)"));
}
