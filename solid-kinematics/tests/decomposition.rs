//! The strain–rotation decomposition and Cayley's rotations.

mod common;

use common::rotation;
use proptest::prelude::*;
use solid_kinematics::*;

fn tensor(limit: f64) -> impl Strategy<Value = Tensor> {
    proptest::collection::vec(-limit..limit, 9).prop_map(|v| Tensor::from_row_slice(&v))
}

proptest! {
    #[test]
    fn deformations_are_strain_and_rotation(gradient in tensor(0.5)) {
        let StrainRotation { strain, rotation } = decompose(&gradient).unwrap();
        let sum = strain + rotation;
        prop_assert!((sum - Tensor::identity() - gradient).norm() < 1e-14);
        prop_assert!((strain - strain.transpose()).norm() < 1e-15);
        prop_assert!((rotation.transpose() * rotation - Tensor::identity()).norm() < 1e-14);
    }

    #[test]
    fn rotations_have_no_strain(x in -1.0..1.0, y in -1.0..1.0, z in 0.1..1.0, turn in 0.0..1.57) {
        let turned = rotation([x, y, z], turn);
        let found = decompose(&(turned - Tensor::identity())).unwrap();
        // near a right angle cos θ = √(1 − sin²θ) loses digits: 1.57 keeps nine
        prop_assert!(found.strain.norm() < 1e-12, "{:e}", found.strain.norm());
        prop_assert!((angle(&turned) - turn).abs() < 1e-12);
    }

    #[test]
    fn half_a_cayley_turn_done_twice_is_the_whole(x in -1.0..1.0_f64, y in -1.0..1.0_f64, z in -1.0..1.0_f64) {
        let w = Tensor::new(0.0, -z, y, z, 0.0, -x, -y, x, 0.0);
        let half = cayley(&(w * half_turn(&w)));
        prop_assert!((half * half - cayley(&w)).norm() < 1e-14);
        let closed = (Tensor::identity() - w * 0.5).try_inverse().unwrap() * (Tensor::identity() + w * 0.5);
        prop_assert!((cayley(&w) - closed).norm() < 1e-14);
    }
}

#[test]
fn strain_of_a_whole_deformation_depends_on_its_rotation() {
    // Greatest eigenvalue of S for a stretch of 2 % turned by 0, 30, 60 and 80°, the design's figures.
    for (degrees, expected) in [(0.0, 0.0200), (30.0, 0.0216), (60.0, 0.0303), (80.0, 0.0821)] {
        let stretch = Tensor::from_diagonal(&nalgebra::Vector3::new(1.02, 1.0, 1.0));
        let turned = rotation([0.0, 0.0, 1.0], f64::to_radians(degrees)) * stretch;
        let strain = decompose(&(turned - Tensor::identity())).unwrap().strain;
        let greatest = strain.symmetric_eigenvalues().max();
        assert!((greatest - expected).abs() < 5e-5, "{degrees}°: {greatest}"); // half of the last digit given
    }
}

#[test]
fn beyond_a_right_angle_is_refused() {
    let stretch = Tensor::from_diagonal(&nalgebra::Vector3::new(1.02, 1.0, 1.0));
    let turned = rotation([0.0, 0.0, 1.0], 1.55) * stretch;
    let error = decompose(&(turned - Tensor::identity())).unwrap_err();
    assert!(matches!(error, PointError::BeyondRightAngle { sine } if sine > 1.0 && sine < 1.02), "{error}");
    assert!(error.to_string().contains("sin θ = 1.00"), "{error}");
}
