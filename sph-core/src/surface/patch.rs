//! Parametric surfaces: plate, cylinder, sphere, twisted strip, and any closure (u, v) → position.

use libm::{cos, sin};

use crate::Vec3;

/// A surface over a rectangle of parameters.
pub trait Patch {
    /// Point `X(u, v)` `[L]`.
    fn position(&self, u: f64, v: f64) -> Vec3;

    /// Derivatives `∂X/∂u`, `∂X/∂v`.
    fn tangents(&self, u: f64, v: f64) -> (Vec3, Vec3);

    /// Parameter range `[[u0, u1], [v0, v1]]`.
    fn range(&self) -> [[f64; 2]; 2];

    /// Unit normal, along `∂X/∂u × ∂X/∂v`.
    fn normal(&self, u: f64, v: f64) -> Vec3 {
        let (along_u, along_v) = self.tangents(u, v);
        along_u.cross(&along_v).normalize()
    }
}

/// Rectangle in the x–y plane with one corner at the origin and normal +z; `u = x`, `v = y`.
#[derive(Clone, Copy, Debug)]
pub struct Plate {
    /// Lengths along x and y `[L]`.
    pub lengths: [f64; 2],
}

/// Part of a circular cylinder about the y axis: `X = (R sin φ, y, R cos φ)`, `u = φ`, `v = y` from 0 to `length`.
///
/// φ = 0 is the crown at +z; the normal points outward.
#[derive(Clone, Copy, Debug)]
pub struct Cylinder {
    /// Radius `[L]`.
    pub radius: f64,
    /// First and last angle φ in radians.
    pub angles: [f64; 2],
    /// Length along y `[L]`.
    pub length: f64,
}

/// Part of a sphere: `X = R (sin θ cos φ, sin θ sin φ, cos θ)`, `u = θ`, `v = φ`; the normal points outward.
///
/// θ counts from the pole at +z. A range that contains a pole has coincident particles and is refused by the lattice.
#[derive(Clone, Copy, Debug)]
pub struct Sphere {
    /// Radius `[L]`.
    pub radius: f64,
    /// First and last polar angle θ in radians.
    pub polar: [f64; 2],
    /// First and last azimuth φ in radians.
    pub azimuth: [f64; 2],
}

/// Strip twisted about the x axis: `X = (u, v cos α, v sin α)` with `α = twist · u / length`, v from −width/2 to width/2.
///
/// At the root `u = 0` the width runs along +y and the normal is +z; at the tip both are rotated by `twist`. This is a
/// part of the helicoid, and the warped strip of the obstacle course \[macneal1985\].
#[derive(Clone, Copy, Debug)]
pub struct Twisted {
    /// Length along x `[L]`.
    pub length: f64,
    /// Width across `[L]`.
    pub width: f64,
    /// Angle from root to tip in radians, right-handed about +x.
    pub twist: f64,
}

/// Any closure `(u, v) → X`, with tangents by differences.
///
/// The closure is also evaluated up to 0.1 % of the range beyond its ends.
#[derive(Clone, Copy, Debug)]
pub struct Parametric<F> {
    /// Position `[L]` of the parameters.
    pub position: F,
    /// Parameter range `[[u0, u1], [v0, v1]]`.
    pub range: [[f64; 2]; 2],
}

impl Patch for Plate {
    fn position(&self, u: f64, v: f64) -> Vec3 {
        Vec3::new(u, v, 0.0)
    }

    fn tangents(&self, _u: f64, _v: f64) -> (Vec3, Vec3) {
        (Vec3::x(), Vec3::y())
    }

    fn range(&self) -> [[f64; 2]; 2] {
        [[0.0, self.lengths[0]], [0.0, self.lengths[1]]]
    }
}

impl Patch for Cylinder {
    fn position(&self, u: f64, v: f64) -> Vec3 {
        Vec3::new(self.radius * sin(u), v, self.radius * cos(u))
    }

    fn tangents(&self, u: f64, _v: f64) -> (Vec3, Vec3) {
        (self.radius * Vec3::new(cos(u), 0.0, -sin(u)), Vec3::y())
    }

    fn range(&self) -> [[f64; 2]; 2] {
        [self.angles, [0.0, self.length]]
    }

    fn normal(&self, u: f64, _v: f64) -> Vec3 {
        Vec3::new(sin(u), 0.0, cos(u))
    }
}

impl Patch for Sphere {
    fn position(&self, u: f64, v: f64) -> Vec3 {
        self.radius * self.normal(u, v)
    }

    fn tangents(&self, u: f64, v: f64) -> (Vec3, Vec3) {
        let along_polar = Vec3::new(cos(u) * cos(v), cos(u) * sin(v), -sin(u));
        let along_azimuth = sin(u) * Vec3::new(-sin(v), cos(v), 0.0);
        (self.radius * along_polar, self.radius * along_azimuth)
    }

    fn range(&self) -> [[f64; 2]; 2] {
        [self.polar, self.azimuth]
    }

    fn normal(&self, u: f64, v: f64) -> Vec3 {
        Vec3::new(sin(u) * cos(v), sin(u) * sin(v), cos(u))
    }
}

impl Patch for Twisted {
    fn position(&self, u: f64, v: f64) -> Vec3 {
        let angle = self.twist * u / self.length;
        Vec3::new(u, v * cos(angle), v * sin(angle))
    }

    fn tangents(&self, u: f64, v: f64) -> (Vec3, Vec3) {
        let rate = self.twist / self.length;
        let (sine, cosine) = (sin(rate * u), cos(rate * u));
        (Vec3::new(1.0, -v * rate * sine, v * rate * cosine), Vec3::new(0.0, cosine, sine))
    }

    fn range(&self) -> [[f64; 2]; 2] {
        [[0.0, self.length], [-0.5 * self.width, 0.5 * self.width]]
    }
}

impl<F: Fn(f64, f64) -> Vec3> Patch for Parametric<F> {
    fn position(&self, u: f64, v: f64) -> Vec3 {
        (self.position)(u, v)
    }

    /// Central differences of fourth order: `f' ≈ [8(f₁ − f₋₁) − (f₂ − f₋₂)] / 12h`, error near 1e-12 of the range
    /// for smooth surfaces.
    fn tangents(&self, u: f64, v: f64) -> (Vec3, Vec3) {
        let derivative = |range: [f64; 2], at: &dyn Fn(f64) -> Vec3| {
            let h = 5e-4 * (range[1] - range[0]);
            (8.0 * (at(h) - at(-h)) - (at(2.0 * h) - at(-2.0 * h))) / (12.0 * h)
        };
        (
            derivative(self.range[0], &|h| (self.position)(u + h, v)),
            derivative(self.range[1], &|h| (self.position)(u, v + h)),
        )
    }

    fn range(&self) -> [[f64; 2]; 2] {
        self.range
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Every patch against the closure with the same positions: tangents and normals by differences.
    #[test]
    fn tangents_and_normals_are_those_of_the_position() {
        let patches: [&dyn Patch; 4] = [
            &Plate { lengths: [2.0, 3.0] },
            &Cylinder { radius: 2.5, angles: [-0.4, 1.0], length: 3.0 },
            &Sphere { radius: 10.0, polar: [0.3, 1.5], azimuth: [0.0, 1.5] },
            &Twisted { length: 12.0, width: 1.1, twist: 1.6 },
        ];
        for patch in patches {
            let closure = Parametric { position: |u, v| patch.position(u, v), range: patch.range() };
            let [[u0, u1], [v0, v1]] = patch.range();
            for (s, t) in [(0.0, 0.0), (0.3, 0.8), (1.0, 1.0)] {
                let (u, v) = (u0 + s * (u1 - u0), v0 + t * (v1 - v0));
                let (exact, difference) = (patch.tangents(u, v), closure.tangents(u, v));
                assert_relative_eq!(exact.0, difference.0, epsilon = 1e-10);
                assert_relative_eq!(exact.1, difference.1, epsilon = 1e-10);
                assert_relative_eq!(patch.normal(u, v), closure.normal(u, v), epsilon = 1e-10);
            }
        }
    }

    #[test]
    fn the_tip_of_the_strip_is_rotated() {
        let strip = Twisted { length: 12.0, width: 2.0, twist: std::f64::consts::FRAC_PI_2 };
        assert_eq!(strip.position(0.0, 1.0), Vec3::y());
        assert_eq!(strip.normal(0.0, 0.0), Vec3::z());
        assert_relative_eq!(strip.position(12.0, 1.0), Vec3::new(12.0, 0.0, 1.0), epsilon = 1e-15);
        assert_relative_eq!(strip.normal(12.0, 0.0), -Vec3::y(), epsilon = 1e-15);
    }

    #[test]
    fn the_crown_of_the_cylinder_is_at_plus_z() {
        let roof = Cylinder { radius: 2.0, angles: [-0.1, 0.1], length: 1.0 };
        assert_eq!(roof.position(0.0, 0.5), Vec3::new(0.0, 0.5, 2.0));
        assert_eq!(roof.normal(0.0, 0.5), Vec3::z());
    }
}
