//! Four numbers side by side: the arithmetic unit of the point formulas.
//!
//! A pack is a vector register (or two) of the `wide` crate, so that the point formulas run four at a time
//! whatever the optimiser makes of loops. No fused multiply-add is ever requested, so the same bits come
//! out on every machine.

use std::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

use wide::f64x4;

/// Points treated together.
pub const LANES: usize = 4;

/// One number for each of [`LANES`] points.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pack(f64x4);

impl Pack {
    /// Zero in every lane.
    pub const ZERO: Pack = Pack(f64x4::ZERO);

    /// Lane by lane.
    #[inline(always)]
    pub fn new(lanes: [f64; LANES]) -> Self {
        Pack(f64x4::new(lanes))
    }

    /// The same number in every lane.
    #[inline(always)]
    pub fn splat(value: f64) -> Self {
        Pack(f64x4::splat(value))
    }

    /// Lane by lane from a function of the lane's number.
    #[inline(always)]
    pub fn from_fn(f: impl FnMut(usize) -> f64) -> Self {
        Self::new(std::array::from_fn(f))
    }

    /// The four numbers.
    #[inline(always)]
    pub fn lanes(self) -> [f64; LANES] {
        self.0.to_array()
    }

    /// Sum over the lanes, in ascending order.
    #[inline(always)]
    pub fn sum(self) -> f64 {
        self.lanes().iter().sum()
    }
}

impl Add for Pack {
    type Output = Pack;
    #[inline(always)]
    fn add(self, other: Pack) -> Pack {
        Pack(self.0 + other.0)
    }
}

impl Sub for Pack {
    type Output = Pack;
    #[inline(always)]
    fn sub(self, other: Pack) -> Pack {
        Pack(self.0 - other.0)
    }
}

impl Mul for Pack {
    type Output = Pack;
    #[inline(always)]
    fn mul(self, other: Pack) -> Pack {
        Pack(self.0 * other.0)
    }
}

impl Mul<f64> for Pack {
    type Output = Pack;
    #[inline(always)]
    fn mul(self, factor: f64) -> Pack {
        self * Pack::splat(factor)
    }
}

impl Neg for Pack {
    type Output = Pack;
    #[inline(always)]
    fn neg(self) -> Pack {
        Pack(-self.0)
    }
}

impl AddAssign for Pack {
    #[inline(always)]
    fn add_assign(&mut self, other: Pack) {
        *self = *self + other;
    }
}

impl SubAssign for Pack {
    #[inline(always)]
    fn sub_assign(&mut self, other: Pack) {
        *self = *self - other;
    }
}

/// A vector of space for each of [`LANES`] points.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pack3(pub [Pack; 3]);

impl Pack3 {
    /// The zero vector in every lane.
    pub const ZERO: Pack3 = Pack3([Pack::ZERO; 3]);

    /// The same vector in every lane.
    #[inline(always)]
    pub fn splat(vector: [f64; 3]) -> Self {
        Pack3(vector.map(Pack::splat))
    }

    /// The vector of one lane.
    #[inline(always)]
    pub fn lane(&self, lane: usize) -> [f64; 3] {
        self.0.map(|component| component.lanes()[lane])
    }

    /// Scalar product, lane by lane.
    #[inline(always)]
    pub fn dot(self, other: Pack3) -> Pack {
        self.0[0] * other.0[0] + self.0[1] * other.0[1] + self.0[2] * other.0[2]
    }

    /// Vector product, lane by lane.
    #[inline(always)]
    pub fn cross(self, other: Pack3) -> Pack3 {
        let ([a0, a1, a2], [b0, b1, b2]) = (self.0, other.0);
        Pack3([a1 * b2 - a2 * b1, a2 * b0 - a0 * b2, a0 * b1 - a1 * b0])
    }
}

impl Add for Pack3 {
    type Output = Pack3;
    #[inline(always)]
    fn add(self, other: Pack3) -> Pack3 {
        Pack3([self.0[0] + other.0[0], self.0[1] + other.0[1], self.0[2] + other.0[2]])
    }
}

impl Sub for Pack3 {
    type Output = Pack3;
    #[inline(always)]
    fn sub(self, other: Pack3) -> Pack3 {
        Pack3([self.0[0] - other.0[0], self.0[1] - other.0[1], self.0[2] - other.0[2]])
    }
}

impl Mul<Pack> for Pack3 {
    type Output = Pack3;
    #[inline(always)]
    fn mul(self, factor: Pack) -> Pack3 {
        Pack3([self.0[0] * factor, self.0[1] * factor, self.0[2] * factor])
    }
}

impl AddAssign for Pack3 {
    #[inline(always)]
    fn add_assign(&mut self, other: Pack3) {
        *self = *self + other;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lanes_are_summed() {
        assert_eq!(Pack::new([1.0, 20.0, 300.0, 4000.0]).sum(), 4321.0);
    }
}
