//! Flow by von Mises' criterion: the return of a step, its derivative, bars, cycles and what is dissipated.

mod common;

use std::sync::Arc;

use common::{rotation, unit};
use solid_kinematics::*;

const YIELD: f64 = 2e-3;

/// The curves of the tests.
#[derive(Clone, Copy, Debug)]
enum Curve {
    Linear(f64),
    Voce {
        rise: f64,
        rate: f64,
    },
    Swift {
        offset: f64,
        exponent: f64,
    },
    /// Two slopes, the second the steeper, from a strain on.
    Bent([f64; 2], f64),
}

impl YieldCurve for Curve {
    fn at(&self, a: f64) -> [f64; 2] {
        match *self {
            Self::Linear(slope) => [YIELD + slope * a, slope],
            Self::Voce { rise, rate } => {
                let left = rise * libm::exp(-rate * a);
                [YIELD + rise - left, rate * left]
            }
            Self::Swift { offset, exponent } => {
                let stress = YIELD * libm::pow(1.0 + a / offset, exponent);
                [stress, stress * exponent / (offset + a)]
            }
            Self::Bent([first, _], from) if a < from => [YIELD + first * a, first],
            Self::Bent([first, then], from) => [YIELD + first * from + then * (a - from), then],
        }
    }

    fn stored(&self, a: f64) -> f64 {
        match *self {
            Self::Linear(slope) => 0.5 * slope * a * a,
            Self::Voce { rise, rate } => rise * a - rise / rate * (1.0 - libm::exp(-rate * a)),
            Self::Swift { offset, exponent } => {
                let power = exponent + 1.0;
                YIELD * (offset / power * (libm::pow(1.0 + a / offset, power) - 1.0) - a)
            }
            Self::Bent([first, _], from) if a < from => 0.5 * first * a * a,
            Self::Bent([first, then], from) => {
                let beyond = a - from;
                0.5 * first * from * from + first * from * beyond + 0.5 * then * beyond * beyond
            }
        }
    }
}

const CURVES: [Curve; 6] = [
    Curve::Linear(0.0),
    Curve::Linear(0.05),
    Curve::Voce { rise: 1e-3, rate: 200.0 },
    Curve::Swift { offset: 1e-3, exponent: 0.2 },
    Curve::Swift { offset: 1e-7, exponent: 0.2 },
    Curve::Bent([0.01, 0.2], 1e-3),
];

fn material(curve: Curve, kinematic: f64, update: Update) -> Material {
    let formulation = Formulation::StrainRotation { update, measure: StressMeasure::Kirchhoff };
    let plastic = Plastic::new(&unit(), Arc::new(curve), kinematic).expect("isotropic");
    Material { moduli: unit(), formulation, plastic: Some(plastic) }
}

/// Numbers between −1 and 1, the same on every machine.
fn random(count: usize) -> impl Iterator<Item = f64> {
    let mut state = 0x2545_f491_4f6c_dd1d_u64;
    std::iter::repeat_with(move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    })
    .take(count)
}

/// `√(3/2) |dev s − β|`.
fn over(state: &PointState) -> f64 {
    let mean = state.stress[..3].iter().sum::<f64>() / 3.0;
    let of = |i: usize| state.stress[i] - state.flow.back[i] - if i < 3 { mean } else { 0.0 };
    let sum: f64 = (0..6).map(|i| of(i).powi(2) * if i < 3 { 1.0 } else { 2.0 }).sum();
    (1.5 * sum).sqrt()
}

fn gradients(size: f64, count: usize) -> Vec<Tensor> {
    let numbers: Vec<f64> = random(9 * count).collect();
    numbers.chunks(9).map(|nine| Tensor::identity() + Tensor::from_row_slice(nine) * size).collect()
}

/// Stresses come back to the surface; the pressure is that of elasticity, and flow keeps the volume: elastic and plastic strain add up.
#[test]
fn what_flows_stands_on_the_surface() {
    let mut worst: f64 = 0.0;
    for curve in CURVES {
        for kinematic in [0.0, 0.03] {
            let material = material(curve, kinematic, Update::Midpoint);
            let elastic = Material { plastic: None, ..material.clone() };
            for size in [1e-3, 1e-2, 0.1] {
                for gradient in gradients(size, 300) {
                    let rest = PointState::rest(Tensor::identity());
                    let end = material.trial(&rest, &gradient).unwrap().state;
                    let free = elastic.trial(&rest, &gradient).unwrap().state;
                    let trace = |state: &PointState| state.stress[..3].iter().sum::<f64>();
                    assert!((trace(&end) - trace(&free)).abs() < 1e-14, "{curve:?}");
                    if over(&free) <= YIELD {
                        assert_eq!(end, free, "below yield the bits of elasticity");
                    } else {
                        assert!(end.flow.strain > 0.0);
                        worst = worst.max((over(&end) / curve.at(end.flow.strain)[0] - 1.0).abs());
                    }
                }
            }
        }
    }
    println!("residual over the yield stress {worst:e}");
    assert!(worst < 1e-10, "{worst:e}"); // 1e-12 is usual where a step strains by fifty times the yield strain
}

/// The derivative over the step against differences, at points that flow, turn and have flowed before.
#[test]
fn tangents_are_derivatives() {
    const STEP: f64 = 1e-7;
    let (mut worst, mut flowing): (f64, usize) = (0.0, 0);
    for curve in CURVES {
        for (kinematic, update) in
            [(0.0, Update::Midpoint), (0.03, Update::Midpoint), (0.03, Update::StepStart)]
        {
            let material = material(curve, kinematic, update);
            for (before, gradient) in
                gradients(0.01, 12).into_iter().zip(gradients(0.02, 24).into_iter().skip(12))
            {
                let rest = PointState::rest(Tensor::identity());
                let from = material.trial(&rest, &before).unwrap().state;
                let end = rotation([1.0, 2.0, -1.0], 0.1) * gradient;
                let trial = material.trial(&from, &end).unwrap();
                flowing += usize::from(trial.state.flow.strain > from.flow.strain);
                let exact = material.tangent(Tangent::Consistent, &from, &trial).unwrap();
                for column in 0..9 {
                    let at = |sign: f64| {
                        let mut moved = end;
                        moved[(column / 3, column % 3)] += sign * STEP;
                        material.trial(&from, &moved).unwrap().piola
                    };
                    let difference = (at(1.0) - at(-1.0)) / (2.0 * STEP);
                    for row in 0..9 {
                        worst = worst.max((exact[row][column] - difference[(row / 3, row % 3)]).abs());
                    }
                }
            }
        }
    }
    assert!(flowing > 200, "{flowing} of 216 flow");
    println!("tangent against differences, over Young's modulus {worst:e}");
    assert!(worst < 1e-7, "{worst:e}");
}

/// Where a step begins on the surface both derivatives are that of flow that goes on, and symmetric but for the stress.
#[test]
fn a_step_begins_on_the_plastic_side() {
    for curve in [Curve::Linear(0.05), Curve::Voce { rise: 1e-3, rate: 200.0 }] {
        let material = material(curve, 0.0, Update::Midpoint);
        let rest = PointState::rest(Tensor::identity());
        let strained =
            Tensor::identity() + Tensor::new(0.01, 0.002, 0.0, 0.002, -0.004, 0.001, 0.0, 0.001, 0.003);
        let from = material.trial(&rest, &strained).unwrap().state;
        let still = material.trial(&from, &strained).unwrap();
        let [one, other] = [Tangent::Continuum, Tangent::Consistent]
            .map(|kind| material.tangent(kind, &from, &still).unwrap());
        // On goes the strain, by a direction in which it flows: one-sided.
        let on = |size: f64| strained + (strained - Tensor::identity()) * size;
        let way = strained - Tensor::identity();
        let difference = (material.trial(&from, &on(1e-5)).unwrap().piola - still.piola) / 1e-5;
        for row in 0..9 {
            let of =
                |tangent: &PointTangent| (0..9).map(|c| tangent[row][c] * way[(c / 3, c % 3)]).sum::<f64>();
            assert!((of(&one) - of(&other)).abs() < 1e-12, "{curve:?}");
            // Differences of the first order: the curvature of the curve times the step.
            assert!((of(&one) - difference[(row / 3, row % 3)]).abs() < 1e-6, "{curve:?}");
            for column in 0..9 {
                assert!((one[row][column] - one[column][row]).abs() < 1e-14);
            }
        }
    }
}

/// A bar without stress across, its strain by increments: linear hardening of both kinds in closed form, there and back.
#[test]
fn a_bar_is_pulled_and_pushed() {
    let (isotropic, kinematic) = (0.05, 0.03);
    let material = material(Curve::Linear(isotropic), kinematic, Update::Midpoint);
    let mut state = PointState::rest(Tensor::identity());
    let (mut plastic, mut alpha, mut strain, mut worst): (f64, f64, f64, f64) = (0.0, 0.0, 0.0, 0.0);
    let path = (1..=40).map(|i| 4e-4 * f64::from(i)).chain((0..60).map(|i| 0.016 - 4e-4 * f64::from(i)));
    for stretch in path.map(|e| 1.0 + e) {
        // Newton's method on the stretch across.
        let mut across = state.gradient[(1, 1)];
        let mut end = state;
        for _ in 0..30 {
            let of = |across: f64| {
                let gradient = Tensor::from_diagonal(&nalgebra::Vector3::new(stretch, across, across));
                material.trial(&state, &gradient).unwrap().state
            };
            end = of(across);
            let slope = (of(across + 1e-7).stress[1] - of(across - 1e-7).stress[1]) / 2e-7;
            across -= end.stress[1] / slope;
        }
        let from = state.gradient[(0, 0)];
        strain += 2.0 * (stretch - from) / (stretch + from);
        // σ − Hk εp = ±(σy + H α)
        let free = strain - plastic - kinematic * plastic;
        let left = free.abs() - (YIELD + isotropic * alpha);
        if left > 0.0 {
            let growth = left / (1.0 + kinematic + isotropic);
            plastic += growth * free.signum();
            alpha += growth;
        }
        worst = worst.max((end.stress[0] - (strain - plastic)).abs() / YIELD);
        worst = worst.max((end.flow.strain - alpha).abs() / YIELD);
        state = end;
    }
    println!("bar {worst:e}");
    assert!(alpha > 0.02 && worst < 1e-10, "{worst:e}");
}

/// On uneven paths the work of a step is what is stored and `K(0) Δα`, and more by what backward Euler damps, of the second order: energy is
/// never won.
#[test]
fn work_is_stored_or_dissipated() {
    for curve in CURVES {
        for kinematic in [0.0, 0.03] {
            let material = material(curve, kinematic, Update::Midpoint);
            let plastic = material.plastic.as_ref().unwrap();
            let elastic = Material { plastic: None, ..material.clone() };
            let mut state = PointState::rest(Tensor::identity());
            let (mut work, mut lost) = (0.0, 0.0);
            let numbers: Vec<f64> = random(6 * 2000).collect();
            for six in numbers.chunks(6) {
                let way = stress_tensor(&std::array::from_fn(|i| 4e-4 * six[i]));
                let gradient = Tensor::identity() + way * 5.0;
                let end = material.trial(&state, &gradient).unwrap().state;
                let free = elastic.trial(&state, &gradient).unwrap().state.stress;
                let stored = |state: &PointState| {
                    material.moduli.complementary(&state.stress) + plastic.hardened(&state.flow)
                };
                // σ : Δε with Δε = C⁻¹ (σᵗ − σₙ)
                let strained: [f64; 6] = std::array::from_fn(|i| free[i] - state.stress[i]);
                let both: [f64; 6] = std::array::from_fn(|i| end.stress[i] + strained[i]);
                let [both, one, other] =
                    [both, end.stress, strained].map(|s| material.moduli.complementary(&s));
                let done = both - one - other;
                let flowed = plastic.dissipated(&end.flow) - plastic.dissipated(&state.flow);
                let more = done - (stored(&end) - stored(&state)) - flowed;
                assert!(flowed >= 0.0 && more > -1e-9 * YIELD, "{curve:?}: {more:e}");
                (work, lost) = (work + done, lost + flowed);
                state = end;
            }
            assert!(lost > 0.0 && lost < work, "{curve:?} {lost} of {work}");
        }
    }
}

#[test]
fn what_is_no_plastic_material_is_refused() {
    let curve = || Arc::new(Curve::Linear(0.0));
    let refused = Plastic::new(&common::wood(), curve(), 0.0).unwrap_err();
    assert_eq!(refused, ElasticError::Preferred);
    let refused = Plastic::new(&unit(), curve(), -1.0).unwrap_err();
    assert_eq!(
        refused.to_string(),
        "the modulus of kinematic hardening is -1; it must be zero or positive, and finite"
    );
}
