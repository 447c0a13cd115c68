//! Strain measures, each with its transpose: Green–Lagrange and the stretch-corrected curvature.

use std::any::Any;

use crate::pack::{Number, Pack};
use crate::placement::{MeasureForces, Measures};
use crate::strains::{Resultants, Strains};
use crate::tangent::{Matrix8, ZERO8};

/// How the [`Measures`] of a point become strains.
///
/// `strains` and `transpose` are written together: `transpose` is the derivative of `strains`,
/// transposed, and a test compares the two by differences for every measure of [`crate::strain_measures`].
pub trait StrainMeasure: Any + Send + Sync {
    /// Name used in scenes.
    fn name(&self) -> &'static str;

    /// One line for people.
    fn describe(&self) -> &'static str;

    /// Strains from current and reference measures.
    fn strains(&self, now: &Measures, reference: &Measures) -> Strains;

    /// Forces on the measures from resultants conjugate to the strains.
    fn transpose(&self, now: &Measures, reference: &Measures, stress: &Resultants) -> MeasureForces;

    /// `J = ∂ε/∂m`, the matrix whose transpose [`StrainMeasure::transpose`] applies.
    fn gradient(&self, now: &Measures, reference: &Measures) -> Matrix8;

    /// `Σ σ ∂²ε/∂m²`, symmetric.
    fn second_gradient(&self, now: &Measures, reference: &Measures, stress: &Resultants) -> Matrix8;
}

/// The formulas of a [`StrainMeasure`] for numbers of one kind.
///
/// Any measure has them for packs; one that is written for any [`Number`] runs in whatever registers a caller brings.
pub trait StrainsOf<P> {
    /// [`StrainMeasure::strains`].
    fn strains_of(&self, now: &Measures<P>, reference: &Measures<P>) -> Strains<P>;

    /// [`StrainMeasure::transpose`].
    fn transpose_of(
        &self,
        now: &Measures<P>,
        reference: &Measures<P>,
        stress: &Resultants<P>,
    ) -> MeasureForces<P>;
}

impl StrainsOf<Pack> for dyn StrainMeasure {
    #[inline(always)]
    fn strains_of(&self, now: &Measures, reference: &Measures) -> Strains {
        self.strains(now, reference)
    }

    #[inline(always)]
    fn transpose_of(&self, now: &Measures, reference: &Measures, stress: &Resultants) -> MeasureForces {
        self.transpose(now, reference, stress)
    }
}

fn unit_matrix() -> Matrix8 {
    std::array::from_fn(|i| std::array::from_fn(|j| Pack::splat(if i == j { 1.0 } else { 0.0 })))
}

/// The paper's split `E = E_m + ζ E_f` of the Green–Lagrange tensor (\[lin2013\] §3).
///
/// `κ_αβ` is the change of `x,(α·d,β)`. It mixes stretch into curvature: a strip of thickness t rolled
/// to the curvature k carries `M = EIk(1 − (kt)²/6)` and shrinks to `λ² = 1 − (kt)²/6`, whatever the
/// particles do. At t/L = 0.1 that moves the tip of the closed ring by 7.34 % of L.
#[derive(Clone, Copy, Debug, Default)]
pub struct GreenLagrange;

/// Green–Lagrange membrane strain with the curvature freed of stretch to first order.
///
/// `κ11 = k11 − k11⁰ − (e11 k11 + ¼ g k12)`, `κ22` likewise, `κ12 = k12 − k12⁰ − ½[(e11+e22) k12 + g (k11+k22)]`
/// with current totals `k` and `g = 2e12`: the mixed change of curvature that results from dividing `x,α·d,β`
/// by the stretch. It makes the exact circle an exact solution of the strip under an end couple. Membrane
/// strain is assumed small.
#[derive(Clone, Copy, Debug, Default)]
pub struct StretchCorrected;

impl StrainMeasure for GreenLagrange {
    fn name(&self) -> &'static str {
        "green-lagrange"
    }

    fn describe(&self) -> &'static str {
        "the paper's split E = E_m + ζE_f; 7.34 % off on the thick ring (t/L = 0.1)"
    }

    #[inline(always)]
    fn strains(&self, now: &Measures, reference: &Measures) -> Strains {
        let Measures { membrane, curvature, shear } = now.change(reference);
        Strains { membrane, curvature, shear }
    }

    #[inline(always)]
    fn transpose(&self, _: &Measures, _: &Measures, stress: &Resultants) -> MeasureForces {
        MeasureForces { membrane: stress.membrane, curvature: stress.moment, shear: stress.shear }
    }

    fn gradient(&self, _: &Measures, _: &Measures) -> Matrix8 {
        unit_matrix()
    }

    fn second_gradient(&self, _: &Measures, _: &Measures, _: &Resultants) -> Matrix8 {
        ZERO8
    }
}

impl<P: Number> StrainsOf<P> for StretchCorrected {
    #[inline(always)]
    fn strains_of(&self, now: &Measures<P>, reference: &Measures<P>) -> Strains<P> {
        let change = now.change(reference);
        let [e11, e22, g] = change.membrane;
        let [k11, k22, k12] = now.curvature;
        let [c11, c22, c12] = change.curvature;
        let gk12 = g * k12 * 0.25;
        Strains {
            membrane: change.membrane,
            curvature: [
                c11 - (e11 * k11 + gk12),
                c22 - (e22 * k22 + gk12),
                c12 - ((e11 + e22) * k12 + g * (k11 + k22)) * 0.5,
            ],
            shear: change.shear,
        }
    }

    #[inline(always)]
    fn transpose_of(
        &self,
        now: &Measures<P>,
        reference: &Measures<P>,
        stress: &Resultants<P>,
    ) -> MeasureForces<P> {
        let e11 = now.membrane[0] - reference.membrane[0];
        let e22 = now.membrane[1] - reference.membrane[1];
        let g = now.membrane[2] - reference.membrane[2];
        let [k11, k22, k12] = now.curvature;
        let [n11, n22, n12] = stress.membrane;
        let [m11, m22, m12] = stress.moment;
        let one = e11.all(1.0);
        let half_km = k12 * m12 * 0.5;
        let half_gm = g * m12 * 0.5;
        MeasureForces {
            membrane: [
                n11 - k11 * m11 - half_km,
                n22 - k22 * m22 - half_km,
                n12 - k12 * (m11 + m22) * 0.25 - (k11 + k22) * m12 * 0.5,
            ],
            curvature: [
                (one - e11) * m11 - half_gm,
                (one - e22) * m22 - half_gm,
                (one - (e11 + e22) * 0.5) * m12 - g * (m11 + m22) * 0.25,
            ],
            shear: stress.shear,
        }
    }
}

impl StrainMeasure for StretchCorrected {
    fn name(&self) -> &'static str {
        "stretch-corrected"
    }

    fn describe(&self) -> &'static str {
        "curvature freed of stretch: an exact circle under M = EIκ is an exact solution"
    }

    fn strains(&self, now: &Measures, reference: &Measures) -> Strains {
        self.strains_of(now, reference)
    }

    fn transpose(&self, now: &Measures, reference: &Measures, stress: &Resultants) -> MeasureForces {
        self.transpose_of(now, reference, stress)
    }

    fn gradient(&self, now: &Measures, reference: &Measures) -> Matrix8 {
        let e11 = now.membrane[0] - reference.membrane[0];
        let e22 = now.membrane[1] - reference.membrane[1];
        let g = now.membrane[2] - reference.membrane[2];
        let [k11, k22, k12] = now.curvature;
        let mut j = unit_matrix();
        (j[3][0], j[3][2], j[3][3], j[3][5]) = (-k11, k12 * -0.25, j[3][3] - e11, g * -0.25);
        (j[4][1], j[4][2], j[4][4], j[4][5]) = (-k22, k12 * -0.25, j[4][4] - e22, g * -0.25);
        (j[5][0], j[5][1], j[5][2]) = (k12 * -0.5, k12 * -0.5, (k11 + k22) * -0.5);
        (j[5][3], j[5][4], j[5][5]) = (g * -0.5, g * -0.5, j[5][5] - (e11 + e22) * 0.5);
        j
    }

    fn second_gradient(&self, _: &Measures, _: &Measures, stress: &Resultants) -> Matrix8 {
        let [m11, m22, m12] = stress.moment;
        let mut out = ZERO8;
        // κ11 holds −e11 k11 − ¼ g k12, κ22 likewise, κ12 holds −½[(e11+e22) k12 + g (k11+k22)].
        let products = [
            (0, 3, -m11),
            (1, 4, -m22),
            (2, 5, (m11 + m22) * -0.25),
            (0, 5, m12 * -0.5),
            (1, 5, m12 * -0.5),
            (2, 3, m12 * -0.5),
            (2, 4, m12 * -0.5),
        ];
        for (i, j, value) in products {
            out[i][j] = value;
            out[j][i] = value;
        }
        out
    }
}
