//! Transverse shear on uneven stencils: consistent with Kirchhoff's bending, and relaxed where it would lock.
//!
//! What a Kirchhoff deflection of the curvature κ leaves in `x,α·d` on a stencil is taken out:
//! `γ̂_α = γ_α + E_α,βγ κ_βγ` with `E = ½ΣGξξ`, zero for parallelograms.
//!
//! A curvature that varies leaves more: `(1/6) T^α∴∇∇∇w` and terms of the same order, T = ΣGξξξ. Where T is the same in
//! neighbouring cells, particles make up for it; its uneven part T̃ ([`SamplingOperator::uneven_third_moments`]) they cannot, and
//! as the shell gets thin shear energy ~ `Gt |T̃|² |∇κ|²` locks beside bending energy ~ `Gt³ |κ|²`. The shear energy of a
//! cell is therefore scaled by
//!
//! ```text
//! t²/(t² + α |T̃|²/w)
//! ```
//!
//! the stabilised shear of \[lyly1993\] with |T̃| in the place of the size of the element: what is left beside `κ²` is at most
//! `5(1−ν)/(36α) w |∇κ|²`, of second order in the spacing whatever the thickness. Lattices on developable surfaces keep
//! all of their shear; triangles among quadrangles, whose T differs most, give up most. Measurements: docs/zero-energy-control.md.

use shell_kinematics::{LANES, Matrix8, Number, Pack, Resultants, Strains};
use sph_core::SamplingOperator;

use crate::regions::Scales;
use crate::registers::{Registers, in_all};

/// α \[–\]: the least that keeps disordered plates of L/t = 10⁴ within .15 % of L/t = 10²; 0.4 softens the hemisphere by .8 %.
const RELAXATION: f64 = 0.02;
/// Bound of α |T̃|²/w² \[–\]: \[lyly1993\] relax every cell by so much. Only slivers reach it.
const MOST: f64 = 0.1;

/// Shear constants of four points.
#[derive(Clone, Debug)]
pub(crate) struct ShearPack<P = Pack> {
    /// `E_α,βγ` as `[1·11, 1·22, 1·12, 2·11, 2·22, 2·12]` \[L\].
    moments: [P; 6],
    /// Square root of the share of the shear energy that is kept \[–\].
    share: P,
}

impl ShearPack {
    /// One pack for each four points of `order`; none if nothing is to be done (lattices on developable surfaces).
    ///
    /// `second` are the moments E \[L\], `third` the uneven part of T \[L²\]; without it nothing is relaxed.
    pub fn all(
        operator: &SamplingOperator,
        order: &[[u32; LANES]],
        second: &[[f64; 6]],
        third: &[[[f64; 4]; 2]],
        scales: &Scales,
    ) -> Vec<Self> {
        let area = operator.points.iter().fold(0.0_f64, |most, p| most.max(p.weight));
        // Round-off of a spacing is no bending.
        let even = second.iter().flatten().all(|e| e.abs() < 1e-12 * area.sqrt());
        if even && third.iter().flatten().flatten().all(|t| t.abs() < 1e-12 * area) {
            return Vec::new();
        }
        let share = |p: usize| {
            // 1111 + 3·1112 + 3·1122 + 1222 are the components of a tensor that is symmetric in its last three places.
            let norm = third.get(p).map_or(0.0, |rows| {
                rows.iter().map(|t| t[0] * t[0] + 3.0 * (t[1] * t[1] + t[2] * t[2]) + t[3] * t[3]).sum()
            });
            let w = operator.points[p].weight;
            let relaxed = (RELAXATION * norm / w).min(MOST * w);
            let thickness = scales.at(p).thickness;
            let squared = thickness * thickness;
            (squared / (squared + relaxed)).sqrt()
        };
        let pack = |points: &[u32; LANES]| Self {
            moments: std::array::from_fn(|i| Pack::from_fn(|lane| second[points[lane] as usize][i])),
            share: Pack::from_fn(|lane| share(points[lane] as usize)),
        };
        order.iter().map(pack).collect()
    }

    /// The constants in registers.
    #[inline(always)]
    pub fn load<const P: usize, R: Registers<P>>(of: [&Self; P], registers: R) -> ShearPack<R::Numbers> {
        ShearPack {
            moments: registers.loads(in_all(of, |of| &of.moments)),
            share: registers.load(in_all(of, |of| &of.share)),
        }
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

impl<P: Number> ShearPack<P> {
    /// Adjusts the shear strains to the curvature.
    #[inline(always)]
    pub fn adjust(&self, strains: &mut Strains<P>) {
        let (e, k) = (&self.moments, strains.curvature);
        let bent = [e[0] * k[0] + e[1] * k[1] + e[2] * k[2], e[3] * k[0] + e[4] * k[1] + e[5] * k[2]];
        let [q1, q2] = strains.shear;
        strains.shear = [(q1 + bent[0]) * self.share, (q2 + bent[1]) * self.share];
    }

    /// Transpose of [`ShearPack::adjust`].
    #[inline(always)]
    pub fn transpose(&self, stress: &mut Resultants<P>) {
        let e = &self.moments;
        let [q1, q2] = [stress.shear[0] * self.share, stress.shear[1] * self.share];
        for i in 0..3 {
            stress.moment[i] += e[i] * q1 + e[3 + i] * q2;
        }
        stress.shear = [q1, q2];
    }
}
