//! Graded spacing: a patch whose parameters run in geometric progression.

use libm::{expm1, log};

use crate::Vec3;
use crate::error::SpaceError;
use crate::surface::patch::Patch;

/// Greatest ratio of last to first spacing that is accepted, and the inverse of the least.
const GREATEST_RATIO: f64 = 1e3;

/// A patch re-parametrised so that a lattice of `counts` particles on it has spacings in geometric progression along u
/// and v; the surface is the same.
///
/// With `Q` the ratio from end to end, the old parameter is `(Qˢ − 1)/(Q − 1)` of its range where the new one is `s`.
/// Give it to [`jittered_lattice`](crate::jittered_lattice): areas from cells add up to that of the surface, which end
/// weights × Jacobian do only to second order.
#[derive(Clone, Copy)]
pub struct Graded<'a> {
    patch: &'a dyn Patch,
    /// `ln Q` along u and v.
    growth: [f64; 2],
}

impl<'a> Graded<'a> {
    /// `patch` with the last over the first spacing of a row of `counts` particles equal to `ratios`, each from 1/1000 to
    /// 1000; 1 is uniform.
    pub fn new(patch: &'a dyn Patch, counts: [usize; 2], ratios: [f64; 2]) -> Result<Self, SpaceError> {
        let mut growth = [0.0; 2];
        for ((growth, ratio), n) in growth.iter_mut().zip(ratios).zip(counts) {
            if !(1.0 / GREATEST_RATIO..=GREATEST_RATIO).contains(&ratio) {
                let bound = "[0.001, 1000]";
                return Err(SpaceError::OutOfRange { what: "grading", value: ratio, bound });
            }
            // n − 1 spacings grow n − 2 times; two particles have one spacing and no progression.
            if n > 2 {
                *growth = log(ratio) * (n - 1) as f64 / (n - 2) as f64;
            }
        }
        Ok(Self { patch, growth })
    }

    /// The old parameter of direction `i` at `s`, and its derivative.
    fn parameter(&self, i: usize, s: f64) -> (f64, f64) {
        let ([first, last], g) = (self.patch.range()[i], self.growth[i]);
        if g == 0.0 || s == first || s == last {
            // Ends are kept to the last bit: they are edges.
            let slope =
                if g == 0.0 { 1.0 } else { g / expm1(g) * if s == last { expm1(g) + 1.0 } else { 1.0 } };
            return (s, slope);
        }
        let part = g * (s - first) / (last - first);
        (first + (last - first) * expm1(part) / expm1(g), g * (expm1(part) + 1.0) / expm1(g))
    }
}

impl Patch for Graded<'_> {
    fn position(&self, u: f64, v: f64) -> Vec3 {
        self.patch.position(self.parameter(0, u).0, self.parameter(1, v).0)
    }

    fn tangents(&self, u: f64, v: f64) -> (Vec3, Vec3) {
        let ((u, slope_u), (v, slope_v)) = (self.parameter(0, u), self.parameter(1, v));
        let (along_u, along_v) = self.patch.tangents(u, v);
        (along_u * slope_u, along_v * slope_v)
    }

    fn range(&self) -> [[f64; 2]; 2] {
        self.patch.range()
    }

    fn normal(&self, u: f64, v: f64) -> Vec3 {
        self.patch.normal(self.parameter(0, u).0, self.parameter(1, v).0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::jitter::jittered_lattice;
    use crate::surface::patch::{Cylinder, Parametric, Plate};
    use crate::surface::sides::Side;
    use approx::assert_relative_eq;

    #[test]
    fn spacings_grow_by_one_factor_from_first_to_last() {
        let plate = Plate { lengths: [2.0, 1.0] };
        let graded = Graded::new(&plate, [11, 6], [10.0, 0.2]).unwrap();
        let cloud = jittered_lattice(&graded, [11, 6], 0.0, 0).unwrap();
        let sides = cloud.sides.as_ref().unwrap();
        for (side, ratio, end) in [(Side::V0, 10.0, 2.0), (Side::U0, 0.2, 1.0)] {
            let place = |a: &u32| cloud.positions[*a as usize].norm();
            let row: Vec<f64> = sides.edge(side).iter().map(place).collect();
            let gaps: Vec<f64> = row.windows(2).map(|w| w[1] - w[0]).collect();
            assert_relative_eq!(gaps[gaps.len() - 1] / gaps[0], ratio, max_relative = 1e-12);
            for pair in gaps.windows(3) {
                assert_relative_eq!(pair[1] * pair[1], pair[0] * pair[2], max_relative = 1e-12);
            }
            assert_eq!(row[row.len() - 1], end);
        }
        assert_relative_eq!(cloud.areas.iter().sum::<f64>(), 2.0, max_relative = 1e-13);
    }

    #[test]
    fn tangents_are_those_of_the_position() {
        let roof = Cylinder { radius: 2.0, angles: [0.1, 1.2], length: 3.0 };
        let graded = Graded::new(&roof, [9, 2], [0.1, 5.0]).unwrap();
        let closure = Parametric { position: |u, v| graded.position(u, v), range: graded.range() };
        for (u, v) in [(0.1, 0.0), (0.4, 1.0), (1.2, 3.0)] {
            let (exact, difference) = (graded.tangents(u, v), closure.tangents(u, v));
            assert_relative_eq!(exact.0, difference.0, epsilon = 1e-8);
            assert_relative_eq!(exact.1, difference.1, epsilon = 1e-8);
            assert_relative_eq!(graded.normal(u, v), closure.normal(u, v), epsilon = 1e-8);
        }
        assert!(matches!(Graded::new(&roof, [9, 9], [0.0, 1.0]), Err(SpaceError::OutOfRange { .. })));
    }
}
