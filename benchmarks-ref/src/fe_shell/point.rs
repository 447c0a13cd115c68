//! Strains and energy of one point from its measures: the bending strain with the stretch taken out.

use super::section::Stiffness;
use nalgebra::{SMatrix, SVector, Vector3};

/// Measures of a point in its local axes: E₁₁ E₂₂ 2E₁₂, then k₁₁ k₁₂ k₂₁ k₂₂, then γ₁ γ₂.
///
/// E is the (assumed) Green–Lagrange strain of the mid-surface, k_ab = a_a·d,_b \[1/L\] the director's derivatives seen
/// from the mid-surface's, γ_b = a_b·d the (assumed) transverse shear less its reference value.
pub type Measures = SVector<f64, 9>;

/// A quadratic form in the measures.
pub type Curvature = SMatrix<f64, 9, 9>;

/// The strains of the section: ε, κ, γ as in [`Stiffness`].
type Strains = SVector<f64, 8>;

/// The resultants of the section, conjugate to them \[F/L\], \[F\].
pub type Resultants = SVector<f64, 8>;

/// κ_ab = sym(k_ab − E_ac k_cb) − B_ab, with γ and ε as they stand.
///
/// The director's change per reference length is seen from the rotated, unstretched mid-surface:
/// a_a U⁻¹ with U⁻¹ = (1 + 2E)^(−1/2) = 1 − E + O(E²). Under an end couple a strip then neither stretches nor softens:
/// with κ = λ(3 − λ²)/2 · θ′ one has ∂κ/∂λ = 0 at λ = 1, so the energy is least at λ = 1 and M = EI θ′ for every
/// thickness, whereas sym(k) − B gives λ² = 1 − (θ′t)²/6 and a moment 1 − (θ′t)²/6 of it. For a curved shell that is
/// stretched without turning, κ vanishes to first order, as it does for the true rotation gradient.
fn strains(z: &Measures, reference: &Vector3<f64>) -> Strains {
    let (e11, e22, e12) = (z[0], z[1], 0.5 * z[2]);
    let (k11, k12, k21, k22) = (z[3], z[4], z[5], z[6]);
    Strains::from([
        z[0],
        z[1],
        z[2],
        k11 - (e11 * k11 + e12 * k21) - reference[0],
        k22 - (e12 * k12 + e22 * k22) - reference[1],
        k12 + k21 - (e11 * k12 + e12 * (k11 + k22) + e22 * k21) - reference[2],
        z[7],
        z[8],
    ])
}

/// ∂(strains)/∂(measures).
fn derivative(z: &Measures) -> SMatrix<f64, 8, 9> {
    let (e11, e22, e12) = (z[0], z[1], 0.5 * z[2]);
    let (k11, k12, k21, k22) = (z[3], z[4], z[5], z[6]);
    let mut d = SMatrix::<f64, 8, 9>::zeros();
    (d[(0, 0)], d[(1, 1)], d[(2, 2)], d[(6, 7)], d[(7, 8)]) = (1.0, 1.0, 1.0, 1.0, 1.0);
    (d[(3, 0)], d[(3, 2)], d[(3, 3)], d[(3, 5)]) = (-k11, -0.5 * k21, 1.0 - e11, -e12);
    (d[(4, 1)], d[(4, 2)], d[(4, 4)], d[(4, 6)]) = (-k22, -0.5 * k12, -e12, 1.0 - e22);
    (d[(5, 0)], d[(5, 1)], d[(5, 2)]) = (-k12, -k21, -0.5 * (k11 + k22));
    (d[(5, 3)], d[(5, 4)], d[(5, 5)], d[(5, 6)]) = (-e12, 1.0 - e11, 1.0 - e22, -e12);
    d
}

/// Pairs of measures whose product enters a bending strain: (E, k, bending strain, factor).
const PRODUCTS: [(usize, usize, usize, f64); 8] = [
    (0, 3, 3, -1.0),
    (2, 5, 3, -0.5),
    (2, 4, 4, -0.5),
    (1, 6, 4, -1.0),
    (0, 4, 5, -1.0),
    (2, 3, 5, -0.5),
    (2, 6, 5, -0.5),
    (1, 5, 5, -1.0),
];

/// Energy per reference area \[F/L\]; `reference` holds B₁₁ B₂₂ 2B₁₂ \[1/L\].
pub fn energy(z: &Measures, reference: &Vector3<f64>, stiffness: &Stiffness) -> f64 {
    let strain = strains(z, reference);
    0.5 * strain.dot(&(stiffness * strain))
}

/// The section's resultants.
pub fn resultants(z: &Measures, reference: &Vector3<f64>, stiffness: &Stiffness) -> Resultants {
    stiffness * strains(z, reference)
}

/// The resultants that a change of the measures leads to by first order.
pub fn predicted(
    z: &Measures,
    change: &Measures,
    reference: &Vector3<f64>,
    stiffness: &Stiffness,
) -> Resultants {
    stiffness * (strains(z, reference) + derivative(z) * change)
}

/// ∂(energy)/∂(measures) from the resultants.
pub fn gradient(z: &Measures, resultants: &Resultants) -> Measures {
    derivative(z).tr_mul(resultants)
}

/// Second derivatives of the energy for given resultants.
pub fn hessian(z: &Measures, resultants: &Resultants, stiffness: &Stiffness) -> Curvature {
    let derivative = derivative(z);
    let mut second = derivative.transpose() * (stiffness * derivative);
    for (membrane, bending, strain, factor) in PRODUCTS {
        let value = factor * resultants[strain];
        second[(membrane, bending)] += value;
        second[(bending, membrane)] += value;
    }
    second
}

#[cfg(test)]
mod tests {
    use super::super::section::{Orthotropic, Ply, Section};
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn derivatives_agree_with_differences() {
        let material = Orthotropic {
            along: 30.0,
            across: 10.0,
            poisson: 0.25,
            shear: 6.0,
            shear_across: 4.0,
            density: 1.0,
        };
        let plies = [Ply { thickness: 0.4, angle: 0.3 }, Ply { thickness: 0.6, angle: 1.1 }];
        let stiffness = Section::layered(&material, &plies).stiffness;
        let z = Measures::from([0.1, -0.2, 0.15, 0.7, -0.3, 0.2, 0.5, 0.05, -0.1]);
        let reference = Vector3::new(0.1, -0.2, 0.3);
        let gradient = |z: &Measures| gradient(z, &resultants(z, &reference, &stiffness));
        let first = gradient(&z);
        let second = hessian(&z, &resultants(&z, &reference, &stiffness), &stiffness);
        let step = 1e-6;
        for i in 0..9 {
            let mut sides = [z, z];
            sides[0][i] -= step;
            sides[1][i] += step;
            let [low, high] = sides.map(|z| energy(&z, &reference, &stiffness));
            assert_relative_eq!((high - low) / (2.0 * step), first[i], epsilon = 1e-8);
            let [low, high] = sides.map(|z| gradient(&z));
            let column = (high - low) / (2.0 * step);
            assert_relative_eq!(column, second.column(i).into_owned(), epsilon = 1e-7);
        }
    }

    #[test]
    fn a_couple_does_not_stretch_a_thick_strip() {
        let (thickness, turn) = (1.0, 0.6);
        let stiffness = Section::isotropic(12.0, 0.0, thickness, 1.0).stiffness;
        let mut z = Measures::zeros();
        z[3] = turn;
        let force = gradient(&z, &resultants(&z, &Vector3::zeros(), &stiffness));
        // λ enters through E = (λ² − 1)/2 and k = λθ′: dU/dλ = λ ∂U/∂E + θ′ ∂U/∂k at λ = 1
        assert_relative_eq!(force[0] + turn * force[3], 0.0, epsilon = 1e-14);
        assert_relative_eq!(force[3], turn, epsilon = 1e-14);
    }
}
