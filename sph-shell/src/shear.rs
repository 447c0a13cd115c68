//! Transverse shear on uneven stencils: Kirchhoff-consistent, and relaxed on triangles.
//!
//! What a Kirchhoff deflection of the curvature κ would leave in `x,α·d` on a stencil is taken out:
//! `γ̂_α = γ_α + E_α,βγ κ_βγ` with the second moments `E = ½ΣG ξξ`, nought for parallelograms.
//!
//! A triangle samples two shears with one point and has no hourglass to give way: thin shells lock where pairing left one
//! over. Its shear energy is scaled by `t²/(t² + α w)`, the stabilised shear of \[lyly1993\]: bending scale where
//! the shell is thin against the triangle, unchanged where it is thick.

use shell_kinematics::{LANES, Matrix8, Pack, Resultants, Strains};
use sph_core::SamplingOperator;

/// α of the stabilised shear, for w the area of the triangle \[–\].
const RELAXATION: f64 = 1.0;

/// Shear constants of four points.
#[derive(Clone, Debug)]
pub(crate) struct ShearPack {
    /// `E_α,βγ` as `[1·11, 1·22, 1·12, 2·11, 2·22, 2·12]` \[L\].
    moments: [Pack; 6],
    /// Square root of the share of the shear energy that is kept \[–\].
    share: Pack,
}

impl ShearPack {
    /// One pack for each four points of `order`; none if the cloud is a lattice of parallelograms.
    pub fn all(
        operator: &SamplingOperator,
        order: &[[u32; LANES]],
        moments: &[[f64; 6]],
        thickness: f64,
    ) -> Vec<Self> {
        let alpha: f64 = std::env::var("ALPHA").ok().and_then(|v| v.parse().ok()).unwrap_or(RELAXATION);
        let share = |p: u32| {
            let triangle = operator.stencil(p as usize).particles.len() == 3;
            let relaxed = if triangle { alpha * operator.points[p as usize].weight } else { 0.0 };
            (thickness * thickness / (thickness * thickness + relaxed)).sqrt()
        };
        // Round-off of a spacing is no bending.
        let spacing = operator.points.iter().fold(0.0_f64, |most, p| most.max(p.weight)).sqrt();
        let even = moments.iter().flatten().all(|e| e.abs() < 1e-12 * spacing);
        if even && (0..operator.points.len() as u32).all(|p| share(p) == 1.0) {
            return Vec::new();
        }
        let pack = |points: &[u32; LANES]| Self {
            moments: std::array::from_fn(|i| Pack::from_fn(|lane| moments[points[lane] as usize][i])),
            share: Pack::from_fn(|lane| share(points[lane])),
        };
        order.iter().map(pack).collect()
    }

    /// Adjusts the shear strains to the curvature.
    #[inline(always)]
    pub fn adjust(&self, strains: &mut Strains) {
        let (e, k) = (&self.moments, strains.curvature);
        let bent = [e[0] * k[0] + e[1] * k[1] + e[2] * k[2], e[3] * k[0] + e[4] * k[1] + e[5] * k[2]];
        strains.shear =
            [(strains.shear[0] + bent[0]) * self.share, (strains.shear[1] + bent[1]) * self.share];
    }

    /// Transpose of [`ShearPack::adjust`].
    #[inline(always)]
    pub fn transpose(&self, stress: &mut Resultants) {
        let e = &self.moments;
        let [q1, q2] = [stress.shear[0] * self.share, stress.shear[1] * self.share];
        for i in 0..3 {
            stress.moment[i] += e[i] * q1 + e[3 + i] * q2;
        }
        stress.shear = [q1, q2];
    }

    /// Adjusts the derivative of the strains as [`ShearPack::adjust`] does the strains.
    pub fn adjust_gradient(&self, gradient: &mut Matrix8) {
        for (alpha, e) in [&self.moments[..3], &self.moments[3..]].into_iter().enumerate() {
            for measure in 0..8 {
                let bent: Pack =
                    e[0] * gradient[3][measure] + e[1] * gradient[4][measure] + e[2] * gradient[5][measure];
                gradient[6 + alpha][measure] = (gradient[6 + alpha][measure] + bent) * self.share;
            }
        }
    }
}
