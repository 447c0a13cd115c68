//! Turns as unit quaternions.

use nalgebra::{Matrix3, Quaternion, Rotation3, UnitQuaternion};
use sph_core::Vec3;

/// A turn from the principal axes of a body into space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Turn(Quaternion<f64>);

impl Turn {
    /// Of right-handed orthonormal columns.
    pub fn of_axes(axes: &Matrix3<f64>) -> Self {
        let of = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(*axes));
        Self::unit(of.into_inner())
    }

    /// Of four numbers that [`Turn::numbers`] gave.
    pub fn of_numbers([w, x, y, z]: [f64; 4]) -> Self {
        Self(Quaternion::new(w, x, y, z))
    }

    /// Its numbers.
    pub fn numbers(&self) -> [f64; 4] {
        [self.0.w, self.0.i, self.0.j, self.0.k]
    }

    /// `exp(θ) Q` of a rotation vector in space \[rad\].
    pub fn turned(&self, theta: &Vec3) -> Self {
        Self::unit(exponential(theta) * self.0)
    }

    /// `Q exp(θ)` of a rotation vector in the principal axes \[rad\].
    pub fn turned_about_own(&self, theta: &Vec3) -> Self {
        Self::unit(self.0 * exponential(theta))
    }

    /// Principal axes in space, as columns.
    pub fn axes(&self) -> Matrix3<f64> {
        UnitQuaternion::new_unchecked(self.0).to_rotation_matrix().into_inner()
    }

    fn unit(q: Quaternion<f64>) -> Self {
        Self(q / q.norm_squared().sqrt())
    }
}

/// `exp(½θ)`.
fn exponential(theta: &Vec3) -> Quaternion<f64> {
    let angle = theta.norm();
    if angle == 0.0 {
        return Quaternion::new(1.0, 0.0, 0.0, 0.0);
    }
    let (sin, cos) = libm::sincos(0.5 * angle);
    let v = theta * (sin / angle);
    Quaternion::new(cos, v.x, v.y, v.z)
}

#[cfg(test)]
mod tests {
    use sph_core::rotated;

    use super::*;

    #[test]
    fn a_turn_has_the_axes_it_was_made_of_and_turns_as_rodrigues_says() {
        let theta = Vec3::new(0.3, -1.9, 2.2);
        let axes = Matrix3::from_columns(&[Vec3::x(), Vec3::y(), Vec3::z()].map(|e| rotated(&e, &theta)));
        for k in 0..4 {
            let half =
                Vec3::new(f64::from(k == 1), f64::from(k == 2), f64::from(k == 3)) * std::f64::consts::PI;
            let turned = Matrix3::from_columns(&[0, 1, 2].map(|i| rotated(&axes.column(i).into(), &half)));
            let turn = Turn::of_axes(&turned);
            assert!((turn.axes() - turned).norm() < 1e-14, "{k}");
            let own = Turn::of_axes(&axes).turned(&half).axes();
            assert!((own - turned).norm() < 1e-14, "{k}");
        }
        let start = Turn::of_axes(&axes);
        let about_own = start.turned_about_own(&axes.tr_mul(&theta));
        assert!((about_own.axes() - start.turned(&theta).axes()).norm() < 1e-14);
    }
}
