//! Isotropic elasticity, and what is left of it in a plane.

use crate::error::SolidError;

/// Isotropic linear elasticity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Elastic {
    /// Young's modulus E \[F/L²\].
    pub young: f64,
    /// Poisson's ratio ν \[–\].
    pub poisson: f64,
    /// Mass per volume ρ \[F T²/L⁴\].
    pub density: f64,
}

/// The space that bonds lie in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Space {
    /// All three directions.
    Solid,
    /// A plane without stress across it: a thin plate.
    PlaneStress,
    /// A plane without strain across it: a slice of a long body.
    PlaneStrain,
}

/// Lamé's constants of a space of two or three dimensions \[F/L²\].
///
/// In plane stress λ is `Eν/(1 − ν²)`, so that one law serves all spaces; \[le2014\] has laws of their own for planes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moduli {
    /// Dimensions d, two or three.
    pub dimensions: usize,
    /// λ.
    pub lambda: f64,
    /// Shear modulus μ.
    pub mu: f64,
}

impl Space {
    /// Dimensions, two or three.
    pub fn dimensions(self) -> usize {
        if self == Self::Solid { 3 } else { 2 }
    }

    /// The Poisson's ratio that pairwise central forces have: λ = μ.
    pub fn pairwise_poisson(self) -> f64 {
        if self == Self::PlaneStress { 1.0 / 3.0 } else { 0.25 }
    }
}

impl Elastic {
    /// Lamé's constants in a space.
    ///
    /// # Errors
    /// [`SolidError::Material`] outside E > 0, ρ > 0, −1 < ν < ½ (in plane stress −1 < ν < 1).
    pub fn moduli(&self, space: Space) -> Result<Moduli, SolidError> {
        let Self { young, poisson: nu, density } = *self;
        let top = if space == Space::PlaneStress { 1.0 } else { 0.5 };
        let refused = |what, value| Err(SolidError::Material { what, value });
        if !(young > 0.0 && young.is_finite()) {
            return refused("Young's modulus", young);
        }
        if !(density > 0.0 && density.is_finite()) {
            return refused("the density", density);
        }
        if !(-1.0 < nu && nu < top) {
            return refused("Poisson's ratio", nu);
        }
        let lambda = match space {
            Space::PlaneStress => young * nu / (1.0 - nu * nu),
            Space::PlaneStrain | Space::Solid => young * nu / ((1.0 + nu) * (1.0 - 2.0 * nu)),
        };
        Ok(Moduli { dimensions: space.dimensions(), lambda, mu: young / (2.0 * (1.0 + nu)) })
    }
}

/// What the strain across a plane, which is held, makes of stresses in it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Across {
    /// Young's modulus E \[F/L²\].
    pub young: f64,
    /// Poisson's ratio ν \[–\].
    pub poisson: f64,
}

impl Across {
    /// Those of a plane without strain across; none of other spaces.
    pub fn of(material: &Elastic, space: Space) -> Option<Self> {
        (space == Space::PlaneStrain).then_some(Self { young: material.young, poisson: material.poisson })
    }

    /// `σ_zz = ν (σ_xx + σ_yy) − E αΔT` \[F/L²\].
    pub fn stress(self, along: f64, free_strain: f64) -> f64 {
        self.poisson * along - self.young * free_strain
    }
}
