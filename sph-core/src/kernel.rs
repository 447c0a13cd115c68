//! Smoothing kernels: shape w(q), slope w'(q) and support, normalised on a surface.
//!
//! | name | support | smoothness | source |
//! |---|---|---|---|
//! | `cubic-spline` | 2 h | C² | \[monaghan1985\] |
//! | `wendland-c2` | 2 h | C² | \[wendland1995\] |
//! | `wendland-c4` | 2 h | C⁴ | \[wendland1995\] |
//! | `quintic-spline` | 3 h | C⁴ | \[morris1997\] |

use std::f64::consts::PI;

/// A radial kernel on a surface: `W(r) = w(r/h) / h²`, `[1/L²]`, with `∫ w(q) 2πq dq = 1`.
pub trait Kernel: Send + Sync {
    /// Name by which scenes choose the kernel.
    fn name(&self) -> &'static str;

    /// One line for people.
    fn describe(&self) -> &'static str;

    /// Radius of the support in units of `h`; `w` and `w'` vanish from there on.
    fn support(&self) -> f64;

    /// `w(q)` at `q = r/h ≥ 0`, dimensionless.
    fn value(&self, q: f64) -> f64;

    /// `w'(q)` at `q = r/h ≥ 0`, dimensionless; never positive.
    fn slope(&self, q: f64) -> f64;
}

/// Cubic B-spline \[monaghan1985\]: `w = 10/(7π) · { 1 − 3q²/2 + 3q³/4 | q < 1 ; (2−q)³/4 | q < 2 }`.
#[derive(Clone, Copy, Debug)]
pub struct CubicSpline;

/// Wendland's C² kernel \[wendland1995\]: `w = 7/(4π) · (1−q/2)⁴ (1+2q)`, `q < 2`.
#[derive(Clone, Copy, Debug)]
pub struct WendlandC2;

/// Wendland's C⁴ kernel \[wendland1995\]: `w = 9/(4π) · (1−q/2)⁶ (1+3q+35q²/12)`, `q < 2`.
#[derive(Clone, Copy, Debug)]
pub struct WendlandC4;

/// Quintic B-spline \[morris1997\]: `w = 7/(478π) · [(3−q)⁵₊ − 6(2−q)⁵₊ + 15(1−q)⁵₊]`.
#[derive(Clone, Copy, Debug)]
pub struct QuinticSpline;

/// Every kernel of the crate; a new one is added here.
pub fn kernels() -> [&'static dyn Kernel; 4] {
    [&CubicSpline, &WendlandC2, &WendlandC4, &QuinticSpline]
}

/// The kernel called `name`, if there is one.
pub fn kernel(name: &str) -> Option<&'static dyn Kernel> {
    kernels().into_iter().find(|kernel| kernel.name() == name)
}

impl Kernel for CubicSpline {
    fn name(&self) -> &'static str {
        "cubic-spline"
    }

    fn describe(&self) -> &'static str {
        "cubic B-spline, support 2 h"
    }

    fn support(&self) -> f64 {
        2.0
    }

    fn value(&self, q: f64) -> f64 {
        let sigma = 10.0 / (7.0 * PI);
        if q < 1.0 {
            sigma * (1.0 - 1.5 * q * q + 0.75 * q * q * q)
        } else {
            sigma * 0.25 * (2.0 - q).max(0.0).powi(3)
        }
    }

    fn slope(&self, q: f64) -> f64 {
        let sigma = 10.0 / (7.0 * PI);
        if q < 1.0 { sigma * q * (2.25 * q - 3.0) } else { -sigma * 0.75 * (2.0 - q).max(0.0).powi(2) }
    }
}

impl Kernel for WendlandC2 {
    fn name(&self) -> &'static str {
        "wendland-c2"
    }

    fn describe(&self) -> &'static str {
        "Wendland's C2 kernel, support 2 h"
    }

    fn support(&self) -> f64 {
        2.0
    }

    fn value(&self, q: f64) -> f64 {
        7.0 / (4.0 * PI) * (1.0 - 0.5 * q).max(0.0).powi(4) * (1.0 + 2.0 * q)
    }

    fn slope(&self, q: f64) -> f64 {
        -7.0 / (4.0 * PI) * 5.0 * q * (1.0 - 0.5 * q).max(0.0).powi(3)
    }
}

impl Kernel for WendlandC4 {
    fn name(&self) -> &'static str {
        "wendland-c4"
    }

    fn describe(&self) -> &'static str {
        "Wendland's C4 kernel, support 2 h"
    }

    fn support(&self) -> f64 {
        2.0
    }

    fn value(&self, q: f64) -> f64 {
        9.0 / (4.0 * PI) * (1.0 - 0.5 * q).max(0.0).powi(6) * (1.0 + 3.0 * q + 35.0 / 12.0 * q * q)
    }

    fn slope(&self, q: f64) -> f64 {
        -9.0 / (4.0 * PI) * 7.0 / 3.0 * q * (2.0 + 5.0 * q) * (1.0 - 0.5 * q).max(0.0).powi(5)
    }
}

impl Kernel for QuinticSpline {
    fn name(&self) -> &'static str {
        "quintic-spline"
    }

    fn describe(&self) -> &'static str {
        "quintic B-spline, support 3 h"
    }

    fn support(&self) -> f64 {
        3.0
    }

    fn value(&self, q: f64) -> f64 {
        let power = |edge: f64| (edge - q).max(0.0).powi(5);
        7.0 / (478.0 * PI) * (power(3.0) - 6.0 * power(2.0) + 15.0 * power(1.0))
    }

    fn slope(&self, q: f64) -> f64 {
        let power = |edge: f64| (edge - q).max(0.0).powi(4);
        -35.0 / (478.0 * PI) * (power(3.0) - 6.0 * power(2.0) + 15.0 * power(1.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::{assert_abs_diff_eq, assert_relative_eq};

    /// Gauss–Legendre rule with eight points on [-1, 1], one of each pair: exact for polynomials of degree 15.
    const GAUSS: [(f64, f64); 4] = [
        (0.183_434_642_495_649_8, 0.362_683_783_378_362),
        (0.525_532_409_916_329, 0.313_706_645_877_887_3),
        (0.796_666_477_413_626_7, 0.222_381_034_453_374_48),
        (0.960_289_856_497_536_3, 0.101_228_536_290_376_26),
    ];

    /// Integral from zero to a whole number.
    fn integral(to: usize, f: impl Fn(f64) -> f64) -> f64 {
        let both = GAUSS.into_iter().flat_map(|(x, w)| [(x, w), (-x, w)]);
        let points =
            both.flat_map(|(x, w)| (0..to).map(move |piece| (piece as f64 + 0.5 * (1.0 + x), 0.5 * w)));
        points.map(|(q, w)| w * f(q)).sum()
    }

    #[test]
    fn the_rule_is_exact_to_degree_fifteen() {
        for degree in 0..16 {
            let exact = 1.0 / f64::from(degree + 1);
            assert_relative_eq!(integral(1, |x| x.powi(degree)), exact, epsilon = 1e-14);
        }
        assert!((integral(1, |x| x.powi(16)) - 1.0 / 17.0).abs() > 1e-11);
    }

    #[test]
    fn every_kernel_integrates_to_one() {
        for kernel in kernels() {
            // Polynomials of degree ≤ 14 between whole numbers pass; with the factor q the rule is exact.
            let integral = integral(kernel.support() as usize, |q| kernel.value(q) * 2.0 * PI * q);
            assert_relative_eq!(integral, 1.0, epsilon = 1e-12);
        }
    }

    #[test]
    fn every_slope_is_the_derivative_of_the_value() {
        let step = 1e-5; // balances truncation (step²) and rounding (1e-16/step)
        for kernel in kernels() {
            for i in 1..400 {
                let q = 0.01 * i as f64;
                let difference = (kernel.value(q + step) - kernel.value(q - step)) / (2.0 * step);
                assert_abs_diff_eq!(kernel.slope(q), difference, epsilon = 1e-9);
            }
        }
    }

    #[test]
    fn every_kernel_falls_smoothly_to_zero_at_its_support() {
        for kernel in kernels() {
            let edge = kernel.support();
            assert_eq!(kernel.slope(0.0), 0.0, "{}", kernel.name());
            for q in [edge, edge + 1e-9, 10.0 * edge] {
                assert_eq!((kernel.value(q), kernel.slope(q)), (0.0, 0.0), "{}", kernel.name());
            }
            // C² at least: w ~ (edge−q)³, w' ~ (edge−q)²; largest coefficient of the four is 5.
            let gap = 1e-3;
            assert!(kernel.value(edge - gap) < 5.0 * gap.powi(3), "{}", kernel.name());
            assert!(-kernel.slope(edge - gap) < 5.0 * gap.powi(2), "{}", kernel.name());
            for i in 1..100 {
                let q = edge * i as f64 / 100.0;
                assert!(kernel.value(q) > 0.0 && kernel.slope(q) < 0.0, "{} at {q}", kernel.name());
            }
        }
    }

    #[test]
    fn kernels_are_found_by_name() {
        for found in kernels() {
            assert_eq!(kernel(found.name()).map(|k| k.name()), Some(found.name()));
        }
        assert!(kernel("gaussian").is_none());
    }
}
