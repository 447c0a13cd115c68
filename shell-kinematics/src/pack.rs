//! Four numbers side by side: the arithmetic unit of the point formulas.
//!
//! A pack is a vector register (or two) of the `wide` crate, so that the point formulas run four at a time
//! whatever the optimiser makes of loops. No fused multiply-add is ever requested, so the same bits come
//! out on every machine.

use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

use lanes::{Lanes, Reals};
use wide::f64x4;

/// Points treated together.
pub const LANES: usize = 4;

/// What formulas ask of numbers that have a derivative.
pub trait Arithmetic:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Mul<f64, Output = Self>
    + AddAssign
{
    /// The same number in every lane, in registers of this kind.
    fn all(self, value: f64) -> Self;

    /// The square root.
    fn sqrt(self) -> Self;
}

/// What the formulas compute with: one number (`f64`), four (a [`Pack`]), or whatever registers a caller brings.
///
/// Every operation is that of IEEE 754 on each number by itself, none multiplies and adds at once: the same formula gives
/// the same bits whatever it computes with.
pub trait Number: Arithmetic {
    /// The greater; the other where one is not a number.
    fn max(self, other: Self) -> Self;

    /// The smaller; the other where one is not a number.
    fn min(self, other: Self) -> Self;

    /// Whether the number of every lane is below `bound`; what is not a number is not.
    fn below(self, bound: f64) -> bool;

    /// A function of each lane's number.
    fn each(self, f: impl Fn(f64) -> f64) -> Self;
}

impl Arithmetic for f64 {
    #[inline(always)]
    fn all(self, value: f64) -> f64 {
        value
    }

    #[inline(always)]
    fn sqrt(self) -> f64 {
        libm::sqrt(self)
    }
}

impl Number for f64 {
    #[inline(always)]
    fn max(self, other: f64) -> f64 {
        if self > other { self } else { other }
    }

    #[inline(always)]
    fn min(self, other: f64) -> f64 {
        if self < other { self } else { other }
    }

    #[inline(always)]
    fn below(self, bound: f64) -> bool {
        self < bound
    }

    #[inline(always)]
    fn each(self, f: impl Fn(f64) -> f64) -> f64 {
        f(self)
    }
}

impl<L: Lanes> Arithmetic for Reals<L> {
    #[inline(always)]
    fn all(self, value: f64) -> Self {
        self.lanes.same(value)
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        Reals::sqrt(self)
    }
}

impl<L: Lanes> Number for Reals<L> {
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Reals::max(self, other)
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Reals::min(self, other)
    }

    #[inline(always)]
    fn below(self, bound: f64) -> bool {
        self.outside(self.all(bound), self.all(f64::INFINITY)) == 0b1111
    }

    #[inline(always)]
    fn each(self, f: impl Fn(f64) -> f64) -> Self {
        let [a, b, c, d] = self.pack();
        self.lanes.read(&[f(a), f(b), f(c), f(d)])
    }
}

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

    /// The four numbers where they lie.
    #[inline(always)]
    pub fn as_array(&self) -> &[f64; LANES] {
        self.0.as_array()
    }

    /// Sum over the lanes, in ascending order.
    #[inline(always)]
    pub fn sum(self) -> f64 {
        self.lanes().iter().sum()
    }
}

impl Arithmetic for Pack {
    #[inline(always)]
    fn all(self, value: f64) -> Pack {
        Pack::splat(value)
    }

    #[inline(always)]
    fn sqrt(self) -> Pack {
        Pack(self.0.sqrt())
    }
}

impl Number for Pack {
    #[inline(always)]
    fn max(self, other: Pack) -> Pack {
        let (a, b) = (self.lanes(), other.lanes());
        Pack::from_fn(|lane| Number::max(a[lane], b[lane]))
    }

    #[inline(always)]
    fn min(self, other: Pack) -> Pack {
        let (a, b) = (self.lanes(), other.lanes());
        Pack::from_fn(|lane| Number::min(a[lane], b[lane]))
    }

    #[inline(always)]
    fn below(self, bound: f64) -> bool {
        let [a, b, c, d] = self.lanes();
        a < bound && b < bound && c < bound && d < bound
    }

    #[inline(always)]
    fn each(self, f: impl Fn(f64) -> f64) -> Pack {
        let [a, b, c, d] = self.lanes();
        Pack::new([f(a), f(b), f(c), f(d)])
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

impl Div for Pack {
    type Output = Pack;
    #[inline(always)]
    fn div(self, other: Pack) -> Pack {
        Pack(self.0 / other.0)
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

/// A vector of space for each of [`LANES`] points, or for as many as the numbers have lanes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pack3<P = Pack>(pub [P; 3]);

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
}

impl<P: Number> Pack3<P> {
    /// Scalar product, lane by lane.
    #[inline(always)]
    pub fn dot(self, other: Self) -> P {
        self.0[0] * other.0[0] + self.0[1] * other.0[1] + self.0[2] * other.0[2]
    }

    /// Vector product, lane by lane.
    #[inline(always)]
    pub fn cross(self, other: Self) -> Self {
        let ([a0, a1, a2], [b0, b1, b2]) = (self.0, other.0);
        Pack3([a1 * b2 - a2 * b1, a2 * b0 - a0 * b2, a0 * b1 - a1 * b0])
    }
}

impl<P: Number> Add for Pack3<P> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Pack3([self.0[0] + other.0[0], self.0[1] + other.0[1], self.0[2] + other.0[2]])
    }
}

impl<P: Number> Sub for Pack3<P> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Pack3([self.0[0] - other.0[0], self.0[1] - other.0[1], self.0[2] - other.0[2]])
    }
}

impl<P: Number> Mul<P> for Pack3<P> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: P) -> Self {
        Pack3([self.0[0] * factor, self.0[1] * factor, self.0[2] * factor])
    }
}

impl<P: Number> AddAssign for Pack3<P> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
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
