//! Strains of a point and the resultants that do work on them.

use crate::pack::Pack;

/// Strains of a shell point, engineering components in the local orthonormal frame.
#[derive(Clone, Copy, Debug, Default)]
pub struct Strains {
    /// Membrane `e11, e22, 2e12` \[–\].
    pub membrane: [Pack; 3],
    /// Change of curvature `κ11, κ22, 2κ12` \[1/L\].
    pub curvature: [Pack; 3],
    /// Transverse shear `γ1, γ2` \[–\].
    pub shear: [Pack; 2],
}

/// Stress resultants, conjugate to [`Strains`] per reference area.
#[derive(Clone, Copy, Debug, Default)]
pub struct Resultants {
    /// Membrane forces `N11, N22, N12` \[F/L\].
    pub membrane: [Pack; 3],
    /// Moments `M11, M22, M12` \[F\].
    pub moment: [Pack; 3],
    /// Transverse shear forces `Q1, Q2` \[F/L\].
    pub shear: [Pack; 2],
}

impl Resultants {
    /// `N·e + M·κ + Q·γ` \[F/L\].
    #[inline(always)]
    pub fn work(&self, strains: &Strains) -> Pack {
        let mut work = Pack::ZERO;
        for i in 0..3 {
            work += self.membrane[i] * strains.membrane[i] + self.moment[i] * strains.curvature[i];
        }
        work + self.shear[0] * strains.shear[0] + self.shear[1] * strains.shear[1]
    }
}
