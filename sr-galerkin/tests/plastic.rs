//! A body that yields: its derivatives, its bits, what is kept of it, its energies.

mod bodies;

use std::sync::Arc;

use bodies::derivatives::{stressed, the_tangent_derives_from_forces};
use bodies::{block, body, curve, newton, nodes};
use implicit_statics::Equilibrium;
use shell_kinematics::Hardening;
use solid_kinematics::{Formulation, Plastic, Tangent};
use sph_core::{Support, Vec3};
use sr_galerkin::{Condition, Galerkin, GalerkinError, Hardened, Load, Parts, Volumes, lead};

/// Makes a body yield.
fn yields(parts: &mut Parts, hardening: Hardening, kinematic: f64) {
    let curve = Arc::new(Hardened(hardening));
    parts.material.plastic = Some(Plastic::new(&parts.material.moduli, curve, kinematic).expect("plastic"));
    parts.volumes = Volumes::Mean;
}

fn curves(yield_stress: f64) -> [Hardening; 4] {
    [
        Hardening::linear(yield_stress, 0.05),
        Hardening::voce(yield_stress, 0.5 * yield_stress, 50.0),
        Hardening::swift(3.0 * yield_stress, 4e-3, 0.2),
        Hardening::table(&[[0.0, yield_stress], [0.02, 1.2 * yield_stress], [0.5, 2.0 * yield_stress]]),
    ]
    .map(|curve| curve.expect("a curve"))
}

#[test]
fn tangents_are_derivatives_of_the_forces() {
    for hardening in curves(1e-3) {
        let mut parts = block([2.0, 1.0, 1.0], [4, 3, 3], 0.1);
        parts.support = Support::ellipsoid([1.8, 1.35, 1.35]);
        parts.tangent = Tangent::Consistent;
        parts.conditions.extend(Condition::fixed(&nodes(&parts, |x| x.x == 0.0)));
        parts.loads.push(Load::Pressure { faces: parts.cells.faces[5].clone(), pressure: 0.05 });
        let name = format!("{hardening:?}");
        yields(&mut parts, hardening, 0.02);
        the_tangent_derives_from_forces(&name, &mut stressed(parts), 7);
    }
}

/// A beam whose end is moved aside and pulled: it bends, shears and yields.
fn beam(hardening: Hardening) -> Parts {
    let mut parts = block([4.0, 1.0, 1.0], [7, 3, 3], 0.0);
    yields(&mut parts, hardening, 0.01);
    parts.conditions.extend(Condition::fixed(&nodes(&parts, |x| x.x == 0.0)));
    let end = nodes(&parts, |x| x.x == 4.0);
    parts.conditions.push(Condition { nodes: end, direction: Vec3::new(0.2, 0.0, 1.0), by: 0.4 });
    parts
}

/// Forces, tangent and energy, over two steps that are committed; iterates differ, for the tangent of a body that flows is made anew a step.
#[test]
fn below_yield_the_bits_are_those_of_elasticity() {
    let of = |plastic: bool| {
        let mut parts = beam(Hardening::linear(1e3, 1.0).expect("a curve"));
        if !plastic {
            parts.material.plastic = None;
        }
        let mut body = body(parts);
        let motion: Vec<f64> = (0..body.unknowns()).map(|i| 1e-2 * libm::sin(i as f64)).collect();
        let (mut forces, mut stiffness) = (vec![0.0; motion.len()], vec![0.0; body.pattern().len()]);
        let mut bits = Vec::new();
        for _ in 0..2 {
            body.update(&motion);
            body.internal(1.0, &mut forces);
            body.tangent(1.0, &mut stiffness);
            body.commit();
            bits.extend(forces.iter().chain(&stiffness).map(|x| x.to_bits()));
        }
        (bits, body.energy().to_bits())
    };
    let (plastic, elastic) = (of(true), of(false));
    assert!(plastic == elastic && plastic.0.iter().any(|&bits| f64::from_bits(bits) != 0.0));
}

const LEVELS: [f64; 5] = [0.2, 0.4, 0.6, 0.5, 0.4];

fn bits(body: &Galerkin) -> Vec<u64> {
    body.save().iter().map(|x| x.to_bits()).collect()
}

#[test]
fn threads_do_not_change_a_bit() {
    let of = |threads: usize| {
        let mut parts = beam(curves(5e-3)[1].clone());
        parts.threads = threads;
        let mut body = body(parts);
        curve(&mut body, &LEVELS, |_| 0.0);
        assert!(body.flowed().iter().any(|[alpha, _]| *alpha > 0.01));
        bits(&body)
    };
    let one = of(1);
    assert!(one == of(2) && one == of(3));
}

/// The work of the end, there and back, is what the body holds: stored or dissipated, which never falls.
#[test]
fn work_is_stored_or_dissipated() {
    let steps = 40;
    let mut body = body(beam(curves(5e-3)[0].clone()));
    let (mut solver, mut from, mut force, mut work, mut lost) = (newton(&body), 0.0, 0.0, 0.0, 0.0);
    for step in 1..=steps {
        let level = if step <= 30 { f64::from(step) / 30.0 } else { 1.0 - f64::from(step - 30) / 60.0 };
        lead(&mut body, &mut solver, (from, level), |_, _| {}).expect("equilibrium");
        let now = *body.reactions(level).last().expect("the end");
        work += 0.5 * (force + now) * 0.4 * (level - from);
        let dissipated: f64 = body.flowed().iter().map(|[_, work]| work).sum();
        assert!(dissipated >= lost, "{step}: {dissipated} after {lost}");
        (from, force, lost) = (level, now, dissipated);
    }
    let held = body.energy();
    println!("work {work}, held {held}, dissipated {lost}: {:e}", work / held - 1.0);
    assert!(lost > 0.3 * held && (work / held - 1.0).abs() < 1e-3, "{work} {held} {lost}");
}

#[test]
fn flow_without_increments_is_refused() {
    let mut parts = beam(curves(1.0)[0].clone());
    parts.material.formulation = Formulation::StVenant;
    let refused = Galerkin::new(parts).err().expect("refused");
    assert_eq!(refused, GalerkinError::FlowWithoutSteps);
}
