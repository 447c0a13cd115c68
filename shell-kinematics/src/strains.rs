//! Strains of a point and the resultants that do work on them.

use crate::pack::{Number, Pack};

/// Strains of a shell point, engineering components in the local orthonormal frame.
#[derive(Clone, Copy, Debug, Default)]
pub struct Strains<P = Pack> {
    /// Membrane `e11, e22, 2e12` \[–\].
    pub membrane: [P; 3],
    /// Change of curvature `κ11, κ22, 2κ12` \[1/L\].
    pub curvature: [P; 3],
    /// Transverse shear `γ1, γ2` \[–\].
    pub shear: [P; 2],
}

/// Stress resultants, conjugate to [`Strains`] per reference area.
#[derive(Clone, Copy, Debug, Default)]
pub struct Resultants<P = Pack> {
    /// Membrane forces `N11, N22, N12` \[F/L\].
    pub membrane: [P; 3],
    /// Moments `M11, M22, M12` \[F\].
    pub moment: [P; 3],
    /// Transverse shear forces `Q1, Q2` \[F/L\].
    pub shear: [P; 2],
}

impl<P: Number> Resultants<P> {
    /// `N·e + M·κ + Q·γ` \[F/L\].
    #[inline(always)]
    pub fn work(&self, strains: &Strains<P>) -> P {
        let mut work = self.shear[0].all(0.0);
        for i in 0..3 {
            work += self.membrane[i] * strains.membrane[i] + self.moment[i] * strains.curvature[i];
        }
        work + self.shear[0] * strains.shear[0] + self.shear[1] * strains.shear[1]
    }
}
