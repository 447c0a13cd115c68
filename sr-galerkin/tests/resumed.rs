//! A march that is taken up again from what was saved ends in the same bits as one that never stopped.

mod bodies;

use std::ops::ControlFlow;
use std::sync::Arc;

use bodies::{MIDPOINT, STEP_START, block, nodes};
use implicit_statics::{Control, CriticalOptions, Equilibrium, Newton, NewtonOptions, PathOptions, Start};
use shell_kinematics::Hardening;
use solid_kinematics::{Formulation, Plastic, Tangent};
use sph_core::Vec3;
use sr_galerkin::{Condition, Galerkin, Hardened, Load, Parts, Volumes};

/// A beam of length 10 and side 1, clamped at x = 0, bent by a load and by an end that is moved.
fn beam(formulation: Formulation, tangent: Tangent, follows: bool) -> Parts {
    let mut parts = block([10.0, 1.0, 1.0], [6, 3, 3], 0.1);
    parts.material.formulation = formulation;
    parts.tangent = tangent;
    parts.conditions.extend(Condition::fixed(&nodes(&parts, |x| x.x == 0.0)));
    let top = parts.cells.faces[5].clone();
    if follows {
        parts.loads.push(Load::Pressure { faces: top, pressure: 4e-4 });
    } else {
        let end = nodes(&parts, |x| x.x == 10.0);
        parts.conditions.push(Condition { nodes: end, direction: Vec3::new(0.0, 1.0, 0.0), by: 1.0 });
        parts.loads.push(Load::Traction { faces: top, traction: Vec3::new(0.0, 0.0, -4e-4) });
    }
    parts
}

fn options(from: f64, to: f64, iterations: usize) -> PathOptions {
    let mut options = PathOptions::new(Control::Load { step: to - from, until: to });
    options.newton = NewtonOptions { line_search: false, iterations, ..NewtonOptions::default() };
    options.critical = Some(CriticalOptions::default());
    options
}

/// One level after the other, by one solver or by one of its own each from what is saved; all states on the way.
fn march(parts: &impl Fn() -> Parts, iterations: usize, resumed: bool) -> Vec<Vec<u64>> {
    let mut body = Galerkin::new(parts()).expect("a body");
    let newton = |body: &Galerkin| Newton::new(body, &options(0.0, 1.0, iterations).newton).expect("options");
    let (mut solver, mut start) = (newton(&body), Start::default());
    let mut out = Vec::new();
    for level in 1..=4 {
        if resumed {
            let saved = body.save();
            body = Galerkin::new(parts()).expect("a body");
            body.restore(&saved);
            solver = newton(&body);
        }
        let (from, to) = (0.25 * f64::from(level - 1), 0.25 * f64::from(level));
        let path = solver
            .follow(&mut body, &start, &options(from, to, iterations), |_, _| ControlFlow::Continue(()));
        assert!(path.end.is_ok(), "{:?}", path.end);
        start = path.restart;
        out.push(body.save().iter().map(|x| x.to_bits()).collect());
    }
    out
}

#[test]
fn a_march_goes_on_from_what_was_saved_to_the_same_bits() {
    for formulation in [MIDPOINT, STEP_START, Formulation::StVenant] {
        for tangent in [Tangent::Continuum, Tangent::Consistent] {
            for follows in [false, true] {
                let parts = || beam(formulation, tangent, follows);
                let [whole, parted] = [false, true].map(|resumed| march(&parts, 30, resumed));
                for (level, (one, other)) in whole.iter().zip(&parted).enumerate() {
                    let worst =
                        one.iter().zip(other).map(|(a, b)| (f64::from_bits(*a) - f64::from_bits(*b)).abs());
                    let worst = worst.fold(0.0, f64::max);
                    assert!(one == other, "{formulation:?} {tangent:?} {follows} level {level}: {worst:e}");
                }
            }
        }
    }
}

/// So few iterations that steps are halved and made again with the consistent tangent.
#[test]
fn steps_that_were_halved_go_on_to_the_same_bits() {
    let parts = || beam(MIDPOINT, Tangent::Continuum, false);
    let [whole, parted] = [false, true].map(|resumed| march(&parts, 4, resumed));
    assert!(whole == parted);
}

/// Plastic strain and back stress are part of what is saved.
#[test]
fn a_body_that_yields_goes_on_to_the_same_bits() {
    let parts = || {
        let mut parts = beam(MIDPOINT, Tangent::Continuum, false);
        let curve = Arc::new(Hardened(Hardening::voce(5e-3, 2e-3, 50.0).expect("a curve")));
        parts.material.plastic = Some(Plastic::new(&parts.material.moduli, curve, 0.01).expect("plastic"));
        parts.volumes = Volumes::Mean;
        parts
    };
    let [whole, parted] = [false, true].map(|resumed| march(&parts, 30, resumed));
    assert!(whole == parted);
    let mut body = Galerkin::new(parts()).expect("a body");
    let last: Vec<f64> = whole[3].iter().map(|&bits| f64::from_bits(bits)).collect();
    body.restore(&last);
    assert!(body.flowed().iter().any(|[alpha, _]| *alpha > 1e-3), "it flows");
}
