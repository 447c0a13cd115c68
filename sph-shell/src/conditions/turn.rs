//! The turn of a position about an axis through a point.

use sph_core::Vec3;

use crate::conditions::case::LoadCase;

/// The turn of a position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn {
    /// Axis, a unit vector.
    pub axis: Vec3,
    /// A point of the axis \[L\].
    pub point: Vec3,
    /// Angle at load level one and amplitude one \[rad\].
    pub angle: f64,
    /// The load case to which it belongs.
    pub case: LoadCase,
}

impl Turn {
    /// Displacement of a particle with a position at rest after a part of the angle \[L\].
    pub(crate) fn displacement(&self, rest: &Vec3, part: f64) -> Vec3 {
        let arm = rest - self.point;
        rotated(&self.axis, self.angle * part, &arm) - arm
    }

    /// Its derivative with respect to that part \[L\].
    pub(crate) fn rate(&self, rest: &Vec3, part: f64) -> Vec3 {
        self.axis.cross(&rotated(&self.axis, self.angle * part, &(rest - self.point))) * self.angle
    }

    /// Two directions in which a particle goes on the way \[L\].
    pub(crate) fn ways(&self, rest: &Vec3) -> [Vec3; 2] {
        let tangent = self.axis.cross(&(rest - self.point));
        [tangent, self.axis.cross(&tangent)]
    }
}

/// A vector turned about a unit axis, by Rodrigues' formula.
pub(crate) fn rotated(k: &Vec3, angle: f64, v: &Vec3) -> Vec3 {
    let (sin, cos) = libm::sincos(angle);
    v * cos + k.cross(v) * sin + k * (k.dot(v) * (1.0 - cos))
}
