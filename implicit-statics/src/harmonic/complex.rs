//! A complex number: what goes as `Re[z exp(iωt)]`.

use std::ops::{Add, Mul};

/// `re + i im`, of `re cos ωt − im sin ωt`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Complex {
    /// What goes with the cosine.
    pub re: f64,
    /// What goes with the negative sine.
    pub im: f64,
}

impl Complex {
    /// A number from its two parts.
    pub const fn new(re: f64, im: f64) -> Self {
        Self { re, im }
    }

    /// The greatest value over a cycle.
    pub fn amplitude(self) -> f64 {
        libm::hypot(self.re, self.im)
    }

    /// The angle by which it is ahead of the cosine \[rad\], from −π to π.
    pub fn phase(self) -> f64 {
        libm::atan2(self.im, self.re)
    }

    /// `|z|²`.
    pub fn square(self) -> f64 {
        self.re * self.re + self.im * self.im
    }

    /// `f / z`, scaled so that no square of a large or small z is taken.
    pub fn under(self, f: f64) -> Self {
        let size = self.re.abs().max(self.im.abs());
        let (re, im) = (self.re / size, self.im / size);
        let share = f / size / (re * re + im * im);
        Self { re: share * re, im: -share * im }
    }
}

impl Add for Complex {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { re: self.re + other.re, im: self.im + other.im }
    }
}

impl Mul for Complex {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self { re: self.re * other.re - self.im * other.im, im: self.re * other.im + self.im * other.re }
    }
}

impl Mul<f64> for Complex {
    type Output = Self;

    fn mul(self, factor: f64) -> Self {
        Self { re: factor * self.re, im: factor * self.im }
    }
}

#[cfg(test)]
mod tests {
    use super::Complex;

    #[test]
    fn products_quotients_sizes_and_angles() {
        let z = Complex::new(3.0, -4.0);
        assert_eq!(z * Complex::new(0.0, 1.0), Complex::new(4.0, 3.0));
        assert_eq!((z.amplitude(), z.square()), (5.0, 25.0));
        assert!((Complex::new(0.0, -2.0).phase() + std::f64::consts::FRAC_PI_2).abs() < 1e-15);
        let back = z * z.under(2.0);
        assert!((back.re - 2.0).abs() < 1e-15 && back.im.abs() < 1e-15);
        // The squares of these are no numbers.
        let tiny = Complex::new(1e-200, 1e-200).under(1e-200);
        assert!((tiny.re - 0.5).abs() < 1e-15 && (tiny.im + 0.5).abs() < 1e-15);
    }
}
