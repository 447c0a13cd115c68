//! The cantilever under uniform load, K = 1 … 10, against the prototype's figures, beam theory and Holden's curve.
//!
//! Reference curves are the columns of `holden-cantilever`: Holden's elastica, and a beam with shear and stretch loaded on its axis and
//! on its upper face. The prototype's figures have five digits; half of the last with Newton's tolerance makes 1e-5, thrice that is
//! accepted.

mod bodies;

use bodies::{MIDPOINT, On, STEP_START, as_in_the_source, body, cantilever, curve, newton, tip};
use implicit_statics::{Equilibrium, OneSolve};
use nalgebra::DVector;
use solid_kinematics::Formulation;
use sr_galerkin::{Essential, Parts, lead};

/// Where figures are given.
const GIVEN: [f64; 6] = [1.0, 2.0, 4.0, 6.0, 8.0, 10.0];
const HOLDEN: [f64; 6] = [0.123471, 0.238507, 0.425159, 0.553924, 0.640631, 0.700200];
const BEAM_AXIS: [f64; 6] = [0.124634, 0.240725, 0.429041, 0.559061, 0.646868, 0.707498];
const BEAM_TOP: [f64; 6] = [0.127012, 0.249315, 0.452769, 0.592645, 0.684259, 0.745066];
const REGRESSION: f64 = 3e-5;

/// Tip deflections in steps of K = 1/part each.
fn figures(parts: Parts, part: usize) -> [f64; 6] {
    let mut body = body(parts);
    let levels: Vec<f64> = (1..=10 * part).map(|step| step as f64 / part as f64).collect();
    let (values, _) = curve(&mut body, &levels, tip);
    GIVEN.map(|k| values[part * k as usize - 1])
}

fn quadratic(on: On, formulation: Formulation) -> Parts {
    let mut parts = cantilever(21, 10.0, on);
    parts.material.formulation = formulation;
    parts
}

fn linear(on: On, formulation: Formulation) -> Parts {
    let mut parts = quadratic(on, formulation);
    as_in_the_source(&mut parts, 12.7);
    parts
}

/// Greatest deviation from a curve, relative to it.
fn off(found: &[f64; 6], curve: &[f64; 6]) -> f64 {
    found.iter().zip(curve).map(|(a, b)| (a / b - 1.0).abs()).fold(0.0, f64::max)
}

fn assert_near(found: &[f64; 6], given: &[f64; 6], bound: f64) {
    for (a, b) in found.iter().zip(given) {
        assert!((a - b).abs() < bound, "{found:.5?} for {given:?}");
    }
}

#[test]
fn loaded_on_its_upper_face() {
    let increments = figures(quadratic(On::Top, MIDPOINT), 1);
    assert_near(&increments, &[0.12582, 0.24743, 0.45169, 0.59377, 0.68738, 0.74960], REGRESSION);
    assert!(off(&increments, &BEAM_TOP) < 0.012, "{increments:.5?}"); // measured .9 %, at K = 1: stiff by the mesh
    let total = figures(quadratic(On::Top, Formulation::StVenant), 1);
    assert_near(&total, &[0.12602, 0.24766, 0.45117, 0.59195, 0.68432, 0.74558], REGRESSION);
    assert!(off(&increments, &total) < 0.007); // measured .54 %: the laws differ by the order of the strain, 18 %
}

#[test]
fn loaded_through_its_volume() {
    let increments = figures(quadratic(On::Volume, MIDPOINT), 1);
    assert_near(&increments, &[0.12339, 0.23875, 0.42755, 0.55937, 0.64899, 0.71106], REGRESSION);
    assert!(off(&increments, &BEAM_AXIS) < 0.012);
    assert!(off(&increments, &HOLDEN) < 0.018); // shear alone makes .9 %
    let total = figures(quadratic(On::Volume, Formulation::StVenant), 1);
    assert_near(&total, &[0.12357, 0.23894, 0.42707, 0.55774, 0.64623, 0.70736], REGRESSION);
    assert!(off(&increments, &total) < 0.007);
}

#[test]
fn with_the_basis_of_the_source() {
    let whole = figures(linear(On::Top, MIDPOINT), 1);
    assert_near(&whole, &[0.12500, 0.24595, 0.44968, 0.59196, 0.68595, 0.74851], REGRESSION);
    assert!(off(&whole, &BEAM_TOP) < 0.018); // measured 1.6 % at K = 1
    let halved = figures(linear(On::Top, MIDPOINT), 2);
    let change = off(&halved, &whole);
    assert!(change < 0.0015 && change > 1e-5, "halved steps change {change:e}");
    // the decomposition to the letter, ten steps
    let letter = figures(linear(On::Top, STEP_START), 1);
    assert!((letter[5] - 0.74829).abs() < REGRESSION, "{letter:.5?}");
    // fixed parameters are no fixed displacements: the clamped face leaks
    let mut parts = linear(On::Top, MIDPOINT);
    parts.essential = Essential::Direct;
    let direct = figures(parts, 1);
    let more = off(&direct, &whole);
    assert!((0.009..0.02).contains(&more), "{more}: {direct:.5?}"); // the design measured .9 to 2 %
}

#[test]
fn half_as_thick_it_is_holdens() {
    let given = [(0, 0.12266), (2, 0.42295), (5, 0.69840)];
    let found = figures(cantilever(21, 20.0, On::Volume), 1);
    for (at, value) in given {
        assert!((found[at] - value).abs() < REGRESSION, "{found:.5?}");
    }
    assert!(off(&found, &HOLDEN) < 0.007, "{found:.5?}");
}

#[test]
fn a_pressure_that_follows() {
    let elastica = [0.124444, 0.245592, 0.466023, 0.641986, 0.763510, 0.830148];
    let found = figures(linear(On::Follower, MIDPOINT), 1);
    for (at, given) in [(0, 0.12385), (2, 0.46844), (3, 0.64938), (5, 0.84154)] {
        assert!((found[at] - given).abs() < 2e-4, "{found:.5?}");
    }
    assert!(off(&found, &elastica) < 0.03);
}

#[test]
fn newton_is_quadratic_with_the_whole_load_stiffness() {
    let mut parts = cantilever(7, 10.0, On::Follower);
    parts.rule = 2;
    let mut body = body(parts);
    let n = body.unknowns();
    let (mut internal, mut external) = (vec![0.0; n], vec![0.0; n]);
    let (mut exact, mut symmetric) = (Vec::new(), Vec::new());
    for (residuals, whole) in [(&mut exact, true), (&mut symmetric, false)] {
        let rest = body.save();
        for _ in 0..12 {
            body.internal(2.0, &mut internal);
            body.external(2.0, &mut external);
            let residual = DVector::from_fn(n, |i, _| external[i] - internal[i]);
            residuals.push(residual.norm() / DVector::from_column_slice(&external).norm());
            let mut tangent = body.exact_tangent(2.0);
            if !whole {
                tangent = (&tangent + tangent.transpose()) * 0.5;
            }
            body.update(tangent.lu().solve(&residual).unwrap().as_slice());
        }
        body.restore(&rest);
    }
    let quadratic =
        |r: &[f64]| r.windows(3).filter(|r| r[0] < 0.1 && r[1] > 1e-7).all(|r| r[2] < libm::pow(r[1], 1.5));
    assert!(quadratic(&exact) && exact[9] < 1e-10, "{exact:?}");
    assert!(!quadratic(&symmetric), "{symmetric:?}");
}

/// The source's scheme, one solve a step, against what the prototype measured with it: at K = 1 after 2 and 10 steps, where the
/// converged value is .1250, and at K = 10 after 100 steps, .7488 (20 steps give .7478 here, .7421 there).
#[test]
fn one_solve_a_step_as_in_the_source() {
    let run = |per_unit: usize, last: usize| {
        let mut body = body(linear(On::Top, MIDPOINT));
        let mut scheme = OneSolve::new(&body).unwrap();
        let level = |step: usize| step as f64 / per_unit as f64;
        for step in 1..=last * per_unit {
            let left = scheme.step(&mut body, (level(step - 1), level(step))).unwrap();
            assert!(left > 1e-9, "balance is not iterated for, {left:e} is left");
        }
        tip(&body)
    };
    let found = [run(2, 1), run(10, 1), run(10, 10)];
    for (found, given) in found.iter().zip([0.0779, 0.1233, 0.7488]) {
        assert!((found - given).abs() < 1e-4, "{found:.5} for {given}"); // figures of four digits
    }
}

/// A very slender body in one large step: the symmetric tangent of the rate equation does not converge.
#[test]
fn a_step_that_fails_is_made_again_with_the_consistent_tangent() {
    let mut body = body(cantilever(21, 80.0, On::Volume));
    let mut newton = newton(&body);
    let mut steps = Vec::new();
    lead(&mut body, &mut newton, (0.0, 4.0), |step, _| steps.push(step.clone())).unwrap();
    let tries: Vec<_> = steps.iter().map(|step| (step.failures, step.insisted)).collect();
    assert_eq!(tries, [(1, true)]);
    // one step to K = 4 lowers the deflection: measured 5 %, that of 21 columns .9 %
    assert!((tip(&body) / HOLDEN[2] - 1.0).abs() < 0.08, "{}", tip(&body));
}
