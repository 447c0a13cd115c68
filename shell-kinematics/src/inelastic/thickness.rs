//! Thickness and stretch at the last commit: how far a height lies from the mid-surface, and what a curvature strains there.
//!
//! The strain at the height z, at rest, is `h + z F K` as long as F stays what it is: h the logarithmic strain of the mid-surface, K the change of curvature freed of stretch, and F
//! what makes of it a curvature per present length times the present lever arm,
//!
//! ```text
//! F = λ₃ [[A, 0, ½c], [0, B, ½c], [c, c, ½(A+B)]]     U⁻¹ = [[A, c], [c, B]] = exp(−h)
//! ```
//!
//! with λ₃, present thickness over thickness at rest, and U⁻¹ of the last commit, so that a step has a potential. Strains at a height add up from step to
//! step, `h + z (F K + g)` with `g ← g + (F − F') K` where a commit changes F to F': a commit alone strains nothing, so that neither the balance of a state
//! nor its energy jumps. What that leaves out is z K dF, of the size of z K times the stretch beside it.

use super::functions::{exp, polynomial};
use crate::pack::Number;

/// Numbers of a history that it takes: λ₃ − 1, 11, 22, 12 of U⁻¹ − 1, and g.
pub(super) const NUMBERS: usize = 7;

/// λ₃, U⁻¹ and g of a committed history.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lever<P> {
    pub thickness: P,
    a: P,
    b: P,
    c: P,
    /// g \[1/L\].
    before: [P; 3],
}

impl<P: Number> Lever<P> {
    /// From the numbers of a history.
    #[inline(always)]
    pub fn read([thinning, a, b, c, g0, g1, g2]: [P; NUMBERS]) -> Self {
        let one = thinning.all(1.0);
        Self { thickness: thinning + one, a: a + one, b: b + one, c, before: [g0, g1, g2] }
    }

    /// `F K + g`, by which strains grow with the height.
    #[inline(always)]
    pub fn slope(&self, curvature: &[P; 3]) -> [P; 3] {
        let [s0, s1, s2] = self.strains(curvature);
        let [g0, g1, g2] = self.before;
        [s0 + g0, s1 + g1, s2 + g2]
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

impl<P: Number> Lever<P> {
    /// The numbers of the next history, whose strains at all heights are the same.
    #[inline(always)]
    pub fn next(&self, log_thickness: P, h: &[P; 3], curvature: &[P; 3]) -> [P; NUMBERS] {
        let zero = log_thickness.all(0.0);
        let [thinning, a, b, c] = levers(log_thickness, h);
        let next = Self::read([thinning, a, b, c, zero, zero, zero]);
        let ([s0, s1, s2], [n0, n1, n2]) = (self.slope(curvature), next.strains(curvature));
        [thinning, a, b, c, s0 - n0, s1 - n1, s2 - n2]
    }
}

/// λ₃ − 1 and 11, 22, 12 of exp(−h) − 1, for ln λ₃ and a logarithmic strain 11, 22, 2·12.
///
/// With m the mean of the principal strains and ρ half their difference, `exp(−h) = e^−m (cosh ρ − (sinh ρ/ρ)(h − m))`. The functions of
/// ρ are even: their series in ρ² at ρ/4, doubled twice, are exact to rounding up to ρ = 4.
#[inline(always)]
fn levers<P: Number>(log_thickness: P, h: &[P; 3]) -> [P; 4] {
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
            let [_, a, b, c] = levers(0.0, &h);
            let apart = [a + 1.0 - exact[(0, 0)], b + 1.0 - exact[(1, 1)], c - exact[(0, 1)]];
            worst = apart.into_iter().fold(worst, |most, apart| most.max(apart.abs() / exact.norm()));
        }
        println!("{worst:.1e}");
        // 4.4e-16: rounding.
        assert!(worst < 2e-15, "{worst:.1e}");
        assert_eq!(levers(0.0, &[0.0; 3]).map(f64::abs), [0.0; 4]);
    }

    /// A commit moves no strain at a height.
    #[test]
    fn a_commit_strains_nothing() {
        let (k, h) = ([0.3, -0.7, 1.1], [0.2, -0.1, 0.15]);
        let lever = Lever::read([-0.1, 0.2, -0.3, 0.15, 0.05, -0.02, 0.01]);
        let next = Lever::read(lever.next(-0.3, &h, &k));
        for (before, after) in lever.slope(&k).into_iter().zip(next.slope(&k)) {
            assert!((before - after).abs() < 1e-15, "{before} {after}");
        }
        assert!((lever.thickness - next.thickness).abs() > 0.1);
    }

    #[test]
    fn moments_are_the_transpose_of_strains() {
        let lever = Lever::read([-0.1, 0.2, -0.3, 0.15, 0.0, 0.0, 0.0]);
        let (k, m) = ([0.3, -0.7, 1.1], [0.2, 0.9, -0.4]);
        let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        assert!((dot(lever.strains(&k), m) - dot(k, lever.moments(&m))).abs() < 1e-15);
    }
}
