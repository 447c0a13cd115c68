//! Strain measures of four points side by side, where not all points of a shell have the same.

use crate::pack::{LANES, Pack};
use crate::placement::{MeasureForces, Measures};
use crate::strain::StrainMeasure;
use crate::strains::{Resultants, Strains};
use crate::tangent::Matrix8;

/// The measure of each of four points.
#[derive(Clone, Copy)]
pub struct StrainPack([&'static dyn StrainMeasure; LANES]);

impl StrainPack {
    /// One for each point.
    pub fn new(of: [&'static dyn StrainMeasure; LANES]) -> Self {
        Self(of)
    }

    /// What the measure of each point finds, as rows of numbers.
    #[inline]
    fn rows<const N: usize>(&self, find: impl Fn(&dyn StrainMeasure) -> [Pack; N]) -> [Pack; N] {
        let first = find(self.0[0]);
        if self.0.iter().all(|own| own.name() == self.0[0].name()) {
            return first;
        }
        let all = self.0.map(&find);
        std::array::from_fn(|i| Pack::from_fn(|lane| all[lane][i].lanes()[lane]))
    }

    fn matrix(&self, find: impl Fn(&dyn StrainMeasure) -> Matrix8) -> Matrix8 {
        let rows: [Pack; 64] = self.rows(|own| {
            let found = find(own);
            std::array::from_fn(|i| found[i / 8][i % 8])
        });
        std::array::from_fn(|i| std::array::from_fn(|j| rows[8 * i + j]))
    }
}

impl std::fmt::Debug for StrainPack {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_list().entries(self.0.map(|own| own.name())).finish()
    }
}

impl StrainMeasure for StrainPack {
    fn name(&self) -> &'static str {
        "by point"
    }

    fn describe(&self) -> &'static str {
        "to each point its own"
    }

    fn strains(&self, now: &Measures, reference: &Measures) -> Strains {
        let [a, b, c, d, e, f, g, h] = self.rows(|own| {
            let Strains { membrane: [a, b, c], curvature: [d, e, f], shear: [g, h] } =
                own.strains(now, reference);
            [a, b, c, d, e, f, g, h]
        });
        Strains { membrane: [a, b, c], curvature: [d, e, f], shear: [g, h] }
    }

    fn transpose(&self, now: &Measures, reference: &Measures, stress: &Resultants) -> MeasureForces {
        let [a, b, c, d, e, f, g, h] = self.rows(|own| {
            let found = own.transpose(now, reference, stress);
            let ([a, b, c], [d, e, f], [g, h]) = (found.membrane, found.curvature, found.shear);
            [a, b, c, d, e, f, g, h]
        });
        MeasureForces { membrane: [a, b, c], curvature: [d, e, f], shear: [g, h] }
    }

    fn gradient(&self, now: &Measures, reference: &Measures) -> Matrix8 {
        self.matrix(|own| own.gradient(now, reference))
    }

    fn second_gradient(&self, now: &Measures, reference: &Measures, stress: &Resultants) -> Matrix8 {
        self.matrix(|own| own.second_gradient(now, reference, stress))
    }
}
