//! A section integrated through the thickness by Gauss points: the seam for materials without closed form.

use crate::expansion::Expansion;
use crate::pack::Pack;
use crate::section::{
    Isotropic, IsotropicSection, MaterialError, SHEAR_CORRECTION, Section, SectionScales, linear_tangent,
    plane_stress,
};
use crate::strains::{Resultants, Strains};
use crate::tangent::Matrix8;

/// Gauss–Legendre abscissae and weights on (−1, 1) for 2 to 5 points.
pub(crate) const GAUSS: [&[(f64, f64)]; 4] = [
    &[(-0.577_350_269_189_625_8, 1.0), (0.577_350_269_189_625_8, 1.0)],
    &[
        (-0.774_596_669_241_483_4, 0.555_555_555_555_555_6),
        (0.0, 0.888_888_888_888_888_8),
        (0.774_596_669_241_483_4, 0.555_555_555_555_555_6),
    ],
    &[
        (-0.861_136_311_594_052_6, 0.347_854_845_137_453_85),
        (-0.339_981_043_584_856_26, 0.652_145_154_862_546_1),
        (0.339_981_043_584_856_26, 0.652_145_154_862_546_1),
        (0.861_136_311_594_052_6, 0.347_854_845_137_453_85),
    ],
    &[
        (-0.906_179_845_938_664, 0.236_926_885_056_189_1),
        (-0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
        (0.0, 0.568_888_888_888_888_9),
        (0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
        (0.906_179_845_938_664, 0.236_926_885_056_189_1),
    ],
];

/// Plane stress evaluated at Gauss points through the thickness; `E(ζ) = e + ζ κ` (\[lin2013\] §3).
///
/// For a homogeneous elastic material it equals [`IsotropicSection`] to round-off (tested).
#[derive(Clone, Debug)]
pub struct IntegratedSection {
    pub(crate) material: Isotropic,
    /// `(ζ, weight)` \[L, L\].
    layers: Vec<(f64, f64)>,
    scales: SectionScales,
}

impl IntegratedSection {
    /// Homogeneous section with 2 to 5 Gauss points.
    ///
    /// # Errors
    /// [`MaterialError`] for a thickness that is not positive or a number of points outside 2–5.
    pub fn new(material: Isotropic, thickness: f64, points: usize) -> Result<Self, MaterialError> {
        let scales = IsotropicSection::new(material, thickness)?.scales();
        let rule =
            points.checked_sub(2).and_then(|i| GAUSS.get(i)).ok_or(MaterialError::GaussPoints(points))?;
        let half = 0.5 * thickness;
        let layers = rule.iter().map(|&(z, w)| (z * half, w * half)).collect();
        Ok(Self { material, layers, scales })
    }
}

impl Section for IntegratedSection {
    fn homogeneous(&self) -> bool {
        true
    }

    fn linear(&self) -> bool {
        true
    }

    fn resultants(&self, strains: &Strains) -> Resultants {
        let mut out = Resultants::default();
        let (c, nu) = (self.material.plane_stress(), self.material.poisson);
        let g = SHEAR_CORRECTION * self.material.shear();
        for &(zeta, weight) in &self.layers {
            let strain: [Pack; 3] =
                std::array::from_fn(|i| strains.membrane[i] + strains.curvature[i] * zeta);
            let stress = plane_stress(c, nu, &strain);
            for i in 0..3 {
                out.membrane[i] += stress[i] * weight;
                out.moment[i] += stress[i] * (weight * zeta);
            }
            for i in 0..2 {
                out.shear[i] += strains.shear[i] * (g * weight);
            }
        }
        out
    }

    fn tangent(&self, _: &Strains) -> Matrix8 {
        linear_tangent(self)
    }

    /// In closed form: Gauss points integrate the parabola of its energy exactly.
    fn expansion(&self) -> Option<Expansion> {
        let stiffness = self.material.plane_stress() * (1.0 + self.material.poisson);
        self.material.expansion.map(|own| Expansion::isotropic(stiffness, own, self.scales.thickness))
    }

    fn energy(&self, strains: &Strains) -> Pack {
        self.resultants(strains).work(strains) * 0.5
    }

    fn scales(&self) -> SectionScales {
        self.scales
    }
}
