//! A vector turned by a rotation vector.

use crate::Vec3;

/// `exp(θ) v` by Rodrigues' formula, θ a rotation vector \[rad\]; the length of v stays to rounding for any θ.
pub fn rotated(v: &Vec3, theta: &Vec3) -> Vec3 {
    let square = theta.norm_squared();
    if square == 0.0 {
        return *v;
    }
    let angle = square.sqrt();
    let (sin, _) = libm::sincos(angle);
    // 1 − cos without cancellation.
    let half = libm::sin(0.5 * angle);
    let turn = theta.cross(v);
    v + turn * (sin / angle) + theta.cross(&turn) * (2.0 * half * half / square)
}
