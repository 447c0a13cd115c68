//! A spring that hardens.

use super::Potential;

/// A spring of one unknown whose stiffness grows with its square.
pub struct Hardening;

impl Potential for Hardening {
    fn unknowns(&self) -> usize {
        1
    }
    fn energy(&self, q: &[f64]) -> f64 {
        0.5 * q[0] * q[0] + 0.25 * q[0].powi(4)
    }
    fn gradient(&self, q: &[f64], out: &mut [f64]) {
        out[0] = q[0] + q[0].powi(3);
    }
    fn hessian(&self, q: &[f64], add: &mut dyn FnMut(usize, usize, f64)) {
        add(0, 0, 1.0 + 3.0 * q[0] * q[0]);
    }
    fn load(&self, _: &[f64], out: &mut [f64]) {
        out[0] = 1.0;
    }
}
