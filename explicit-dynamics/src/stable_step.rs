//! The stable step from the largest eigenvalue of the mass-scaled stiffness, by Lanczos iteration.

use nalgebra::{DMatrix, SymmetricEigen};

use crate::error::MarchError;
use crate::linearised::LinearisedDynamics;

/// Steps of a Lanczos iteration for a stable step.
pub const LANCZOS_STEPS: usize = 30;
/// Steps for which its estimate holds: spectra of solids change slowly.
const HOLDS: u64 = 5000;

/// A step of central differences that is stable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StableStep {
    /// Its span \[T\].
    pub dt: f64,
    /// Steps for which it holds. Where it is one the step is found anew before every step; longer ones are renewed at the
    /// first record of a transient after so many steps, and at every level of a quasi-static march.
    pub holds: u64,
}

/// An estimate of the upper end of a spectrum.
#[derive(Clone, Copy, Debug)]
pub struct Spectrum {
    /// Largest Ritz value, never above the true eigenvalue \[1/T²\].
    pub ritz: f64,
    /// Norm of its residual: an eigenvalue lies within this distance \[1/T²\].
    pub residual: f64,
}

impl Spectrum {
    /// Ritz value plus residual, the value the step is taken from.
    pub fn bound(&self) -> f64 {
        self.ritz + self.residual
    }
}

/// Largest eigenvalue by `iterations` Lanczos steps (\[lanczos1950\]) from a fixed pseudo-random vector.
///
/// About [`LANCZOS_STEPS`] give four digits on shell clouds. No reorthogonalisation: ghosts of converged
/// values do not move the largest one.
pub fn largest_eigenvalue(system: &mut dyn LinearisedDynamics, iterations: usize) -> Spectrum {
    let n = system.unknowns();
    let mut v = pseudo_random(n);
    let length = system.dot(&v, &v).sqrt();
    v.iter_mut().for_each(|x| *x *= 1.0 / length);
    let mut previous = vec![0.0; n];
    let mut w = vec![0.0; n];
    let (mut alpha, mut beta) = (Vec::new(), Vec::new());
    for _ in 0..iterations.min(n).max(1) {
        system.apply(&v, &mut w);
        let a = system.dot(&v, &w);
        let b_last = beta.last().copied().unwrap_or(0.0);
        for i in 0..n {
            w[i] -= a * v[i] + b_last * previous[i];
        }
        alpha.push(a);
        let b = system.dot(&w, &w).sqrt();
        beta.push(b);
        // The space is exhausted when the remainder is round-off of the values found so far.
        if b <= 1e-12 * a.abs() || !b.is_finite() {
            break;
        }
        std::mem::swap(&mut previous, &mut v);
        for i in 0..n {
            v[i] = w[i] / b;
        }
    }
    top_ritz_value(&alpha, &beta)
}

/// `safety × 2/√λ_max`, the largest stable step of central differences times a stated safety, from the spectrum of the
/// present tangent.
///
/// # Errors
/// [`MarchError::NoStableStep`] if the estimate is not positive and finite.
pub fn lanczos_step(system: &mut dyn LinearisedDynamics, safety: f64) -> Result<StableStep, MarchError> {
    let bound = largest_eigenvalue(system, LANCZOS_STEPS).bound();
    if bound > 0.0 && bound.is_finite() {
        Ok(StableStep { dt: safety * 2.0 / bound.sqrt(), holds: HOLDS })
    } else {
        Err(MarchError::NoStableStep(bound))
    }
}

fn top_ritz_value(alpha: &[f64], beta: &[f64]) -> Spectrum {
    let m = alpha.len();
    let last = beta[m - 1];
    if alpha.iter().chain(beta).any(|x| !x.is_finite()) {
        return Spectrum { ritz: f64::NAN, residual: f64::NAN };
    }
    let tridiagonal = DMatrix::from_fn(m, m, |i, j| match i.abs_diff(j) {
        0 => alpha[i],
        1 => beta[i.min(j)],
        _ => 0.0,
    });
    let eigen = SymmetricEigen::new(tridiagonal);
    let (top, ritz) = eigen
        .eigenvalues
        .iter()
        .copied()
        .enumerate()
        .fold((0, f64::MIN), |best, (i, x)| if x > best.1 { (i, x) } else { best });
    Spectrum { ritz, residual: (last * eigen.eigenvectors[(m - 1, top)]).abs() }
}

/// The same numbers in (−½, ½) on every machine (SplitMix64 of \[steele2014\]).
fn pseudo_random(n: usize) -> Vec<f64> {
    let mut state = 0x9E37_79B9_7F4A_7C15_u64;
    let mut next = || {
        state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = state;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^= z >> 31;
        (z >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
    };
    (0..n).map(|_| next()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The second and third number of the generator from zero, as its authors' program prints them: 6e789e6aa1b965f4, 06c45d188009454f.
    #[test]
    fn the_numbers_are_those_of_the_generator() {
        let [first, second] = [0x6E78_9E6A_A1B9_65F4_u64, 0x06C4_5D18_8009_454F];
        let expected = [first, second].map(|bits| (bits >> 11) as f64 * 2_f64.powi(-53) - 0.5);
        assert_eq!(pseudo_random(2), expected);
    }

    /// A chain of unit masses and springs: eigenvalues `2 − 2cos(kπ/(n+1))`.
    struct Chain(usize);

    impl LinearisedDynamics for Chain {
        fn unknowns(&self) -> usize {
            self.0
        }
        fn apply(&mut self, v: &[f64], out: &mut [f64]) {
            for i in 0..self.0 {
                let left = if i > 0 { v[i - 1] } else { 0.0 };
                let right = if i + 1 < self.0 { v[i + 1] } else { 0.0 };
                out[i] = 2.0 * v[i] - left - right;
            }
        }
    }

    #[test]
    fn chain_spectrum_is_bounded_from_both_sides() {
        for n in [1, 2, 5, 40, 400] {
            let exact = 2.0 - 2.0 * libm::cos(std::f64::consts::PI * n as f64 / (n as f64 + 1.0));
            let found = largest_eigenvalue(&mut Chain(n), LANCZOS_STEPS);
            assert!(found.ritz <= exact * (1.0 + 1e-12), "n = {n}: {found:?} against {exact}");
            // A chain is the hard case (its spectrum is dense at the top): 30 steps leave 1 % at n = 400.
            assert!(found.bound() >= exact * 0.99, "n = {n}: {found:?} against {exact}");
        }
    }

    #[test]
    fn a_spectrum_without_positive_values_gives_no_step() {
        struct Slack;
        impl LinearisedDynamics for Slack {
            fn unknowns(&self) -> usize {
                3
            }
            fn apply(&mut self, _: &[f64], out: &mut [f64]) {
                out.fill(0.0);
            }
        }
        assert_eq!(lanczos_step(&mut Slack, 0.8), Err(MarchError::NoStableStep(0.0)));
    }
}
