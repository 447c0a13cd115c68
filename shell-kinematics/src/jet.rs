//! Functions of six numbers with their exact derivatives: of the first order, and of the second where `N` is six.

use std::ops::{Add, Mul};

/// Variables.
pub(crate) const VARIABLES: usize = 6;

/// A value with its derivatives; `N` rows of second ones, all of them or none.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Jet<const N: usize> {
    pub value: f64,
    pub slope: [f64; VARIABLES],
    pub curve: [[f64; VARIABLES]; N],
}

impl<const N: usize> Jet<N> {
    /// One of the variables.
    pub fn variable(number: usize, value: f64) -> Self {
        let slope = std::array::from_fn(|i| if i == number { 1.0 } else { 0.0 });
        Self { value, slope, curve: [[0.0; VARIABLES]; N] }
    }

    /// A function of one number, by its value and its first two derivatives there.
    fn through(self, [value, first, second]: [f64; 3]) -> Self {
        let slope = self.slope.map(|s| first * s);
        let curve = std::array::from_fn(|i| {
            std::array::from_fn(|j| first * self.curve[i][j] + second * self.slope[i] * self.slope[j])
        });
        Self { value, slope, curve }
    }

    /// `1/√`.
    pub fn inverse_root(self) -> Self {
        let value = 1.0 / self.value.sqrt();
        let first = -0.5 * value / self.value;
        self.through([value, first, -1.5 * first / self.value])
    }

    /// The same less a number that does not change, times another.
    pub fn changed(self, from: f64, factor: f64) -> Self {
        self.through([(self.value - from) * factor, factor, 0.0])
    }
}

impl<const N: usize> Add for Jet<N> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let slope = std::array::from_fn(|i| self.slope[i] + other.slope[i]);
        let curve = std::array::from_fn(|i| std::array::from_fn(|j| self.curve[i][j] + other.curve[i][j]));
        Self { value: self.value + other.value, slope, curve }
    }
}

impl<const N: usize> Mul for Jet<N> {
    type Output = Self;

    /// By the rule of products.
    #[allow(clippy::suspicious_arithmetic_impl)]
    fn mul(self, other: Self) -> Self {
        let (a, b) = (self, other);
        let slope = std::array::from_fn(|i| a.slope[i] * b.value + a.value * b.slope[i]);
        let curve = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                a.curve[i][j] * b.value
                    + a.slope[i] * b.slope[j]
                    + a.slope[j] * b.slope[i]
                    + a.value * b.curve[i][j]
            })
        });
        Self { value: a.value * b.value, slope, curve }
    }
}

impl<const N: usize> Mul<f64> for Jet<N> {
    type Output = Self;

    fn mul(self, factor: f64) -> Self {
        self.through([self.value * factor, factor, 0.0])
    }
}
