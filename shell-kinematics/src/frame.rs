//! The paper's three-dimensional view of a shell point: natural basis and Green–Lagrange tensor at a height ζ.
//!
//! The solver never needs it (the split into membrane and bending is exact to first order in ζ); it
//! is here because eqs. 5–7 of \[lin2013\] start from it, and the tests hold the split against it.

use nalgebra::{Matrix3, Vector3};

/// Columns `a1 = x,1 + ζ d,1`, `a2 = x,2 + ζ d,2`, `a3 = d` (eq. 7 of \[lin2013\]), for vectors
/// `[x,1, x,2, d, d,1, d,2]` and height `zeta` \[L\].
pub fn natural_basis(vectors: &[Vector3<f64>; 5], zeta: f64) -> Matrix3<f64> {
    let [x1, x2, d, d1, d2] = vectors;
    Matrix3::from_columns(&[x1 + d1 * zeta, x2 + d2 * zeta, *d])
}

/// Covariant components `½ (a_i·a_j − A_i·A_j)` of the Green–Lagrange tensor at height `zeta`.
pub fn covariant_green_lagrange(
    current: &[Vector3<f64>; 5],
    reference: &[Vector3<f64>; 5],
    zeta: f64,
) -> Matrix3<f64> {
    let a = natural_basis(current, zeta);
    let a0 = natural_basis(reference, zeta);
    (a.transpose() * a - a0.transpose() * a0) * 0.5
}

/// The tensor in the local orthonormal frame: `ℂᵀ E_c ℂ`, `ℂ = 𝔽⁻¹ℚ`, `ℚ = [t1 t2 n]` (after eq. 7 of \[lin2013\]).
///
/// `None` where the natural basis is singular, that is where ζ reaches a radius of curvature.
pub fn local_green_lagrange(
    current: &[Vector3<f64>; 5],
    reference: &[Vector3<f64>; 5],
    zeta: f64,
    frame: &[Vector3<f64>; 3],
) -> Option<Matrix3<f64>> {
    let c = natural_basis(reference, zeta).try_inverse()? * Matrix3::from_columns(frame);
    Some(c.transpose() * covariant_green_lagrange(current, reference, zeta) * c)
}
