//! Sets that turn as one body: what nothing loads turns with them, and what is held on the other side is twisted.

use explicit_dynamics::{Amplitude, March, Transient};
use implicit_statics::{Equilibrium, Newton, NewtonOptions, linear_response, load_rate_error};
use peridynamics::{Law, Parts, Solid, SolidError, Space, StaticSolid, Support, Supported};
use sph_core::{Vec3, rotated};

use crate::blocks::{held, moved, nodes};
use crate::bodies::{LAWS, block_parts};

const AXIS: [f64; 3] = [0.3, -0.5, 0.8];
const POINT: [f64; 3] = [1.0, 2.0, -0.5];

fn turned(nodes: Vec<u32>, [axis, point]: [Vec3; 2], by: f64) -> Supported {
    Supported { nodes, support: Support::Turned { axis, point, by, amplitude: Amplitude::Constant } }
}

fn end(parts: &Parts, upper: bool, length: f64) -> Vec<u32> {
    nodes(&parts.block, |x| if upper { x.x > length - 2.0 } else { x.x < 2.0 })
}

#[test]
fn a_block_whose_end_turns_goes_with_it_unstrained() {
    let (axis, point) = (Vec3::from(AXIS), Vec3::from(POINT));
    for law in LAWS {
        let mut parts = block_parts(Space::Solid, law, [6, 4, 4]);
        let by = 2.0;
        parts.supports = vec![turned(end(&parts, false, 6.0), [axis, point], by)];
        let mut system = StaticSolid::new(Solid::new(parts).unwrap());
        let options = NewtonOptions { tolerance: 1e-12, ..NewtonOptions::default() };
        let mut newton = Newton::new(&system, &options).unwrap();
        for step in 1..=8 {
            newton.at_level(&mut system, f64::from(step) / 8.0).unwrap();
        }
        system.evaluate(1.0);
        let solid = system.solid();
        for node in 0..solid.len() {
            let arm = solid.block().positions[node] - point;
            let wanted = point + rotated(&arm, &(axis.normalize() * by));
            // Measured 3e-9 of a spacing.
            assert!(
                (solid.position(node) - wanted).norm() < 1e-8,
                "{law:?}: {:?}",
                solid.position(node) - wanted
            );
        }
        assert!(solid.internal_energy() < 1e-16, "{:e}", solid.internal_energy());
    }
}

#[test]
fn a_bar_is_twisted_as_saint_venant_says() {
    // G J θ/L with J = .1406 a⁴ of a square bar; the turned layers are rigid, 12 of 16 cells are free between their faces.
    let (cells, length, by) = ([16, 6, 6], 12.0, 1e-3);
    let mut parts = block_parts(Space::Solid, Law::StateBased, cells);
    let axis = [Vec3::x(), Vec3::new(0.0, 3.0, 3.0)];
    let ends = [false, true].map(|upper| end(&parts, upper, 16.0));
    parts.supports = vec![turned(ends[0].clone(), axis, -0.5 * by), turned(ends[1].clone(), axis, 0.5 * by)];
    let shear = 0.5 * parts.material.young / (1.0 + parts.material.poisson);
    let mut system = StaticSolid::new(Solid::new(parts).unwrap());
    let answer = linear_response(&mut system, 0.0).unwrap();
    system.update(&answer);
    system.evaluate(1.0);
    let solid = system.solid();
    let torque = |set: &[u32]| -> f64 {
        let of = |&node: &u32| {
            let arm = solid.block().positions[node as usize] - axis[1];
            axis[0].dot(&arm.cross(&solid.reaction(node as usize)))
        };
        set.iter().map(of).sum()
    };
    let exact = shear * 0.1406 * 6.0_f64.powi(4) * by / length;
    let found = torque(&ends[1]) / exact;
    println!("torque over Saint-Venant's {found:.4}");
    assert!((torque(&ends[0]) + torque(&ends[1])).abs() < 1e-9 * exact);
    // Six nodes across, horizon of three spacings: bonds feel shears averaged over it (docs/peridynamics.md).
    assert!((found - 1.0).abs() < 0.25, "{found}");
}

#[test]
fn turns_go_with_the_level_and_with_time() {
    let (axis, point) = (Vec3::from(AXIS), Vec3::from(POINT));
    let mut parts = block_parts(Space::Solid, Law::StateBased, [6, 4, 4]);
    parts.supports = vec![
        held(end(&parts, true, 6.0), &[Vec3::x(), Vec3::y(), Vec3::z()]),
        turned(end(&parts, false, 6.0), [axis, point], 0.3),
    ];
    let still = parts.supports[0].clone();
    let set = parts.supports[1].nodes.clone();
    let mut system = StaticSolid::new(Solid::new(parts).unwrap());
    for level in [0.0, 0.4, 1.0] {
        let error = load_rate_error(&mut system, level, 1e-4);
        assert!(error < 1e-7, "{level}: {error:e}");
    }
    let mut parts = block_parts(Space::Solid, Law::StateBased, [6, 4, 4]);
    let ramp = Amplitude::Ramp(3.0);
    let support = Support::Turned { axis, point, by: 0.3, amplitude: ramp.clone() };
    parts.supports = vec![still, Supported { nodes: set.clone(), support }];
    let mut body = Solid::new(parts).unwrap();
    let run = Transient { duration: 2.0, record_every: 1.0, damping: 0.0, safety: 0.9 };
    let mut march = March::start(run, &mut body).unwrap();
    while let Some(record) = march.next_record(&mut body).unwrap() {
        for &node in &set {
            let arm = body.block().positions[node as usize] - point;
            let angle = axis.normalize() * (0.3 * ramp.value(record.at.time));
            let apart = body.position(node as usize) - (point + rotated(&arm, &angle));
            assert!(apart.norm() < 1e-12, "{apart:?}");
        }
    }
}

#[test]
fn turns_against_what_is_held_are_refused() {
    let refused = |second: Supported| {
        let mut parts = block_parts(Space::Solid, Law::BondBased, [6, 4, 4]);
        let set = end(&parts, false, 6.0);
        parts.supports = vec![turned(set, [Vec3::x(), Vec3::new(0.0, 2.0, 2.0)], 0.1), second];
        Solid::new(parts).map(|_| ()).unwrap_err()
    };
    assert!(matches!(refused(held(vec![0], &[Vec3::y()])), SolidError::Contradiction { node: 0, .. }));
    assert!(matches!(refused(turned(vec![0], [Vec3::y(), Vec3::zeros()], 0.1)), SolidError::TwoTurns(0)));
    // Along the axis nothing moves, and a displacement adds to the turn.
    let mut parts = block_parts(Space::Solid, Law::BondBased, [6, 4, 4]);
    let set = end(&parts, false, 6.0);
    let about = turned(set.clone(), [Vec3::x(), Vec3::new(0.0, 2.0, 2.0)], 0.1);
    parts.supports = vec![about, held(vec![0], &[Vec3::x()])];
    Solid::new(parts.clone()).unwrap();
    parts.supports = vec![parts.supports[0].clone(), moved(set, Vec3::x(), 0.1)];
    Solid::new(parts).unwrap();
}
