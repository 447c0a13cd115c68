//! The strain–rotation decomposition `F = S + R`, and rotations from spins.

use crate::Tensor;
use crate::error::PointError;

/// Rounding that the sine of a right angle may carry.
const ROUNDING: f64 = 1e-12;

/// A deformation as strain and rotation, `I + G = S + R` \[song2018\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StrainRotation {
    /// Symmetric strain S.
    pub strain: Tensor,
    /// Rotation R.
    pub rotation: Tensor,
}

/// Decomposes a displacement gradient G: `R = I + w + a w²`, `S = sym G − a w²` with `w = skew G`, `a = 1/(1 + cos θ)` and
/// `sin θ = |w|`, the root with 0 ≤ θ ≤ π/2.
///
/// Meant for increments: of a whole deformation S depends on the rotation that goes with it.
///
/// # Errors
/// [`PointError::BeyondRightAngle`] where |w| exceeds one.
pub fn decompose(gradient: &Tensor) -> Result<StrainRotation, PointError> {
    let (symmetric, w) = parts(gradient);
    let share = 1.0 / (1.0 + cosine(&w)?);
    let square = w * w * share;
    Ok(StrainRotation { strain: symmetric - square, rotation: Tensor::identity() + w + square })
}

/// Symmetric and skew part.
pub(crate) fn parts(gradient: &Tensor) -> (Tensor, Tensor) {
    let transpose = gradient.transpose();
    ((gradient + transpose) * 0.5, (gradient - transpose) * 0.5)
}

/// cos θ of a spin with |w| = sin θ.
pub(crate) fn cosine(w: &Tensor) -> Result<f64, PointError> {
    let square = spin_product(w, w);
    if square <= 1.0 + ROUNDING {
        return Ok((1.0 - square).max(0.0).sqrt());
    }
    Err(PointError::BeyondRightAngle { sine: square.sqrt() })
}

/// `v₁₂w₁₂ + v₂₃w₂₃ + v₁₃w₁₃`, the scalar product of two spins.
pub(crate) fn spin_product(v: &Tensor, w: &Tensor) -> f64 {
    v[(0, 1)] * w[(0, 1)] + v[(1, 2)] * w[(1, 2)] + v[(0, 2)] * w[(0, 2)]
}

/// Cayley's rotation of a spin: `(I − w/2)⁻¹(I + w/2) = I + (w + w²/2)/(1 + |w|²/4)`, a turn by θ with |w| = 2 tan(θ/2).
pub fn cayley(w: &Tensor) -> Tensor {
    let share = 1.0 / (1.0 + 0.25 * spin_product(w, w));
    Tensor::identity() + (w + w * w * 0.5) * share
}

/// What a spin is multiplied with for Cayley's rotation to turn half as far: `1/(1 + √(1 + |w|²/4))`.
pub fn half_turn(w: &Tensor) -> f64 {
    1.0 / (1.0 + (1.0 + 0.25 * spin_product(w, w)).sqrt())
}

/// Angle by which a rotation turns, 0 … π.
pub fn angle(rotation: &Tensor) -> f64 {
    let (_, w) = parts(rotation);
    libm::atan2(spin_product(&w, &w).sqrt(), 0.5 * (rotation.trace() - 1.0))
}

/// The orthonormal triad next to one that is nearly so: `Q (3 − QᵀQ)/2`, which squares the error.
pub(crate) fn orthonormal(axes: &Tensor) -> Tensor {
    axes * (Tensor::identity() * 1.5 - axes.transpose() * axes * 0.5)
}
