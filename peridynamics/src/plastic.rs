//! Solids of bonds that yield.

use crate::error::SolidError;
use crate::formulation::{Correction, Formulation};
use crate::material::Space;

/// Von Mises' plasticity with linear isotropic hardening, `σ_y + H ε^p`, for state-based bonds in space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plastic {
    /// Yield stress σ_y in uniaxial tension \[F/L²\].
    pub yield_stress: f64,
    /// Hardening modulus H, the slope over the equivalent plastic strain \[F/L²\]; zero for perfect plasticity.
    pub hardening: f64,
}

impl Plastic {
    /// Refuses what cannot yield so.
    ///
    /// # Errors
    /// [`SolidError::Limit`] for constants out of bounds, [`SolidError::Yielding`] for pairwise bonds, planes, and weights that
    /// are not exact for uniform strains.
    pub(crate) fn check(&self, formulation: &Formulation) -> Result<(), SolidError> {
        let refused = |what, value, bound| Err(SolidError::Limit { what, value, bound });
        if !(self.yield_stress > 0.0 && self.yield_stress.is_finite()) {
            let bound = "it must be positive and finite; leave plasticity out where nothing yields";
            return refused("the yield stress", self.yield_stress, bound);
        }
        if !(self.hardening >= 0.0 && self.hardening.is_finite()) {
            let bound = "it must be zero (perfect plasticity) or positive, and finite";
            return refused("the hardening modulus", self.hardening, bound);
        }
        if !formulation.law.has_dilatation() {
            return Err(SolidError::Yielding(
                "need a family with a dilatation, which pairwise forces have not; take the state-based formulation",
            ));
        }
        if formulation.space != Space::Solid {
            return Err(SolidError::Yielding(
                "are for bodies in space: in a plane the stress or the plastic strain across it takes part in yielding, and no \
                 bond carries it; take a block of several layers",
            ));
        }
        match formulation.correction {
            Correction::Even | Correction::Balanced => Ok(()),
            Correction::None | Correction::EnergyFactor => Err(SolidError::Yielding(
                "need weights that see no dilatation where a strain keeps the volume, at faces too: others lock as the flow goes on; \
                 take the correction `even` or `balanced`",
            )),
        }
    }

    /// Yield stress after an equivalent plastic strain \[F/L²\].
    pub(crate) fn limit(&self, strain: f64) -> f64 {
        self.yield_stress + self.hardening * strain
    }
}
