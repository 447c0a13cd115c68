//! A director on the unit sphere: its tangent axes, and how it moves along a great circle.

use nalgebra::Vector3;

/// A unit director with a tangent axis; the second axis is their cross product.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Director {
    /// The director d.
    pub normal: Vector3<f64>,
    /// The first tangent axis t₁.
    pub first: Vector3<f64>,
}

impl Director {
    /// A director whose tangent axes are chosen freely.
    pub fn new(normal: Vector3<f64>) -> Self {
        let smallest = normal.iamin();
        let mut axis = Vector3::zeros();
        axis[smallest] = 1.0;
        Self { normal, first: (axis - normal * normal[smallest]).normalize() }
    }

    /// A director in the plane with unit normal `across`: moving along t₁ it stays there.
    pub fn in_plane(normal: Vector3<f64>, across: Vector3<f64>) -> Self {
        Self { normal, first: across.cross(&normal) }
    }

    /// The tangent axes t₁, t₂ = d × t₁.
    pub fn axes(&self) -> [Vector3<f64>; 2] {
        [self.first, self.normal.cross(&self.first)]
    }

    /// Moves by θ₁t₁ + θ₂t₂ \[rad\] along the great circle; the axes are carried in parallel.
    ///
    /// d → cos θ d + sin θ w/θ. Along it the second derivative is −d, which is what the tangent stiffness owes to the
    /// sphere.
    pub fn turn(&mut self, increments: [f64; 2]) {
        let [first, second] = self.axes();
        let step = first * increments[0] + second * increments[1];
        let angle = step.norm();
        if angle == 0.0 {
            return;
        }
        let (c, s) = (libm::cos(angle), libm::sin(angle));
        let direction = step / angle;
        let carried = direction * c - self.normal * s;
        self.first += (carried - direction) * self.first.dot(&direction);
        self.normal = (self.normal * c + direction * s).normalize();
        self.first = (self.first - self.normal * self.first.dot(&self.normal)).normalize();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use std::f64::consts::PI;

    #[test]
    fn half_a_great_circle_ends_at_the_antipode() {
        let mut director = Director::new(Vector3::new(0.6, 0.0, 0.8));
        for _ in 0..10 {
            director.turn([0.06 * PI, 0.08 * PI]);
        }
        assert_relative_eq!(director.normal, Vector3::new(-0.6, 0.0, -0.8), epsilon = 1e-14);
        assert_relative_eq!(director.first.dot(&director.normal), 0.0, epsilon = 1e-15);
    }

    #[test]
    fn a_director_held_in_a_plane_keeps_the_plane_as_its_second_axis() {
        let across = Vector3::new(0.0, 0.6, 0.8);
        let mut director = Director::in_plane(Vector3::x(), across);
        director.turn([0.7, 0.0]);
        director.turn([1.1, 0.0]);
        assert_relative_eq!(director.axes()[1], across, epsilon = 1e-15);
        assert_relative_eq!(director.normal.x, libm::cos(1.8), epsilon = 1e-15);
    }
}
