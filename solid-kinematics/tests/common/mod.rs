//! Points, rotations and paths that the tests share.

#![allow(dead_code)] // no test uses all of it

use solid_kinematics::*;

/// A rotation by an angle about an axis.
pub fn rotation(axis: [f64; 3], angle: f64) -> Tensor {
    let length = axis.iter().map(|x| x * x).sum::<f64>().sqrt();
    let [x, y, z] = axis.map(|a| a / length);
    let w = Tensor::new(0.0, -z, y, z, 0.0, -x, -y, x, 0.0);
    Tensor::identity() + w * libm::sin(angle) + w * w * (1.0 - libm::cos(angle))
}

/// Moduli E = 1, ν = 0.3.
pub fn unit() -> Moduli {
    Moduli::isotropic(1.0, 0.3).expect("accepted")
}

/// A material with three different axes.
pub fn wood() -> Moduli {
    let of = Orthotropic { young: [3.0, 1.0, 0.7], poisson: [0.3, 0.2, 0.35], shear: [0.5, 0.3, 0.4] };
    Moduli::orthotropic(&of).expect("accepted")
}

/// The updates with both measures.
pub fn formulations() -> [Formulation; 4] {
    let of = |update, measure| Formulation::StrainRotation { update, measure };
    [
        of(Update::Midpoint, StressMeasure::Kirchhoff),
        of(Update::Midpoint, StressMeasure::Literal),
        of(Update::StepStart, StressMeasure::Kirchhoff),
        of(Update::StepStart, StressMeasure::Literal),
    ]
}

/// A material of Kirchhoff's stress.
pub fn material(moduli: Moduli, update: Update) -> Material {
    let formulation = Formulation::StrainRotation { update, measure: StressMeasure::Kirchhoff };
    Material { moduli, formulation, plastic: None }
}

/// Leads a point along a path `t → F` in equal steps over t from `span.0` to `span.1`.
pub fn lead(
    material: &Material,
    mut state: PointState,
    path: impl Fn(f64) -> Tensor,
    span: (f64, f64),
    steps: usize,
) -> PointState {
    for step in 1..=steps {
        let t = span.0 + (span.1 - span.0) * step as f64 / steps as f64;
        state = material.trial(&state, &path(t)).expect("accepted").state;
    }
    state
}

/// Cauchy's or Kirchhoff's stress in space of the co-rotated one.
pub fn in_space(state: &PointState) -> Tensor {
    state.axes * stress_tensor(&state.stress) * state.axes.transpose()
}
