//! Orthonormal frames: two tangents and a normal at a particle or a sampling point.

use nalgebra::Rotation3;

use crate::Vec3;

/// Orthonormal right-handed frame with `n = t1 × t2`; dimensionless.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// First tangent.
    pub t1: Vec3,
    /// Second tangent.
    pub t2: Vec3,
    /// Unit normal.
    pub n: Vec3,
}

impl Frame {
    /// Frame about the normal `n` (any length but zero).
    ///
    /// `t1` is the projection of the x axis, or of the y axis where x is within 26° of the normal, so that plates in
    /// the x–y plane get the frame of the axes.
    pub fn from_normal(n: Vec3) -> Frame {
        let n = n.normalize();
        let axis = if n.x.abs() < 0.9 { Vec3::x() } else { Vec3::y() };
        let t1 = (axis - n * n.dot(&axis)).normalize();
        Frame { t1, t2: n.cross(&t1), n }
    }

    /// Frame with `t1` along `a` and `t2` in the plane of `a` and `b` (Gram–Schmidt); `n` points along `a × b`.
    pub fn from_tangents(a: Vec3, b: Vec3) -> Frame {
        let t1 = a.normalize();
        let n = a.cross(&b).normalize();
        Frame { t1, t2: n.cross(&t1), n }
    }

    /// The frame rotated by `rotation`.
    pub fn rotated(&self, rotation: &Rotation3<f64>) -> Frame {
        Frame { t1: rotation * self.t1, t2: rotation * self.t2, n: rotation * self.n }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn every_frame_is_orthonormal_and_right_handed() {
        let directions = [
            Vec3::new(0.0, 0.0, 2.0),
            Vec3::new(3.0, 0.0, 0.0),
            Vec3::new(0.0, -1.0, 0.0),
            Vec3::new(-0.3, 0.7, 0.2),
            Vec3::new(0.95, 0.1, -0.2),
        ];
        for n in directions {
            let skew = Frame::from_tangents(n, Vec3::new(0.3, -0.2, 0.9));
            for frame in [Frame::from_normal(n), skew] {
                assert_relative_eq!(frame.t1.cross(&frame.t2), frame.n, epsilon = 1e-15);
                assert_relative_eq!(frame.t1.norm(), 1.0, epsilon = 1e-15);
                assert_relative_eq!(frame.t2.norm(), 1.0, epsilon = 1e-15);
            }
            assert_relative_eq!(Frame::from_normal(n).n, n.normalize(), epsilon = 1e-15);
            assert_relative_eq!(skew.t1, n.normalize(), epsilon = 1e-15);
        }
    }

    #[test]
    fn a_plate_gets_the_frame_of_the_axes() {
        let frame = Frame::from_normal(Vec3::z());
        assert_eq!((frame.t1, frame.t2, frame.n), (Vec3::x(), Vec3::y(), Vec3::z()));
    }
}
