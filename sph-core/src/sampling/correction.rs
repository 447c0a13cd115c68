//! Corrections: shape numbers that differentiate polynomials exactly whatever the arrangement of the particles.

use nalgebra::{DMatrix, DVector};

use crate::error::SpaceError;
use crate::kernel::Kernel;

/// Largest condition number (in the 1-norm) of a moment matrix that is accepted: half the digits of `f64`.
const CONDITION_BOUND: f64 = 1e7;

/// Particles around a point, in the point's tangent plane.
#[derive(Clone, Copy, Debug)]
pub struct Neighbourhood<'a> {
    /// First coordinates about the point `[L]`.
    pub xi: &'a [f64],
    /// Second coordinates about the point `[L]`.
    pub eta: &'a [f64],
    /// Kernel weights, of any unit.
    pub weights: &'a [f64],
    /// Length `[L]` that makes the coordinates of order one, such as h.
    pub scale: f64,
}

/// Shape numbers of a stencil, in the order of its neighbourhood.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// Value numbers φ, dimensionless.
    pub phi: Vec<f64>,
    /// Gradient numbers along the first coordinate `[1/L]`.
    pub g1: Vec<f64>,
    /// Gradient numbers along the second coordinate `[1/L]`.
    pub g2: Vec<f64>,
}

/// Turns kernel weights into shape numbers that are exact on polynomials.
pub trait Correction: Send + Sync {
    /// Name by which scenes and tables call the correction.
    fn name(&self) -> &'static str;

    /// Degree of the polynomials that are differentiated exactly.
    fn order(&self) -> u8;

    /// Smallest number of particles in a neighbourhood.
    fn needed(&self) -> usize;

    /// Weight of a particle at distance `r` for smoothing length `h` (both `[L]`); the scale is free.
    fn weight(&self, kernel: &dyn Kernel, r: f64, h: f64) -> f64;

    /// Shape numbers; none if the particles do not determine them well (too few, on a line, condition above 1e7).
    fn shape(&self, near: &Neighbourhood) -> Option<Shape>;
}

/// Moving least squares of order 1 at any point \[belytschko1996\]: with `p_b = (1, ξ_b/s, η_b/s)` and `𝓜 = Σ W_b p_b p_bᵀ`,
/// `φ_b = W_b e₁ᵀ𝓜⁻¹p_b`, `G₁_b = W_b e₂ᵀ𝓜⁻¹p_b / s`, `G₂_b = W_b e₃ᵀ𝓜⁻¹p_b / s`.
#[derive(Clone, Copy, Debug)]
pub struct LinearlyExact;

/// Weighted least squares through a particle: the first of the neighbourhood is the particle a itself, and
/// `f_b − f_a ≈` polynomial of `order` without constant.
///
/// Order 1 with the weight −W'/r is the corrective smoothed particle method \[chen1999\] in its symmetric form; higher
/// orders weigh with W. φ is 1 at the particle and 0 elsewhere.
#[derive(Clone, Copy, Debug)]
pub struct ThroughParticle {
    order: u8,
}

impl ThroughParticle {
    /// Correction of order 1, 2 or 3.
    pub fn new(order: usize) -> Result<ThroughParticle, SpaceError> {
        match order {
            1..=3 => Ok(ThroughParticle { order: order as u8 }),
            _ => Err(SpaceError::OutOfRange { what: "order", value: order as f64, bound: "1, 2, 3" }),
        }
    }
}

/// Every correction of the crate; a new one is added here.
pub fn corrections() -> [&'static dyn Correction; 4] {
    const THROUGH: [ThroughParticle; 3] =
        [ThroughParticle { order: 1 }, ThroughParticle { order: 2 }, ThroughParticle { order: 3 }];
    [&LinearlyExact, &THROUGH[0], &THROUGH[1], &THROUGH[2]]
}

impl Correction for LinearlyExact {
    fn name(&self) -> &'static str {
        "linearly-exact"
    }

    fn order(&self) -> u8 {
        1
    }

    /// Three would do, but four make a stencil that leans to no side of a lattice.
    fn needed(&self) -> usize {
        4
    }

    fn weight(&self, kernel: &dyn Kernel, r: f64, h: f64) -> f64 {
        kernel.value(r / h)
    }

    fn shape(&self, near: &Neighbourhood) -> Option<Shape> {
        let m = near.xi.len();
        if m < self.needed() {
            return None;
        }
        let basis = DMatrix::from_fn(3, m, |k, b| match k {
            0 => 1.0,
            1 => near.xi[b] / near.scale,
            _ => near.eta[b] / near.scale,
        });
        let [phi, g1, g2] = reproduce(&basis, near.weights, [0, 1, 2])?;
        let unscaled = |g: Vec<f64>| g.iter().map(|g| g / near.scale).collect();
        Some(Shape { phi, g1: unscaled(g1), g2: unscaled(g2) })
    }
}

impl Correction for ThroughParticle {
    fn name(&self) -> &'static str {
        ["through-particle-1", "through-particle-2", "through-particle-3"][usize::from(self.order) - 1]
    }

    fn order(&self) -> u8 {
        self.order
    }

    /// The particle itself and one neighbour for each monomial.
    fn needed(&self) -> usize {
        1 + monomials(self.order).len()
    }

    fn weight(&self, kernel: &dyn Kernel, r: f64, h: f64) -> f64 {
        match self.order {
            1 => -kernel.slope(r / h) / r,
            _ => kernel.value(r / h),
        }
    }

    fn shape(&self, near: &Neighbourhood) -> Option<Shape> {
        let m = near.xi.len();
        if m < self.needed() {
            return None;
        }
        let powers = monomials(self.order);
        let basis = DMatrix::from_fn(powers.len(), m - 1, |k, b| {
            let (xi, eta) = (near.xi[b + 1] / near.scale, near.eta[b + 1] / near.scale);
            xi.powi(powers[k].0) * eta.powi(powers[k].1)
        });
        let [g1, g2] = reproduce(&basis, &near.weights[1..], [0, 1])?;
        let with_itself = |g: Vec<f64>| {
            let others = g.iter().map(|g| g / near.scale);
            std::iter::once(-others.clone().sum::<f64>()).chain(others).collect()
        };
        let mut phi = vec![0.0; m];
        phi[0] = 1.0;
        Some(Shape { phi, g1: with_itself(g1), g2: with_itself(g2) })
    }
}

/// Exponents (of ξ, of η) of the monomials of degree 1 to `order`, lowest degree first.
pub(crate) fn monomials(order: u8) -> Vec<(i32, i32)> {
    let order = i32::from(order);
    (1..=order).flat_map(|degree| (0..=degree).map(move |j| (degree - j, j))).collect()
}

/// Weighted least-squares numbers `c_b = W_b p_bᵀ𝓜⁻¹e` for some unit vectors e: `Σ_b p_b c_b = e` to rounding.
///
/// One step of iterative refinement removes the error of the normal equations.
fn reproduce<const N: usize>(
    basis: &DMatrix<f64>,
    weights: &[f64],
    units: [usize; N],
) -> Option<[Vec<f64>; N]> {
    let total: f64 = weights.iter().sum();
    let weighted = DMatrix::from_fn(basis.nrows(), basis.ncols(), |k, b| basis[(k, b)] * weights[b] / total);
    let moments = &weighted * basis.transpose();
    let inverse = moments.clone().cholesky()?.inverse();
    let norm = |a: &DMatrix<f64>| a.column_iter().map(|c| c.abs().sum()).fold(0.0, f64::max);
    let condition = norm(&moments) * norm(&inverse);
    if condition.is_nan() || condition > CONDITION_BOUND {
        return None;
    }
    Some(units.map(|unit| {
        let target = DVector::from_fn(basis.nrows(), |k, _| if k == unit { 1.0 } else { 0.0 });
        let mut numbers = weighted.tr_mul(&(&inverse * &target));
        let missing = target - basis * &numbers;
        numbers += weighted.tr_mul(&(&inverse * missing));
        numbers.as_slice().to_vec()
    }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::CubicSpline;
    use approx::assert_abs_diff_eq;
    use proptest::prelude::*;
    use proptest::test_runner::RngSeed;

    proptest! {
        #![proptest_config(ProptestConfig { rng_seed: RngSeed::Fixed(1), failure_persistence: None, ..ProptestConfig::default() })]

        /// Disordered 5×5 patch: every correction differentiates every monomial up to its order.
        #[test]
        fn every_correction_is_exact_up_to_its_order(noise in prop::collection::vec(-0.3..0.3f64, 50), size in 0.01..100.0f64) {
            let mut xi = vec![0.0];
            let mut eta = vec![0.0];
            for i in 0..25 {
                if i != 12 {
                    xi.push(size * ((i / 5) as f64 - 2.0 + noise[2 * i]));
                    eta.push(size * ((i % 5) as f64 - 2.0 + noise[2 * i + 1]));
                }
            }
            let h = 1.6 * size;
            for correction in corrections() {
                let weights: Vec<f64> = xi.iter().zip(&eta)
                    .map(|(x, y): (&f64, &f64)| correction.weight(&CubicSpline, libm::hypot(*x, *y).max(1e-3 * size), h))
                    .collect();
                let near = Neighbourhood { xi: &xi, eta: &eta, weights: &weights, scale: h };
                let shape = correction.shape(&near).unwrap();
                let sum = |numbers: &[f64], i: i32, j: i32| -> f64 {
                    (0..xi.len()).map(|b| numbers[b] * (xi[b] / h).powi(i) * (eta[b] / h).powi(j)).sum()
                };
                let name = correction.name();
                assert_abs_diff_eq!(sum(&shape.phi, 0, 0), 1.0, epsilon = 1e-12);
                assert_abs_diff_eq!(sum(&shape.phi, 1, 0), 0.0, epsilon = 1e-12);
                assert_abs_diff_eq!(sum(&shape.g1, 0, 0) * h, 0.0, epsilon = 1e-12);
                for (i, j) in monomials(correction.order()) {
                    let (slope1, slope2) = (f64::from((i, j) == (1, 0)), f64::from((i, j) == (0, 1)));
                    prop_assert!((sum(&shape.g1, i, j) * h - slope1).abs() < 1e-12, "{name} ξ^{i} η^{j}");
                    prop_assert!((sum(&shape.g2, i, j) * h - slope2).abs() < 1e-12, "{name} ξ^{i} η^{j}");
                }
            }
        }
    }

    #[test]
    fn particles_on_a_line_determine_nothing() {
        let xi: Vec<f64> = (0..20).map(f64::from).collect();
        let eta = vec![0.0; 20];
        let weights = vec![1.0; 20];
        for correction in corrections() {
            let near = Neighbourhood { xi: &xi, eta: &eta, weights: &weights, scale: 10.0 };
            assert_eq!(correction.shape(&near), None, "{}", correction.name());
            let few = correction.needed() - 1;
            let near =
                Neighbourhood { xi: &xi[..few], eta: &eta[..few], weights: &weights[..few], scale: 1.0 };
            assert_eq!(correction.shape(&near), None, "{}", correction.name());
        }
    }

    #[test]
    fn orders_beyond_three_are_refused() {
        assert!(ThroughParticle::new(0).is_err() && ThroughParticle::new(4).is_err());
        assert_eq!(ThroughParticle::new(3).map(|c| c.needed()), Ok(10));
    }
}
