//! The slow modes of a motion, found on the way, and made faster.
//!
//! Let Z hold a few motions, M-orthonormal, with `ZᵀKZ = diag(ω²)`. In place of `M⁻¹` stands
//!
//! ```text
//! M̃⁻¹ = M⁻¹ + Z diag(ω_c²/ω² − 1) Zᵀ          ω_c² the greatest of the ω²
//! ```
//!
//! Where the motions are modes they all swing with ω_c: their masses are less. Where they are not, nothing is lost: the largest
//! eigenvalue of `M̃⁻¹K` is at most that of `M⁻¹K` and ω_c² together, whatever the motions, as long as the ω² are theirs. This
//! is a coarse space \[nicolaides1987\] of Ritz vectors of moves that the motion makes anyway: what
//! is left of it after a while is slow. The motion begins again from rest whenever the modes are found anew.

use serde::{Deserialize, Serialize};

use crate::dense::dense_eigen;
use crate::vectors::dot;

/// Modes kept. A panel of 21×21 particles takes 8350 evaluations in 26 levels with 6, 6060 with 12, 5040 with 20.
const KEPT: usize = 12;
/// Bound of ω_c² \[–\]: about what the safety of the masses leaves below 4.
const FASTEST: f64 = 0.25;
/// Least part of ω_c² that an ω² counts as: beyond, the state has next to no stiffness along the mode.
const LEAST: f64 = 1e-5;
/// Part of a move that is not in the span of those before, below which it adds nothing.
const DEPENDENT: f64 = 1e-3;

/// Modes with their Rayleigh quotients, and moves that are not among them yet.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct SlowModes {
    /// Z, one mode after the other, then the moves.
    span: Vec<Vec<f64>>,
    /// ω_c²/ω² − 1 of each mode.
    shares: Vec<f64>,
    /// z·Mv of each, v the velocity of the motion.
    impulses: Vec<f64>,
}

impl SlowModes {
    /// Whether any is known.
    pub fn known(&self) -> bool {
        !self.shares.is_empty()
    }

    /// Lengths of the modes and moves.
    pub fn lengths(&self) -> impl Iterator<Item = usize> {
        self.span.iter().map(Vec::len)
    }

    /// Takes a move to look for modes in.
    pub fn sample(&mut self, motion: &[f64]) {
        self.span.push(motion.to_vec());
    }

    /// `out += (M̃⁻¹ − M⁻¹) force`, for a velocity that becomes `keeps v + takes out`.
    pub fn deflate(&mut self, force: &[f64], out: &mut [f64], (keeps, takes): (f64, f64)) {
        for ((mode, share), impulse) in self.span.iter().zip(&self.shares).zip(&mut self.impulses) {
            let part = dot(mode, force);
            *impulse = keeps * *impulse + takes * (1.0 + share) * part;
            out.iter_mut().zip(mode).for_each(|(out, z)| *out += share * part * z);
        }
    }

    /// `v·Mv − v·M̃v` of that velocity.
    pub fn lightness(&self) -> f64 {
        let of = |(share, impulse): (&f64, &f64)| share / (1.0 + share) * impulse.powi(2);
        self.shares.iter().zip(&self.impulses).map(of).sum()
    }

    /// Finds the modes in the span of those before and of the moves taken since (Rayleigh–Ritz). `image` applies the tangent of
    /// the present state.
    pub fn renew(&mut self, masses: &[f64], mut image: impl FnMut(&[f64], &mut [f64])) {
        let basis = orthonormal(std::mem::take(&mut self.span), masses);
        let size = basis.len();
        let mut projected = vec![0.0; size * size];
        let mut out = vec![0.0; masses.len()];
        for (j, vector) in basis.iter().enumerate() {
            image(vector, &mut out);
            for (i, other) in basis.iter().enumerate() {
                let half = 0.5 * dot(other, &out);
                projected[i + j * size] += half;
                projected[j + i * size] += half;
            }
        }
        self.shares.clear();
        if size == 0 || projected.iter().any(|value| !value.is_finite()) {
            return;
        }
        let (squares, shares) = dense_eigen(size, &projected);
        let kept = size.min(KEPT);
        let fastest = squares[kept - 1].clamp(0.0, FASTEST);
        for mode in 0..kept {
            let mut sum = vec![0.0; masses.len()];
            for (i, vector) in basis.iter().enumerate() {
                let share = shares[i + mode * size];
                sum.iter_mut().zip(vector).for_each(|(sum, x)| *sum += share * x);
            }
            self.span.push(sum);
            // a mode that softens or buckles moves on as one of little stiffness would: away from where it was
            let square = squares[mode].abs().max(LEAST * fastest).max(f64::MIN_POSITIVE);
            self.shares.push((fastest / square - 1.0).max(0.0));
        }
        self.impulses = vec![0.0; kept];
    }
}

/// An M-orthonormal basis of the span of some vectors (Gram and Schmidt, twice).
fn orthonormal(vectors: Vec<Vec<f64>>, masses: &[f64]) -> Vec<Vec<f64>> {
    let product = |a: &[f64], b: &[f64]| -> f64 { (0..a.len()).map(|i| masses[i] * a[i] * b[i]).sum() };
    let scaled = |mut v: Vec<f64>, size: f64| {
        v.iter_mut().for_each(|x| *x /= size);
        v
    };
    let mut basis: Vec<Vec<f64>> = Vec::new();
    for vector in vectors {
        let size = product(&vector, &vector).sqrt();
        if size == 0.0 || !size.is_finite() {
            continue;
        }
        let mut vector = scaled(vector, size);
        for _ in 0..2 {
            for known in &basis {
                let part = product(known, &vector);
                vector.iter_mut().zip(known).for_each(|(v, known)| *v -= part * known);
            }
        }
        let left = product(&vector, &vector).sqrt();
        if left > DEPENDENT {
            basis.push(scaled(vector, left));
        }
    }
    basis
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Springs of stiffness one between nine masses of two, held at both ends: ω² = 2 sin²(kπ/20).
    fn chain(v: &[f64], out: &mut [f64]) {
        for i in 0..v.len() {
            let at = |j: Option<usize>| j.and_then(|j| v.get(j)).copied().unwrap_or(0.0);
            out[i] = 2.0 * v[i] - at(i.checked_sub(1)) - at(Some(i + 1));
        }
    }

    fn wave(number: usize) -> Vec<f64> {
        (1..=9).map(|i| libm::sin(std::f64::consts::PI * (number * i) as f64 / 10.0)).collect()
    }

    #[test]
    fn modes_in_the_span_are_found_and_swing_alike() {
        let (masses, mut slow) = ([2.0; 9], SlowModes::default());
        let sum = |a: &[f64], b: &[f64]| -> Vec<f64> { a.iter().zip(b).map(|(a, b)| a + 0.3 * b).collect() };
        slow.sample(&sum(&wave(1), &wave(2)));
        slow.sample(&sum(&wave(2), &wave(1)));
        slow.sample(&sum(&wave(1), &wave(2)));
        slow.renew(&masses, chain);
        let square = |number: f64| 2.0 * libm::sin(number * std::f64::consts::PI / 20.0).powi(2);
        assert_eq!(slow.shares.len(), 2);
        assert!(
            (slow.shares[0] - (square(2.0) / square(1.0) - 1.0)).abs() < 1e-12
                && slow.shares[1].abs() < 1e-12
        );
        // K φ as a force: both modes answer by ω_c² φ, the third as it would anyway.
        for (number, expected) in [(1, square(2.0)), (2, square(2.0)), (3, square(3.0))] {
            let (mut force, mode) = ([0.0; 9], wave(number));
            chain(&mode, &mut force);
            let mut out = force.map(|force| force / 2.0);
            slow.deflate(&force, &mut out, (0.0, 1.0));
            for (out, x) in out.iter().zip(&mode) {
                assert!((out - expected * x).abs() < 1e-12, "{number}: {out} {x}");
            }
            // v·M̃v of the velocity `out`, by M̃v = force.
            let [heavy, light] = [out.iter().map(|v| 2.0 * v * v).sum::<f64>(), dot(&out, &force)];
            assert!((heavy - slow.lightness() - light).abs() < 1e-12);
        }
    }
}
