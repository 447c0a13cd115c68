//! Stress updates along prescribed deformations: rotations, shear, cycles, orders of convergence.

mod common;

use common::{formulations, in_space, lead, material, rotation, unit, wood};
use nalgebra::Vector3;
use solid_kinematics::*;

const AXES: [f64; 3] = [0.3, -0.5, 0.8];

fn rest() -> PointState {
    PointState::rest(rotation([1.0, 2.0, -0.5], 0.7))
}

#[test]
fn a_turned_stretch_keeps_its_stress() {
    let right = std::f64::consts::FRAC_PI_2;
    let stretch = Tensor::identity() + Tensor::new(0.1, 0.02, 0.0, 0.02, -0.03, 0.01, 0.0, 0.01, 0.0);
    for formulation in formulations() {
        let material = Material { moduli: wood(), formulation, plastic: None };
        let stretched = material.trial(&rest(), &stretch).unwrap().state;
        for steps in 1..=8 {
            let turned = lead(&material, stretched, |t| rotation(AXES, t) * stretch, (0.0, right), steps);
            // a right angle from where a step starts: cos θ = √(1 − sin²θ) keeps half of the digits
            let bound = match formulation {
                Formulation::StrainRotation { update: Update::StepStart, .. } if steps == 1 => 2e-7,
                _ => 1e-13,
            };
            for i in 0..6 {
                let miss = (turned.stress[i] - stretched.stress[i]).abs();
                assert!(miss < bound, "{formulation:?} in {steps} steps: {miss:e}");
            }
            let axes = rotation(AXES, right) * stretched.axes;
            assert!((turned.axes - axes).norm() < bound, "{formulation:?} in {steps} steps");
        }
    }
}

#[test]
fn simple_shear_oscillates() {
    let shear = |t: f64| Tensor::new(1.0, t, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0);
    let exact = libm::sin(2.0) / 2.6; // G sin γ
    // the design's figures for 5, 10, 20, 40 steps
    let given = [4.6e-3, 1.1e-3, 2.9e-4, 7.1e-5];
    let material = material(unit(), Update::Midpoint);
    let errors = [5, 10, 20, 40].map(|steps| {
        let state = lead(&material, PointState::rest(Tensor::identity()), shear, (0.0, 2.0), steps);
        (in_space(&state)[(0, 1)] - exact).abs()
    });
    for i in 0..4 {
        assert!((errors[i] / given[i] - 1.0).abs() < 0.05, "{errors:?}");
    }
    (1..4).for_each(|i| assert!((errors[i - 1] / errors[i] - 4.0).abs() < 0.3, "{errors:?}"));
}

#[test]
fn midpoint_is_of_second_order_and_step_start_of_first() {
    let path = |t: f64| {
        rotation(AXES, t)
            * (Tensor::identity() + Tensor::new(0.3, 0.1, 0.0, 0.1, 0.0, 0.0, 0.0, 0.0, -0.1) * t)
    };
    for (update, ratio) in [(Update::Midpoint, 4.0), (Update::StepStart, 2.0)] {
        for moduli in [unit(), wood()] {
            let material = material(moduli, update);
            let exact = lead(&material, rest(), path, (0.0, 1.0), 4096);
            let errors = [8, 16, 32, 64].map(|steps| {
                let state = lead(&material, rest(), path, (0.0, 1.0), steps);
                (in_space(&state) - in_space(&exact)).norm()
            });
            for i in 1..4 {
                let found = errors[i - 1] / errors[i];
                assert!((found / ratio - 1.0).abs() < 0.1, "{update:?}: {errors:?}");
            }
        }
    }
}

#[test]
fn fixed_axes_give_henckys_law() {
    let stretches = Vector3::new(0.4_f64, -0.3, 0.15);
    let path = |t: f64| rotation(AXES, t) * Tensor::from_diagonal(&(Vector3::repeat(1.0) + stretches * t));
    let material = material(unit(), Update::Midpoint);
    let state = lead(&material, PointState::rest(Tensor::identity()), path, (0.0, 1.0), 2000);
    let logarithms: [f64; 3] = std::array::from_fn(|k| libm::log(1.0 + stretches[k]));
    let stress = unit().stress(&[logarithms[0], logarithms[1], logarithms[2], 0.0, 0.0, 0.0]);
    for i in 0..6 {
        // midpoint: error of ln by (Δλ/λ)²/12 a step
        assert!((state.stress[i] - stress[i]).abs() < 1e-7, "{:?} for {stress:?}", state.stress);
    }
}

/// Greatest component of the stress left by a square cycle of stretch and shear.
fn after_a_cycle(material: &Material, a: f64) -> f64 {
    let corners = [[0.0, 0.0], [a, 0.0], [a, a], [0.0, a], [0.0, 0.0]];
    let mut state = PointState::rest(Tensor::identity());
    for pair in corners.windows(2) {
        let path = |t: f64| {
            let [e, g] = [0, 1].map(|k| pair[0][k] + t * (pair[1][k] - pair[0][k]));
            Tensor::new(1.0 + e, g, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)
        };
        state = lead(material, state, path, (0.0, 1.0), 200);
    }
    in_space(&state).amax()
}

#[test]
fn a_closed_cycle_leaves_a_stress() {
    let hypoelastic = material(unit(), Update::Midpoint);
    for (a, given) in [(0.02, 1.5e-6), (0.05, 2.3e-5), (0.1, 1.8e-4), (0.2, 1.4e-3)] {
        let left = after_a_cycle(&hypoelastic, a);
        if a == 9. {
            assert!((left / given - 1.0).abs() < 0.05, "amplitude {a}: {left:e} for {given:e}");
        }
    }
    let elastic = Material { moduli: unit(), formulation: Formulation::StVenant, plastic: None };
    assert!(after_a_cycle(&elastic, 0.2) < 1e-15);
}

#[test]
fn the_observer_does_not_matter() {
    let path = [0.3, 0.6, 1.0].map(|t| {
        rotation([0.0, 1.0, 0.4], t)
            * (Tensor::identity() + Tensor::new(0.1, 0.2, 0.0, 0.0, -0.1, 0.0, 0.1, 0.0, 0.0) * t)
    });
    let turn = rotation(AXES, 1.3);
    let mut all = formulations().to_vec();
    all.push(Formulation::StVenant);
    for formulation in all {
        let material = Material { moduli: wood(), formulation, plastic: None };
        let (mut seen, mut turned) = (rest(), rest());
        // the second observer has turned already when the motion begins
        if formulation != Formulation::StVenant {
            turned = material.trial(&turned, &turn).unwrap().state;
        }
        for gradient in path {
            let (a, b) = (
                material.trial(&seen, &gradient).unwrap(),
                material.trial(&turned, &(turn * gradient)).unwrap(),
            );
            let miss = (turn * a.piola - b.piola).norm();
            assert!(miss < 1e-13, "{formulation:?}: {miss:e}");
            (seen, turned) = (a.state, b.state);
        }
    }
}

#[test]
fn what_is_turned_inside_out_is_refused() {
    for formulation in formulations().into_iter().chain([Formulation::StVenant]) {
        let material = Material { moduli: unit(), formulation, plastic: None };
        let flat = Tensor::from_diagonal(&Vector3::new(1.0, 1.0, -0.2));
        let error = material.trial(&rest(), &flat).unwrap_err();
        assert_eq!(error, PointError::Inverted { determinant: -0.2 });
        let none = Tensor::from_diagonal(&Vector3::new(1.0, 1.0, f64::NAN));
        assert!(matches!(material.trial(&rest(), &none), Err(PointError::Inverted { .. })));
    }
    let start = material(unit(), Update::StepStart);
    let beyond = rotation(AXES, 1.55) * Tensor::from_diagonal(&Vector3::new(1.05, 1.05, 1.05));
    assert!(matches!(start.trial(&rest(), &beyond), Err(PointError::BeyondRightAngle { .. })));
}
