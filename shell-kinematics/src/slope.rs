//! Numbers that carry their derivative: formulas written once give exact second derivatives.

use std::ops::{Add, AddAssign, Div, Mul, Sub};

use crate::pack::{Arithmetic, Pack};

/// A number of each of four points and its derivative along some direction.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Slope {
    value: Pack,
    slope: Pack,
}

impl Slope {
    /// A number with its derivative.
    pub fn new(value: Pack, slope: Pack) -> Self {
        Self { value, slope }
    }

    /// A number that does not change.
    pub fn level(value: Pack) -> Self {
        Self { value, slope: Pack::ZERO }
    }

    /// The derivative.
    pub fn slope(self) -> Pack {
        self.slope
    }
}

impl Arithmetic for Slope {
    fn all(self, value: f64) -> Self {
        Self::level(Pack::splat(value))
    }

    fn sqrt(self) -> Self {
        let value = self.value.sqrt();
        Self { value, slope: self.slope / (value * 2.0) }
    }
}

impl Add for Slope {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { value: self.value + other.value, slope: self.slope + other.slope }
    }
}

impl Sub for Slope {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self { value: self.value - other.value, slope: self.slope - other.slope }
    }
}

impl Mul for Slope {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self { value: self.value * other.value, slope: self.slope * other.value + self.value * other.slope }
    }
}

impl Div for Slope {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        Self { value, slope: (self.slope - value * other.slope) / other.value }
    }
}

impl Mul<f64> for Slope {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        Self { value: self.value * factor, slope: self.slope * factor }
    }
}

impl AddAssign for Slope {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}
