//! Derivatives of the stress against differences, and the source's four-term stiffness.

mod common;

use common::{formulations, rotation, wood};
use solid_kinematics::*;

/// Two deformations a step apart, with strains of a tenth and turns of a third.
fn step() -> (Tensor, Tensor) {
    let first = Tensor::identity() + Tensor::new(0.1, 0.05, 0.0, -0.04, -0.06, 0.02, 0.03, 0.0, 0.08);
    let second = Tensor::identity() + Tensor::new(0.02, 0.1, -0.03, 0.04, 0.0, 0.05, 0.0, 0.06, -0.05);
    (rotation([1.0, 0.5, -0.3], 0.4) * first, rotation([0.8, 0.9, -0.1], 0.7) * second)
}

fn stressed(material: &Material, gradient: &Tensor) -> PointState {
    let rest = PointState::rest(rotation([1.0, 2.0, -0.5], 0.7));
    material.trial(&rest, gradient).expect("accepted").state
}

/// Greatest difference of a tangent from central differences, relative to the greatest entry.
fn miss(material: &Material, from: &PointState, gradient: &Tensor, kind: Tangent) -> f64 {
    let trial = material.trial(from, gradient).expect("accepted");
    let tangent = material.tangent(kind, from, &trial).expect("accepted");
    let step = 1e-5;
    let (mut most, mut scale): (f64, f64) = (0.0, 0.0);
    for column in 0..9 {
        let mut way = Tensor::zeros();
        way[(column / 3, column % 3)] = step;
        let piola = |g: Tensor| material.trial(from, &g).expect("accepted").piola;
        let difference = (piola(gradient + way) - piola(gradient - way)) / (2.0 * step);
        for row in 0..9 {
            most = most.max((tangent[row][column] - difference[(row / 3, row % 3)]).abs());
            scale = scale.max(tangent[row][column].abs());
        }
    }
    most / scale
}

#[test]
fn tangents_are_derivatives() {
    let (before, after) = step();
    // differences: third derivatives of order one times step² = 1e-10, rounding 1e-16/1e-5
    let exact = 1e-9;
    for formulation in formulations() {
        let material = Material { moduli: wood(), formulation, plastic: None };
        let from = stressed(&material, &before);
        for kind in [Tangent::Continuum, Tangent::Consistent] {
            let found = miss(&material, &from, &before, kind);
            assert!(found < exact, "{formulation:?} where a step begins, {kind:?}: {found:e}");
        }
        let found = miss(&material, &from, &after, Tangent::Consistent);
        assert!(found < exact, "{formulation:?} over a step: {found:e}");
        // the rate equation is off by the order of the step, here .4; if it were exact this test would see nothing
        let found = miss(&material, &from, &after, Tangent::Continuum);
        assert!(found > 1e-3 && found < 0.5, "{formulation:?} over a step, of the rate equation: {found:e}");
    }
    let material = Material { moduli: wood(), formulation: Formulation::StVenant, plastic: None };
    let from = stressed(&material, &before);
    let found = miss(&material, &from, &after, Tangent::Continuum);
    assert!(found < exact, "St Venant: {found:e}");
}

#[test]
fn st_venants_stress_is_the_derivative_of_its_energy() {
    let material = Material { moduli: wood(), formulation: Formulation::StVenant, plastic: None };
    let (before, after) = step();
    let from = stressed(&material, &before);
    let piola = material.trial(&from, &after).unwrap().piola;
    let energy = |g: Tensor| material.energy(&material.trial(&from, &g).unwrap().state);
    let step = 1e-5;
    for entry in 0..9 {
        let mut way = Tensor::zeros();
        way[(entry / 3, entry % 3)] = step;
        let difference = (energy(after + way) - energy(after - way)) / (2.0 * step);
        assert!((piola[(entry / 3, entry % 3)] - difference).abs() < 1e-9);
    }
    // the energy that stresses would release is the same number
    let state = material.trial(&from, &after).unwrap().state;
    let released = material.moduli.complementary(&state.stress);
    assert!((released / material.energy(&state) - 1.0).abs() < 1e-13);
}

/// B^s and B^r of one gradient of a shape function.
fn differential(n: [f64; 3]) -> ([[f64; 3]; 6], [[f64; 3]; 3]) {
    let [a, b, c] = n;
    let strain = [[a, 0.0, 0.0], [0.0, b, 0.0], [0.0, 0.0, c], [b, a, 0.0], [0.0, c, b], [c, 0.0, a]];
    let spin = [[b, -a, 0.0], [0.0, c, -b], [c, 0.0, -a]];
    (strain, spin)
}

/// σ1, σ2, σ3.
type StressMatrices = ([[f64; 6]; 6], [[f64; 3]; 3], [[f64; 3]; 6]);

/// The source's σ1, σ2, σ3 (its equations 57–59, with the sign of row 5, column 1 of the last put right).
fn stress_matrices(s: &[f64; 6]) -> StressMatrices {
    let [s11, s22, s33, s12, s23, s13] = *s;
    let (h12, h23, h13) = (s12 / 2.0, s23 / 2.0, s13 / 2.0);
    let (q12, q23, q13) = (s12 / 4.0, s23 / 4.0, s13 / 4.0);
    let first = [
        [s11, 0.0, 0.0, h12, 0.0, h13],
        [0.0, s22, 0.0, h12, h23, 0.0],
        [0.0, 0.0, s33, 0.0, h23, h13],
        [h12, h12, 0.0, (s11 + s22) / 4.0, q13, q23],
        [0.0, h23, h23, q13, (s22 + s33) / 4.0, q12],
        [h13, 0.0, h13, q23, q12, (s11 + s33) / 4.0],
    ];
    let second = [[s11 + s22, -s13, s23], [-s13, s22 + s33, s12], [s23, s12, s11 + s33]];
    let third = [
        [-h12, 0.0, -h13],
        [h12, -h23, 0.0],
        [0.0, h23, h13],
        [(s11 - s22) / 4.0, -q13, -q23],
        [q13, (s22 - s33) / 4.0, q12],
        [-q23, q12, (s11 - s33) / 4.0],
    ];
    (first, second.map(|row| row.map(|x| -x / 4.0)), third)
}

#[test]
fn four_terms_make_the_compact_form() {
    let stress = [0.7, -0.4, 0.3, 0.25, -0.6, 0.15];
    let moduli = wood();
    let turned = moduli.turned(&Tensor::identity());
    let (first, second, third) = stress_matrices(&stress);
    // the stress that these strains give, so that the material is in that state where its step begins
    let compliance = |i: usize| {
        let mut unit = [0.0; 6];
        unit[i] = 1.0;
        (0..6)
            .map(|j| {
                let mut other = [0.0; 6];
                other[j] = 1.0;
                let both: [f64; 6] = std::array::from_fn(|k| unit[k] + other[k]);
                let mixed =
                    moduli.complementary(&both) - moduli.complementary(&unit) - moduli.complementary(&other);
                mixed * stress[j]
            })
            .sum::<f64>()
    };
    let strain: [f64; 6] = std::array::from_fn(compliance);
    assert!(moduli.stress(&strain).iter().zip(stress).all(|(a, b)| (a - b).abs() < 1e-13));
    let state = PointState { stress, ..PointState::rest(Tensor::identity()) };
    let formulation =
        Formulation::StrainRotation { update: Update::Midpoint, measure: StressMeasure::Kirchhoff };
    let material = Material { moduli, formulation, plastic: None };
    let trial = material.trial(&state, &Tensor::identity()).unwrap();
    let tangent = material.tangent(Tangent::Continuum, &state, &trial).unwrap();
    let (n, m) = ([0.3, -1.1, 0.8], [-0.5, 0.2, 1.3]);
    let ((bs, br), (cs, cr)) = (differential(n), differential(m));
    for i in 0..3 {
        for k in 0..3 {
            let mut four = 0.0;
            for p in 0..6 {
                for q in 0..6 {
                    four += bs[p][i] * (turned[p][q] - first[p][q]) * cs[q][k];
                }
                for q in 0..3 {
                    four -= bs[p][i] * third[p][q] * cr[q][k] + br[q][i] * third[p][q] * cs[p][k];
                }
            }
            for p in 0..3 {
                for q in 0..3 {
                    four -= br[p][i] * second[p][q] * cr[q][k];
                }
            }
            let mut compact = 0.0;
            for j in 0..3 {
                for l in 0..3 {
                    compact += n[j] * tangent[3 * i + j][3 * k + l] * m[l];
                }
            }
            assert!((four - compact).abs() < 1e-13, "{i}{k}: {four} against {compact}");
        }
    }
    for row in 0..9 {
        for column in 0..9 {
            assert!((tangent[row][column] - tangent[column][row]).abs() < 1e-14);
        }
    }
}
