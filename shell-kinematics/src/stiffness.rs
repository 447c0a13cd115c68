//! The stiffness of a section that is linear in its strains: `N = Ae + Bκ`, `M = Be + Dκ`, `Q = Sγ`.

use crate::pack::Pack;
use crate::section::SectionScales;
use crate::strains::{Resultants, Strains};

/// Symmetric 3×3 matrix over the components 11, 22, 12 (the last as engineering shear).
pub(crate) type Matrix3 = [[f64; 3]; 3];

/// Its four matrices, over axes of the surface; strains 11, 22 and 2·12.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stiffness {
    /// A \[F/L\].
    pub membrane: [[f64; 3]; 3],
    /// B \[F\].
    pub coupling: [[f64; 3]; 3],
    /// D \[F L\].
    pub bending: [[f64; 3]; 3],
    /// S \[F/L\].
    pub shear: [[f64; 2]; 2],
}

impl Stiffness {
    #[inline(always)]
    pub(crate) fn resultants(&self, strains: &Strains) -> Resultants {
        let mut out = Resultants::default();
        multiply(&self.membrane, &strains.membrane, &mut out.membrane);
        multiply(&self.coupling, &strains.curvature, &mut out.membrane);
        multiply(&self.coupling, &strains.membrane, &mut out.moment);
        multiply(&self.bending, &strains.curvature, &mut out.moment);
        multiply(&self.shear, &strains.shear, &mut out.shear);
        out
    }

    /// Scales of a section of this thickness \[L\] whose membrane is nowhere stiffer than `membrane` \[F/L\].
    ///
    /// Bending and shear are means over all directions in the surface, the only sizes of a matrix that, like the control
    /// they scale, know no axes and equal those of an isotropic section. The stiffest direction has three times the mean at
    /// most (D22 = D11/9, D12 = −D11/3, D66 = 0). Bending is `D − BA⁻¹B`, since patterns of cells leave the membrane nearly free.
    pub(crate) fn scales(&self, thickness: f64, membrane: f64) -> SectionScales {
        let [[across, _], [_, other]] = self.shear;
        SectionScales {
            thickness,
            bending: mean_over_directions(&self.released()),
            shear: 0.5 * (across + other),
            membrane,
        }
    }

    /// `D − BA⁻¹B`: what bending meets where the membrane may follow free of force.
    pub(crate) fn released(&self) -> Matrix3 {
        // Gauss without pivoting on [A | B]: A is positive definite.
        let (mut left, mut right) = (self.membrane, self.coupling);
        for k in 0..3 {
            let (pivot, own, answer) = (left[k][k], left[k], right[k]);
            for i in 0..3 {
                let factor = if i == k { 1.0 - 1.0 / pivot } else { left[i][k] / pivot };
                for j in 0..3 {
                    left[i][j] -= factor * own[j];
                    right[i][j] -= factor * answer[j];
                }
            }
        }
        let [b, d] = [&self.coupling, &self.bending];
        std::array::from_fn(|i| {
            std::array::from_fn(|j| d[i][j] - (0..3).map(|k| b[i][k] * right[k][j]).sum::<f64>())
        })
    }
}

/// Mean over all directions of the first diagonal entry, `U1`.
pub(crate) fn mean_over_directions(m: &Matrix3) -> f64 {
    (3.0 * (m[0][0] + m[1][1]) + 2.0 * m[0][1] + 4.0 * m[2][2]) / 8.0
}

/// `m s`, added to `out`.
#[inline(always)]
fn multiply<const N: usize>(m: &[[f64; N]; N], s: &[Pack; N], out: &mut [Pack; N]) {
    for (value, row) in out.iter_mut().zip(m) {
        for (strain, factor) in s.iter().zip(row) {
            *value += *strain * *factor;
        }
    }
}
