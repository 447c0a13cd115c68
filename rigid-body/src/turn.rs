//! Turns as unit quaternions, and the exponential of a rotation vector.

use nalgebra::{Matrix3, Quaternion, UnitQuaternion};
use sph_core::Vec3;

/// A turn from the principal axes of a body into space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Turn(Quaternion<f64>);

impl Turn {
    /// Of right-handed orthonormal columns.
    pub fn of_axes(axes: &Matrix3<f64>) -> Self {
        let m = |i: usize, j: usize| axes[(i, j)];
        // The largest of the four squares 4q² is at least one: no small number is divided by.
        let squares = [
            1.0 + m(0, 0) + m(1, 1) + m(2, 2),
            1.0 + m(0, 0) - m(1, 1) - m(2, 2),
            1.0 - m(0, 0) + m(1, 1) - m(2, 2),
            1.0 - m(0, 0) - m(1, 1) + m(2, 2),
        ];
        let largest = (0..4).fold(0, |best, k| if squares[k] > squares[best] { k } else { best });
        let (w, [x, y, z]) = match largest {
            0 => (squares[0], [m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1)]),
            1 => (m(2, 1) - m(1, 2), [squares[1], m(0, 1) + m(1, 0), m(0, 2) + m(2, 0)]),
            2 => (m(0, 2) - m(2, 0), [m(0, 1) + m(1, 0), squares[2], m(1, 2) + m(2, 1)]),
            _ => (m(1, 0) - m(0, 1), [m(0, 2) + m(2, 0), m(1, 2) + m(2, 1), squares[3]]),
        };
        Self::unit(Quaternion::new(w, x, y, z))
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

/// `exp(θ) v` by Rodrigues' formula.
pub(crate) fn rotated(v: &Vec3, theta: &Vec3) -> Vec3 {
    let square = theta.norm_squared();
    if square == 0.0 {
        return *v;
    }
    let angle = square.sqrt();
    // 1 − cos without cancellation.
    let half = libm::sin(0.5 * angle);
    let across = theta.cross(v);
    v + across * (libm::sin(angle) / angle) + theta.cross(&across) * (2.0 * half * half / square)
}

#[cfg(test)]
mod tests {
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
