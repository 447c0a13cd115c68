//! The elastica: an inextensible, shear-rigid cantilever bent far beyond small rotations.
//!
//! ```text
//!   z (deflection)            clamped at x = 0, straight along x at rest, length L, bending stiffness EI
//!   │   ╭──╴ tip: w up, u back         end moment:  θ = M L/(EI), the strip rolls into a circle
//!   └──────────────► x                 end load:    α = P L²/(EI), a dead force along z
//! ```
//! Lengths are returned in parts of L, rotations in radians.

use crate::elliptic::{r_d, r_f};
use std::f64::consts::{FRAC_PI_2, SQRT_2};

/// Where the free end has gone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tip {
    /// Shortening u/L: how far the tip moved back towards the clamp, without dimension.
    pub u: f64,
    /// Deflection w/L, without dimension.
    pub w: f64,
    /// Rotation of the end section, in radians.
    pub theta: f64,
}

/// sin(a)/a, continued by 1 at a = 0.
pub(crate) fn sinc(a: f64) -> f64 {
    if a == 0.0 { 1.0 } else { libm::sin(a) / a }
}

/// The tip under an end moment that turns it by `theta` = M L/(EI), in radians:
/// u/L = 1 − sin θ/θ, w/L = (1 − cos θ)/θ \[simo1989\].
pub fn end_moment(theta: f64) -> Tip {
    let (x, w) = end_moment_point(theta, 1.0);
    Tip { u: 1.0 - x, w, theta }
}

/// The point (x/L, z/L) of the centre line at arc length `s` = S/L ∈ \[0, 1\] under an end moment with
/// `theta` = M L/(EI), in radians: an arc of the circle of radius L/θ.
pub fn end_moment_point(theta: f64, s: f64) -> (f64, f64) {
    let turned = theta * s;
    let half = 0.5 * turned;
    (s * sinc(turned), s * libm::sin(half) * sinc(half))
}

/// The tip under a dead end load `alpha` = P L²/(EI), across the undeformed strip \[mattiasson1981\].
///
/// With m = (1 + sin θ)/2 for the tip rotation θ, and sin²φ₁ = 1/(2m):
/// √α = K(m) − F(φ₁, m), w/L = 1 − 2/√α \[E(m) − E(φ₁, m)\], u/L = 1 − √(2 sin θ/α).
/// The absolute error stays below 1e-11. A negative load mirrors the strip; NaN stays NaN.
pub fn end_load(alpha: f64) -> Tip {
    // Below this the linear beam is exact to 1e-12, and the closed form would lose digits to cancellation.
    const LINEAR: f64 = 1e-4;
    // Above this the tip stands upright to the last bit (δ ~ e^(−√α)), and the integrals have elementary limits.
    const UPRIGHT: f64 = 1e4;
    if alpha.is_nan() {
        return Tip { u: alpha, w: alpha, theta: alpha };
    }
    if alpha.abs() < LINEAR {
        return Tip { u: alpha * alpha / 15.0, w: alpha / 3.0, theta: alpha / 2.0 };
    }
    if alpha < 0.0 {
        let Tip { u, w, theta } = end_load(-alpha);
        return Tip { u, w: -w, theta: -theta };
    }
    let root = alpha.sqrt();
    if alpha > UPRIGHT {
        return Tip { u: 1.0 - SQRT_2 / root, w: 1.0 - (2.0 - SQRT_2) / root, theta: FRAC_PI_2 };
    }
    let short_of_upright = bisect(|delta| EndLoad::new(delta).root_alpha() - root, FRAC_PI_2);
    let state = EndLoad::new(short_of_upright);
    Tip {
        u: 1.0 - (2.0 * state.sin_theta / alpha).sqrt(),
        w: 1.0 - 2.0 / root * state.second_kind(),
        theta: FRAC_PI_2 - short_of_upright,
    }
}

/// The elliptic integrals of the end load, in terms of δ = π/2 − θ: 1 − m = sin²(δ/2) keeps its digits as the strip
/// stands upright, where 1 − m computed from m would vanish.
struct EndLoad {
    m: f64,
    one_minus_m: f64,
    sin_theta: f64,
}

impl EndLoad {
    fn new(delta: f64) -> Self {
        let one_minus_m = libm::pow(libm::sin(0.5 * delta), 2.0);
        Self { m: 1.0 - one_minus_m, one_minus_m, sin_theta: libm::cos(delta) }
    }

    /// K(m) − F(φ₁, m), with cos²φ₁ = sin θ/(2m) and 1 − m sin²φ₁ = ½.
    fn root_alpha(&self) -> f64 {
        let (c2, s) = self.amplitude();
        r_f(0.0, self.one_minus_m, 1.0) - s * r_f(c2, 0.5, 1.0)
    }

    /// E(m) − E(φ₁, m), where E(φ, m) = F(φ, m) − m/3 sin³φ R_D(cos²φ, 1 − m sin²φ, 1).
    fn second_kind(&self) -> f64 {
        let (c2, s) = self.amplitude();
        let complete = r_d(0.0, self.one_minus_m, 1.0);
        let incomplete = s * s * s * r_d(c2, 0.5, 1.0);
        self.root_alpha() - self.m / 3.0 * (complete - incomplete)
    }

    /// cos²φ₁ and sin φ₁.
    fn amplitude(&self) -> (f64, f64) {
        (self.sin_theta / (2.0 * self.m), (0.5 / self.m).sqrt())
    }
}

/// The root in (0, `high`) of a falling function, to the last bit.
fn bisect(falling: impl Fn(f64) -> f64, mut high: f64) -> f64 {
    let mut low = 0.0;
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            return middle;
        }
        if falling(middle) > 0.0 { low = middle } else { high = middle }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reference;
    use approx::assert_abs_diff_eq;
    use std::f64::consts::PI;

    /// Half a unit in the ninth decimal: the tables print nine.
    const NINE_DECIMALS: f64 = 0.51e-9;

    #[test]
    fn end_moment_reproduces_its_table_to_the_printed_digits() {
        let table = reference("elastica_end_moment").unwrap();
        for row in 0..table.rows.len() {
            // the printed θ itself is rounded; the rows are multiples of π/12
            let theta = PI / 12.0 * (row + 1) as f64;
            let tip = end_moment(theta);
            assert_abs_diff_eq!(theta, table.number(row, "theta").unwrap(), epsilon = NINE_DECIMALS);
            assert_abs_diff_eq!(tip.u, table.number(row, "u/L").unwrap(), epsilon = NINE_DECIMALS);
            assert_abs_diff_eq!(tip.w, table.number(row, "w/L").unwrap(), epsilon = NINE_DECIMALS);
        }
    }

    #[test]
    fn end_load_reproduces_its_table_to_the_printed_digits() {
        let table = reference("elastica_end_load").unwrap();
        for row in 0..table.rows.len() {
            let tip = end_load(table.number(row, "alpha").unwrap());
            assert_abs_diff_eq!(tip.u, table.number(row, "u/L").unwrap(), epsilon = NINE_DECIMALS);
            assert_abs_diff_eq!(tip.w, table.number(row, "w/L").unwrap(), epsilon = NINE_DECIMALS);
            assert_abs_diff_eq!(tip.theta, table.number(row, "theta_tip").unwrap(), epsilon = NINE_DECIMALS);
        }
    }

    /// EI θ'' = −P cos θ by the midpoint rule from the computed tip rotation: the clamp must come out unrotated.
    #[test]
    fn end_load_satisfies_the_differential_equation() {
        for alpha in [0.01, 1.0, 10.0, 40.0] {
            let tip = end_load(alpha);
            let n = 20_000;
            let step = 1.0 / f64::from(n);
            // from the tip inwards: θ' = 0 there
            let (mut theta, mut slope, mut along, mut across) = (tip.theta, 0.0, 0.0, 0.0);
            for _ in 0..n {
                let half_slope: f64 = slope + 0.5 * step * alpha * libm::cos(theta);
                let half_theta: f64 = theta - 0.5 * step * slope;
                slope += step * alpha * libm::cos(half_theta);
                theta -= step * half_slope;
                along += step * libm::cos(half_theta);
                across += step * libm::sin(half_theta);
            }
            // second order: error ~ α^{3/2} step²
            assert_abs_diff_eq!(theta, 0.0, epsilon = 1e-6);
            assert_abs_diff_eq!(along, 1.0 - tip.u, epsilon = 1e-6);
            assert_abs_diff_eq!(across, tip.w, epsilon = 1e-6);
        }
    }

    #[test]
    fn limits_and_symmetry() {
        // the linear branch meets the closed form
        let (below, above) = (end_load(0.999_999e-4), end_load(1.000_001e-4));
        assert_abs_diff_eq!(below.w, above.w, epsilon = 1e-10);
        assert_abs_diff_eq!(below.u, above.u, epsilon = 1e-11);
        assert_abs_diff_eq!(below.theta, above.theta, epsilon = 2e-10);
        // the closed form meets the upright branch, whose slope dw/dα is 0.3 α^(−3/2)
        let (below, above) = (end_load(9.999_999e3), end_load(10_000.001));
        assert_abs_diff_eq!(below.w, above.w, epsilon = 1e-9);
        assert_abs_diff_eq!(below.u, above.u, epsilon = 2e-9);
        assert_abs_diff_eq!(below.theta, above.theta, epsilon = 1e-15);
        assert!(end_load(f64::NAN).w.is_nan());
        let (push, pull) = (end_load(3.0), end_load(-3.0));
        assert_eq!((push.u, push.w, push.theta), (pull.u, -pull.w, -pull.theta));
    }

    #[test]
    fn end_moment_keeps_the_length_and_closes_the_circle() {
        assert_eq!(end_moment(0.0), Tip { u: 0.0, w: 0.0, theta: 0.0 });
        let ring = end_moment(2.0 * PI);
        assert_abs_diff_eq!(ring.u, 1.0, epsilon = 1e-15);
        assert_abs_diff_eq!(ring.w, 0.0, epsilon = 1e-15);
        // opposite points of the ring lie a diameter 1/π apart
        let (x, z) = end_moment_point(2.0 * PI, 0.5);
        assert_abs_diff_eq!(x, 0.0, epsilon = 1e-15);
        assert_abs_diff_eq!(z, 1.0 / PI, epsilon = 1e-15);
    }
}
