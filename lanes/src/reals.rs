//! Four numbers with the operators of one, and vectors of them.

use std::ops::{Add, AddAssign, Div, Mul, Sub};

use crate::{Lanes, Pack};

/// Four real numbers in a register.
#[derive(Clone, Copy)]
pub struct Reals<L: Lanes> {
    /// What computes with them.
    pub lanes: L,
    /// The register.
    pub four: L::Four,
}

impl<L: Lanes> Reals<L> {
    /// `√a`.
    #[inline(always)]
    pub fn sqrt(self) -> Self {
        Self { four: self.lanes.sqrt(self.four), ..self }
    }

    /// The greater; the other where one is not a number.
    #[inline(always)]
    pub fn max(self, other: Self) -> Self {
        Self { four: self.lanes.max(self.four, other.four), ..self }
    }

    /// The smaller; the other where one is not a number.
    #[inline(always)]
    pub fn min(self, other: Self) -> Self {
        Self { four: self.lanes.min(self.four, other.four), ..self }
    }

    /// A bit for each lane that is above `high` or below `low`.
    #[inline(always)]
    pub fn outside(self, low: Self, high: Self) -> u8 {
        self.lanes.outside(self.four, low.four, high.four)
    }

    /// The sum over the lanes, two by two.
    #[inline(always)]
    pub fn total(self) -> f64 {
        self.lanes.total(self.four)
    }

    /// The greatest of the lanes, none of which may be no number.
    #[inline(always)]
    pub fn greatest(self) -> f64 {
        self.lanes.greatest(self.four)
    }

    /// The four numbers in memory.
    #[inline(always)]
    pub fn pack(self) -> Pack {
        self.lanes.store(self.four)
    }
}

impl<L: Lanes> Add for Reals<L> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { four: self.lanes.add(self.four, other.four), ..self }
    }
}

impl<L: Lanes> Sub for Reals<L> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self { four: self.lanes.sub(self.four, other.four), ..self }
    }
}

impl<L: Lanes> Mul for Reals<L> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self { four: self.lanes.mul(self.four, other.four), ..self }
    }
}

impl<L: Lanes> Mul<f64> for Reals<L> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, factor: f64) -> Self {
        self * self.lanes.same(factor)
    }
}

impl<L: Lanes> Div for Reals<L> {
    type Output = Self;

    #[inline(always)]
    fn div(self, other: Self) -> Self {
        Self { four: self.lanes.div(self.four, other.four), ..self }
    }
}

impl<L: Lanes> AddAssign for Reals<L> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

/// Four vectors of `D` components; in a plane the third is carried along and not computed with.
#[derive(Clone, Copy)]
pub struct Vector<L: Lanes, const D: usize>(pub [Reals<L>; 3]);

impl<L: Lanes, const D: usize> Vector<L, D> {
    /// The scalar product.
    #[inline(always)]
    pub fn dot(self, other: Self) -> Reals<L> {
        let ([x, y, z], [u, v, w]) = (self.0, other.0);
        let plane = x * u + y * v;
        if D == 3 { plane + z * w } else { plane }
    }

    /// The sums over the lanes.
    #[inline(always)]
    pub fn totals(self) -> [f64; 3] {
        let [x, y, z] = self.0;
        [x.total(), y.total(), z.total()]
    }
}

impl<L: Lanes, const D: usize> Add for Vector<L, D> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let ([x, y, z], [u, v, w]) = (self.0, other.0);
        Self([x + u, y + v, if D == 3 { z + w } else { z }])
    }
}

impl<L: Lanes, const D: usize> Sub for Vector<L, D> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        let ([x, y, z], [u, v, w]) = (self.0, other.0);
        Self([x - u, y - v, if D == 3 { z - w } else { z }])
    }
}

impl<L: Lanes, const D: usize> Mul<Reals<L>> for Vector<L, D> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, factor: Reals<L>) -> Self {
        let [x, y, z] = self.0;
        Self([factor * x, factor * y, if D == 3 { factor * z } else { z }])
    }
}

impl<L: Lanes, const D: usize> AddAssign for Vector<L, D> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Plain, Sweep, widest};

    const A: Pack = [1.5, -2.0, 1e-9, 7.0];
    const B: Pack = [0.1, 3.0, -4.0, 1e8];

    /// `[a + b, a − b, a b, a/b, 3 a, max, min, √(a²)]`, then sum, greatest and who is outside.
    struct All;

    impl Sweep for All {
        type Output = (Vec<Pack>, f64, f64, u8);

        #[inline(always)]
        fn run<L: Lanes>(self, lanes: L) -> Self::Output {
            let (a, b) = (lanes.read(&A), lanes.read(&B));
            let found = [a + b, a - b, a * b, a / b, a * 3.0, a.max(b), a.min(b), (a * a).sqrt()];
            let outside = a.outside(lanes.same(-1.0), lanes.same(2.0));
            (found.map(Reals::pack).to_vec(), a.total(), a.greatest(), outside)
        }
    }

    #[test]
    fn operators_are_those_of_each_lane() {
        let of = |f: fn(f64, f64) -> f64| std::array::from_fn::<f64, 4, _>(|lane| f(A[lane], B[lane]));
        let expected = [
            of(|a, b| a + b),
            of(|a, b| a - b),
            of(|a, b| a * b),
            of(|a, b| a / b),
            of(|a, _| 3.0 * a),
            of(f64::max),
            of(f64::min),
            of(|a, _| (a * a).sqrt()),
        ];
        for (found, total, greatest, outside) in [widest(All), All.run(Plain)] {
            assert_eq!(found, expected);
            assert_eq!((total, greatest, outside), ((1.5 - 2.0) + (1e-9 + 7.0), 7.0, 0b1010));
        }
    }

    #[test]
    fn a_plane_has_no_third_component() {
        let (a, b) = (Plain.vector::<2>([1.0, 2.0, 5.0]), Plain.vector::<2>([3.0, -4.0, 9.0]));
        assert_eq!(a.dot(b).pack(), [-5.0; 4]);
        assert_eq!((a + b).totals(), [16.0, -8.0, 20.0]);
        let (a, b) = (Plain.vector::<3>([1.0, 2.0, 5.0]), Plain.vector::<3>([3.0, -4.0, 9.0]));
        assert_eq!(a.dot(b).pack(), [40.0; 4]);
        let mut sum = a - b;
        sum += b * Plain.same(2.0);
        assert_eq!(sum.totals(), [16.0, -8.0, 56.0]);
    }
}
