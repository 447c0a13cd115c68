//! A strip under an end moment whose strain is Green–Lagrange: the closed form for a shell that is not the elastica.
//!
//! A total-Lagrangian shell with E = ½(λ² − 1) + ζ λ k (no ζ² term) and a linear law between the second
//! Piola–Kirchhoff stress and E rolls into a circle as the elastica does, yet shortens and softens when it is thick.
//! With the director inextensible, λ the stretch of the mid-line and k = θ/L its turn per *reference* length,
//! the energy per reference length and width is ½ E t \[½(λ² − 1)\]² + ½ (E t³/12)(λ k)². Then
//!
//! - no axial force, ∂/∂λ = 0: λ² = 1 − (k t)²/6;
//! - the end moment is ∂/∂k:   M/(E I k) = 1 − (k t)²/6.
//!
//! At t/L = 0.1 and a full turn the moment is 6.6 % below the elastica: compare a Green–Lagrange shell with
//! this law, or test it on a thin strip (0.07 % at t/L = 0.01).

use crate::elastica::sinc;
use crate::error::ReferenceError;
use std::f64::consts::SQRT_2;

/// The greatest M t/(E I) that the strip carries, 2√2/3, reached at k t = √2; without dimension.
pub const LARGEST_MOMENT: f64 = 2.0 * SQRT_2 / 3.0;

/// A strip rolled by an end moment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RolledStrip {
    /// Rotation of the end section θ = k L, in radians.
    pub theta: f64,
    /// Stretch λ of the mid-line, without dimension.
    pub stretch: f64,
    /// Position (x/L, z/L) of the tip, without dimension: an arc of length λL turned by θ.
    pub tip: (f64, f64),
}

/// M/(E I k) of a strip turned by `kt` = k t = θ t/L, without dimension.
pub fn moment_ratio(kt: f64) -> f64 {
    1.0 - kt * kt / 6.0
}

/// Stretch λ of the mid-line of a strip turned by `kt` = k t = θ t/L (|kt| ≤ √2), without dimension.
pub fn stretch(kt: f64) -> f64 {
    (1.0 - kt * kt / 6.0).sqrt()
}

/// The strip under the end moment `m` = M L/(E I) (the rotation of the elastica, in radians) with `slenderness` = t/L.
///
/// Solves μ = y − y³/6 for y = k t at μ = M t/(E I): y = 2√2 sin(⅓ arcsin(3μ/(2√2))), the stable root, which starts
/// at y = μ. Beyond |μ| = 2√2/3 there is no equilibrium.
pub fn under_moment(m: f64, slenderness: f64) -> Result<RolledStrip, ReferenceError> {
    let ratio = m * slenderness;
    if ratio.is_nan() || ratio.abs() > LARGEST_MOMENT {
        return Err(ReferenceError::MomentTooLarge { ratio, bound: LARGEST_MOMENT });
    }
    let kt = 2.0 * SQRT_2 * libm::sin(libm::asin(ratio / LARGEST_MOMENT) / 3.0);
    let stretch = stretch(kt);
    // θ from M rather than from y/(t/L), which would divide zero by zero for a strip without thickness
    let theta = m / moment_ratio(kt);
    let half = 0.5 * theta;
    let tip = (stretch * sinc(theta), stretch * libm::sin(half) * sinc(half));
    Ok(RolledStrip { theta, stretch, tip })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::elastica::end_moment;
    use approx::{assert_abs_diff_eq, assert_relative_eq};
    use std::f64::consts::PI;

    /// The energy of the file header, per reference length and width, with E = t = 1.
    fn energy(stretch: f64, kt: f64) -> f64 {
        0.5 * (0.5 * (stretch * stretch - 1.0)).powi(2) + (stretch * kt).powi(2) / 24.0
    }

    #[test]
    fn equilibrium_is_the_derivative_of_the_energy() {
        let step = 1e-6;
        for kt in [0.01, 0.3, 0.6283, 1.2] {
            let s = stretch(kt);
            let axial = (energy(s + step, kt) - energy(s - step, kt)) / (2.0 * step);
            let moment = (energy(s, kt + step) - energy(s, kt - step)) / (2.0 * step);
            assert_abs_diff_eq!(axial, 0.0, epsilon = 1e-10);
            assert_relative_eq!(moment, kt / 12.0 * moment_ratio(kt), max_relative = 1e-7);
        }
    }

    /// λ = 0.967 and M/(E I k) = 0.934 at a full turn with t/L = 0.1, as the notes of `seed_ring_bending` state.
    #[test]
    fn key_digits_of_the_thick_ring() {
        let kt = 2.0 * PI * 0.1;
        assert_abs_diff_eq!(stretch(kt), 0.967, epsilon = 5e-4);
        assert_abs_diff_eq!(moment_ratio(kt), 0.934, epsilon = 5e-4);
        let strip = under_moment(2.0 * PI * moment_ratio(kt), 0.1).unwrap();
        assert_relative_eq!(strip.theta, 2.0 * PI, max_relative = 1e-14);
        assert_abs_diff_eq!(strip.tip.0, 0.0, epsilon = 1e-14);
        assert_abs_diff_eq!(strip.tip.1, 0.0, epsilon = 1e-14);
    }

    #[test]
    fn solves_the_moment_law_and_mirrors() {
        for m in [-6.0, -0.5, 0.5, 3.0, 6.0, 9.4] {
            let strip = under_moment(m, 0.1).unwrap();
            assert_relative_eq!(strip.theta * moment_ratio(0.1 * strip.theta), m, max_relative = 1e-13);
            let mirror = under_moment(-m, 0.1).unwrap();
            assert_eq!((strip.theta, strip.tip.0, strip.tip.1), (-mirror.theta, mirror.tip.0, -mirror.tip.1));
        }
    }

    #[test]
    fn a_strip_without_thickness_is_the_elastica() {
        for m in [0.0, 0.3, 2.0, 6.0] {
            let (strip, elastica) = (under_moment(m, 0.0).unwrap(), end_moment(m));
            assert_eq!(strip.theta, m);
            assert_abs_diff_eq!(strip.tip.0, 1.0 - elastica.u, epsilon = 1e-15);
            assert_abs_diff_eq!(strip.tip.1, elastica.w, epsilon = 1e-15);
        }
    }

    #[test]
    fn the_largest_moment_is_the_last() {
        assert_relative_eq!(SQRT_2 * moment_ratio(SQRT_2), LARGEST_MOMENT, max_relative = 1e-15);
        assert!(under_moment(10.0 * LARGEST_MOMENT, 0.1).is_ok());
        let error = under_moment(10.0, 0.1).unwrap_err();
        assert!(matches!(error, ReferenceError::MomentTooLarge { .. }), "{error}");
        assert!(under_moment(f64::NAN, 0.1).is_err());
    }
}
