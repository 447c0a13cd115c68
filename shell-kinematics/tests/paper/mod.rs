//! Equations of \[lin2013\] that the shell does not need and its tests hold it against: the natural basis and the Green–Lagrange
//! tensor at a height ζ (eqs. 5–7), Rodrigues' formula (eq. 11) and its tangent map 𝕎 (eq. 10).

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

/// `sin θ/θ`, `(1−cos θ)/θ²`, `(θ−sin θ)/θ³`, by series where the quotients lose digits.
fn coefficients(theta_squared: f64) -> (f64, f64, f64) {
    let t2 = theta_squared;
    // Four terms: the first one left out is θ⁸/9! ≈ 3e-14 of the result at θ = 0.25.
    if t2 < 0.0625 {
        let a = 1.0 - t2 / 6.0 * (1.0 - t2 / 20.0 * (1.0 - t2 / 42.0 * (1.0 - t2 / 72.0)));
        let b = 0.5 - t2 / 24.0 * (1.0 - t2 / 30.0 * (1.0 - t2 / 56.0 * (1.0 - t2 / 90.0)));
        let c = 1.0 / 6.0 - t2 / 120.0 * (1.0 - t2 / 42.0 * (1.0 - t2 / 72.0 * (1.0 - t2 / 110.0)));
        (a, b, c)
    } else {
        let theta = t2.sqrt();
        let (sin, cos) = libm::sincos(theta);
        (sin / theta, (1.0 - cos) / t2, (theta - sin) / (t2 * theta))
    }
}

/// Rotation tensor of the rotation vector `θ`: `R = I + sinθ/θ Ξ + (1−cosθ)/θ² Ξ²` (eq. 11 of \[lin2013\]).
pub fn rodrigues(theta: &Vector3<f64>) -> Matrix3<f64> {
    let (a, b, _) = coefficients(theta.norm_squared());
    let xi = theta.cross_matrix();
    Matrix3::identity() + xi * a + xi * xi * b
}

/// Tangent map `𝕎(θ) = sinθ/θ I + (1−cosθ)/θ² Ξ + (θ−sinθ)/θ³ θ⊗θ` (eq. 10 of \[lin2013\]).
///
/// The paper prints `θ × θ` in the last term, which is zero; the dyadic product is meant (Simo and
/// Fox, \[simo1989\]). `𝕎` carries the rate of the rotation vector to the spatial angular velocity:
/// `ω = 𝕎(θ) θ̇`.
pub fn tangent_map(theta: &Vector3<f64>) -> Matrix3<f64> {
    let (a, b, c) = coefficients(theta.norm_squared());
    Matrix3::identity() * a + theta.cross_matrix() * b + theta * theta.transpose() * c
}
