//! Bonds that break: the energy they take with them, what is kept of them, what is left.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

mod lattices;

use explicit_dynamics::{Dynamics, Instant, Step};
use lattices::{ALL, Random, displace, formulation, lattice, parts, plane, poisson};
use peridynamics::{Criterion, Elastic, Fracture, Law, Parts, Solid, Space};
use sph_core::Vec3;

const AT: Instant = Instant { time: 0.0, level: 1.0 };
/// A step that hardly kicks and does not drift.
const STILL: Step = Step { from: AT, to: AT, kick: 1e-30, damping: 0.0 };

const BY_STRETCH: Criterion = Criterion::Stretch { tension: 0.012, compression: Some(-0.02) };
const BY_WORK: Criterion = Criterion::EnergyByWork(40.0);

/// A block of 1 mm lattice, disturbed by nothing.
fn body(space: Space, law: Law, criterion: Criterion) -> Solid {
    let three = space == Space::Solid;
    let block = if three { lattice(3, [9, 8, 7], [1e-3; 3]) } else { plane([15, 16], 1e-3) };
    let material = Elastic { young: 72e9, poisson: poisson(space, law), density: 2440.0 };
    let fracture = Some(Fracture { criterion, unbreakable: vec![0] });
    Solid::new(Parts { fracture, ..parts(block, material, formulation(space, law)) }).unwrap()
}

/// Stretches a body by 1 % and disturbs its nodes by parts of the spacing.
fn disturb(body: &mut Solid, random: &mut Random, amplitude: f64) {
    let dimensions = body.block().dimensions;
    displace(body, |x| random.vector(dimensions) * (amplitude * 1e-3) + Vec3::x() * (0.01 * x.x));
}

/// What the body loses is what it says, wherever bonds break in a body under any deformation, and once only.
#[test]
fn energy_before_is_energy_after_and_energy_lost() {
    for (space, law) in ALL {
        for criterion in [BY_STRETCH, BY_WORK] {
            let mut body = body(space, law, criterion);
            let mut random = Random(7);
            let mut broken = 0.0;
            for amplitude in [0.005, 0.01] {
                disturb(&mut body, &mut random, amplitude);
                let before = body.evaluate(AT);
                let lost = body.kick(&STILL).dissipated;
                assert_eq!(body.kick(&STILL).dissipated, 0.0, "bonds broke twice");
                body.evaluate_internal(true);
                let after = body.internal_energy();
                broken += lost;
                let case = format!("{space:?} {law:?} {criterion:?}: {before} {lost} {after}");
                assert!(lost > 1e-2 * before && after > 1e-3 * before, "{case}");
                // Sums of 1e4 terms: 1e-14 of the energy was measured.
                assert!((after + lost - before).abs() < 1e-13 * before, "{case}");
            }
            let by_node: f64 = (0..body.len()).map(|node| body.fracture_energy(node)).sum();
            assert!((by_node - broken).abs() < 1e-13 * broken);
            assert!(body.damage(0) == 0.0 && (0..body.len()).any(|node| body.damage(node) > 0.1));
        }
    }
}

/// Both ends of a bond break in one step: forces still sum to nothing.
#[test]
fn broken_bodies_keep_their_momentum() {
    for (space, law) in ALL {
        let mut body = body(space, law, BY_STRETCH);
        disturb(&mut body, &mut Random(3), 0.01);
        body.evaluate(AT);
        body.kick(&STILL);
        body.evaluate_internal(false);
        let forces = (0..body.len()).map(|node| body.internal_force(node));
        let (sum, size) =
            forces.fold((Vec3::zeros(), 0.0), |(sum, size), force| (sum + force, size + force.norm()));
        // Rounding of sums of 1e4 pulls.
        assert!(sum.norm() < 1e-14 * size, "{space:?} {law:?}: {} of {size}", sum.norm());
    }
}

/// A state taken up by a fresh body is the state: same forces, same breaks, same energies to the bit.
#[test]
fn states_go_on_to_the_same_bits() {
    for (space, law) in ALL {
        for criterion in [BY_STRETCH, BY_WORK] {
            let mut first = body(space, law, criterion);
            disturb(&mut first, &mut Random(5), 0.005);
            first.evaluate(AT);
            first.kick(&STILL);
            let mut second = body(space, law, criterion);
            let broken = first.broken();
            let arrays = [&broken[0][..], &broken[1][..], &broken[2][..]];
            assert!(!broken[0].is_empty() && second.take_up(first.motion(), arrays));
            for each in [&mut first, &mut second] {
                disturb(each, &mut Random(6), 0.01);
                each.evaluate(AT);
                each.kick(&STILL);
                each.evaluate(AT);
            }
            assert!(first.broken() == second.broken() && first.internal_energy() == second.internal_energy());
            for node in 0..first.len() {
                assert_eq!(first.internal_force(node), second.internal_force(node));
                assert_eq!(first.damage(node), second.damage(node));
            }
            // An older state, in which bonds are whole that are broken by now, is refused; so is a shorter one.
            assert!(!second.take_up(first.motion(), arrays));
            assert!(!second.take_up([&[], &[]], arrays));
        }
    }
}

/// Nodes that lost all bonds fly on without a force, even onto each other; the rest counts as fragments.
#[test]
fn free_nodes_do_no_harm() {
    for (space, law) in ALL {
        let mut body = body(space, law, Criterion::Stretch { tension: 0.2, compression: None });
        let (count, bonds) = (body.len(), body.bonds());
        assert_eq!(body.fragments(), [count]);
        let free = count / 2;
        body.put(free, Vec3::new(1.0, 2.0, 0.0));
        body.evaluate(AT);
        body.kick(&STILL);
        assert_eq!(body.damage(free), 1.0);
        body.put(free, body.position(free + 1));
        body.evaluate(AT);
        assert!(body.internal_energy().abs() < 1e-20 && body.internal_force(free) == Vec3::zeros());
        assert_eq!(body.stress(free), nalgebra::Matrix3::zeros());
        assert_eq!((body.fragments().len(), body.bonds()), (2, bonds));
        assert!(body.fragments().contains(&1) && body.fragments().contains(&(count - 1)));
    }
}
