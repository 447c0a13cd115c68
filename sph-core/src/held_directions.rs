//! Directions along which a point may not move: what they take out of a vector, and what they leave free.

use crate::Vec3;

/// Directions closer than this to the span of others add nothing but rounding.
const SPANNED: f64 = 1e-9;

/// An orthonormal basis of the directions along which a point is held, three at most; of none as it begins.
#[derive(Clone, Copy, Debug, Default)]
pub struct HeldDirections {
    /// Three slots, `count` in use.
    basis: [Vec3; 3],
    count: usize,
}

impl HeldDirections {
    /// Holds all directions.
    pub fn all() -> Self {
        Self { basis: [Vec3::x(), Vec3::y(), Vec3::z()], count: 3 }
    }

    /// Holds a direction more, a unit vector; nothing changes if it depends on those held before.
    pub fn hold(&mut self, direction: &Vec3) {
        let rest = self.basis().iter().fold(*direction, |rest, known| rest - known * known.dot(&rest));
        if self.count < 3 && rest.norm() > SPANNED {
            self.basis[self.count] = rest.normalize();
            self.count += 1;
        }
    }

    /// The held directions, orthonormal.
    #[inline]
    pub fn basis(&self) -> &[Vec3] {
        &self.basis[..self.count]
    }

    /// Takes the held part out of a vector.
    #[inline]
    pub fn free_part(&self, v: [f64; 3]) -> [f64; 3] {
        let mut v = v;
        for n in self.basis() {
            let along = v[0] * n.x + v[1] * n.y + v[2] * n.z;
            for k in 0..3 {
                v[k] -= along * n[k];
            }
        }
        v
    }

    /// Orthonormal directions that are free.
    pub fn free(&self) -> Vec<Vec3> {
        let mut basis = self.basis().to_vec();
        for axis in [Vec3::x(), Vec3::y(), Vec3::z()] {
            let rest = basis.iter().fold(axis, |rest, known| rest - known * known.dot(&rest));
            // At least one axis of three is this far from the span of one or two directions.
            if rest.norm() > 0.5 && basis.len() < 3 {
                basis.push(rest.normalize());
            }
        }
        basis.split_off(self.count)
    }

    /// Moves a place, the first three numbers of a row, along the held directions to where a target has them \[L\].
    pub fn put(&self, target: &Vec3, row: &mut [f64]) {
        for n in self.basis() {
            let missing = n.dot(&(target - Vec3::new(row[0], row[1], row[2])));
            (0..3).for_each(|k| row[k] += missing * n[k]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_held_and_what_is_free_make_up_every_vector() {
        let (one, two) = (Vec3::new(1.0, 2.0, 2.0) / 3.0, Vec3::new(0.0, 0.6, 0.8));
        let mut held = HeldDirections::default();
        let v = Vec3::new(0.3, -1.7, 2.9);
        for (direction, count) in [(one, 1), (one, 1), (two, 2), ((one - two).normalize(), 2)] {
            held.hold(&direction);
            assert_eq!(held.basis().len(), count);
            let basis: Vec<Vec3> = held.basis().iter().copied().chain(held.free()).collect();
            assert_eq!(basis.len(), 3);
            let whole: Vec3 = basis.iter().map(|n| n * n.dot(&v)).sum();
            let free: Vec3 = held.free().iter().map(|n| n * n.dot(&v)).sum();
            // Products of three numbers of order one: a dozen roundings.
            assert!((whole - v).norm() < 1e-14 * v.norm());
            assert!((Vec3::from(held.free_part(v.into())) - free).norm() < 1e-14 * v.norm());
        }
        let mut row = [0.0; 4];
        held.put(&v, &mut row);
        assert!(Vec3::from(held.free_part([row[0], row[1], row[2]])).norm() < 1e-14);
        assert!(
            held.basis()
                .iter()
                .all(|n| (n.dot(&v) - n.dot(&Vec3::new(row[0], row[1], row[2]))).abs() < 1e-14)
        );
        held.hold(&Vec3::x());
        assert!(held.free().is_empty());
        assert!(Vec3::from(held.free_part(v.into())).norm() < 1e-14 * v.norm());
    }
}
