//! Rotations of groups: triads, turned vectors, and the tensors of directors and arms.

use nalgebra::Matrix3;
use sph_core::{Vec3, rotated};

/// `1 − d dᵀ`.
pub(crate) fn across(d: &Vec3) -> Matrix3<f64> {
    Matrix3::identity() - d * d.transpose()
}

/// `|a|² 1 − a aᵀ`.
pub(crate) fn of_arm(a: &Vec3) -> Matrix3<f64> {
    Matrix3::identity() * a.norm_squared() - a * a.transpose()
}

/// Right-handed unit vectors, the first along d, the second in the plane of d and e.
pub(crate) fn triad(d: &Vec3, e: &Vec3) -> Matrix3<f64> {
    let third = d.cross(e).normalize();
    Matrix3::from_columns(&[*d, third.cross(d), third])
}

/// `exp(θ) Q`, its columns made unit vectors.
pub(crate) fn turned(triad: &Matrix3<f64>, theta: &Vec3) -> Matrix3<f64> {
    let column = |i: usize| rotated(&triad.column(i).into(), theta).normalize();
    Matrix3::from_columns(&[column(0), column(1), column(2)])
}
