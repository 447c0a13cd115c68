//! Thickness and stretch at the last commit: how far a height lies from the mid-surface, and what a curvature strains there.
//!
//! The strain at the height z, at rest, is `h + z F K`: h the logarithmic strain of the mid-surface, K the change of curvature freed of stretch, and F
//! what makes of it a curvature per present length times the present lever arm,
//!
//! ```text
//! F = λ₃ [[A, 0, ½c], [0, B, ½c], [c, c, ½(A+B)]]     U⁻¹ = [[A, c], [c, B]] = exp(−h)
//! ```
//!
//! with λ₃, present thickness over thickness at rest, and U⁻¹ of the last commit, so that a step has a potential.

use super::functions::{exp, polynomial};
use crate::pack::Number;

/// Numbers of a history that it takes.
pub(super) const NUMBERS: usize = 4;

/// λ₃ and U⁻¹ of a committed history.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lever<P> {
    pub thickness: P,
    a: P,
    b: P,
    c: P,
}

impl<P: Number> Lever<P> {
    /// From λ₃ − 1 and 11, 22, 12 of U⁻¹ − 1.
    #[inline(always)]
    pub fn read([thinning, a, b, c]: [P; NUMBERS]) -> Self {
        let one = thinning.all(1.0);
        Self { thickness: thinning + one, a: a + one, b: b + one, c }
    }

    /// `F K`.
    #[inline(always)]
    pub fn strains(&self, [k11, k22, k12]: &[P; 3]) -> [P; 3] {
        let [half, mean] = [*k12 * self.c * 0.5, (self.a + self.b) * 0.5];
        [
            (self.a * *k11 + half) * self.thickness,
            (self.b * *k22 + half) * self.thickness,
            (self.c * (*k11 + *k22) + mean * *k12) * self.thickness,
        ]
    }

    /// `Fᵀ m`.
    #[inline(always)]
    pub fn moments(&self, [m11, m22, m12]: &[P; 3]) -> [P; 3] {
        [
            (self.a * *m11 + self.c * *m12) * self.thickness,
            (self.b * *m22 + self.c * *m12) * self.thickness,
            (self.c * (*m11 + *m22) + (self.a + self.b) * *m12) * self.thickness * 0.5,
        ]
    }
}

/// Of cosh − 1, `1/(2k)!`, and of sinh ρ/ρ, `1/(2k+1)!`, the highest first.
const HYPERBOLIC: [[f64; 9]; 2] = [
    [
        1.0 / 20_922_789_888_000.0,
        1.0 / 87_178_291_200.0,
        1.0 / 479_001_600.0,
        1.0 / 3_628_800.0,
        1.0 / 40_320.0,
        1.0 / 720.0,
        1.0 / 24.0,
        1.0 / 2.0,
        0.0,
    ],
    [
        1.0 / 355_687_428_096_000.0,
        1.0 / 1_307_674_368_000.0,
        1.0 / 6_227_020_800.0,
        1.0 / 39_916_800.0,
        1.0 / 362_880.0,
        1.0 / 5_040.0,
        1.0 / 120.0,
        1.0 / 6.0,
        1.0,
    ],
];

/// The numbers of a history for ln λ₃ and a logarithmic strain 11, 22, 2·12: λ₃ − 1 and 11, 22, 12 of exp(−h) − 1.
///
/// With m the mean of the principal strains and ρ half their difference, `exp(−h) = e^−m (cosh ρ − (sinh ρ/ρ)(h − m))`. The functions of
/// ρ are even: their series in ρ² at ρ/4, doubled twice, are exact to rounding up to ρ = 4.
#[inline(always)]
pub(super) fn numbers<P: Number>(log_thickness: P, h: &[P; 3]) -> [P; NUMBERS] {
    let one = log_thickness.all(1.0);
    let [mean, half, shear] = [(h[0] + h[1]) * 0.5, (h[0] - h[1]) * 0.5, h[2] * 0.5];
    let q = (half * half + shear * shear) * (1.0 / 16.0);
    let [mut rise, mut ratio] = [polynomial(q, &HYPERBOLIC[0]), polynomial(q, &HYPERBOLIC[1])];
    for _ in 0..2 {
        ratio = ratio * (rise + one);
        rise = rise * (rise + one * 2.0) * 2.0;
    }
    let cosh = rise + one;
    let scale = exp(mean * -1.0);
    [
        exp(log_thickness) - one,
        scale * (cosh - ratio * half) - one,
        scale * (cosh + ratio * half) - one,
        scale * ratio * shear * -1.0,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `exp(−h)` by the eigenvectors of h.
    #[test]
    fn the_inverse_stretch_is_the_exponential() {
        type Square = nalgebra::Matrix2<f64>;
        let mut worst = 0.0_f64;
        for h in [[0.3, -0.1, 0.2], [1e-9, 2e-9, -1e-9], [1.0, -1.0, 3.0], [2.0, 2.0, 0.0], [-0.5, 0.4, 0.0]]
        {
            let eigen = Square::new(h[0], 0.5 * h[2], 0.5 * h[2], h[1]).symmetric_eigen();
            let stretches = Square::from_diagonal(&eigen.eigenvalues.map(|value: f64| libm::exp(-value)));
            let exact = eigen.eigenvectors * stretches * eigen.eigenvectors.transpose();
            let [_, a, b, c] = numbers(0.0, &h);
            let apart = [a + 1.0 - exact[(0, 0)], b + 1.0 - exact[(1, 1)], c - exact[(0, 1)]];
            worst = apart.into_iter().fold(worst, |most, apart| most.max(apart.abs() / exact.norm()));
        }
        println!("{worst:.1e}");
        // 4.4e-16: rounding.
        assert!(worst < 2e-15, "{worst:.1e}");
        assert_eq!(numbers(0.0, &[0.0; 3]).map(f64::abs), [0.0; 4]);
    }

    #[test]
    fn moments_are_the_transpose_of_strains() {
        let lever = Lever::read([-0.1, 0.2, -0.3, 0.15]);
        let (k, m) = ([0.3, -0.7, 1.1], [0.2, 0.9, -0.4]);
        let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        assert!((dot(lever.strains(&k), m) - dot(k, lever.moments(&m))).abs() < 1e-15);
    }
}
