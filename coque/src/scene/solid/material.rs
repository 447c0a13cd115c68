//! What a solid is made of.

use schemars::JsonSchema;
use serde::Deserialize;
use solid_kinematics::Orthotropic;

use crate::scene::bounded::Positive;
use crate::scene::shell::material::Elastic;
use crate::scene::shell::plastic::Plastic;

/// Materials of solids.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub enum SolidMaterial {
    /// Isotropic linear elasticity.
    Elastic(Elastic),
    /// Linear elasticity with three planes of symmetry, of a Galerkin solid.
    Orthotropic(OrthotropicSolid),
    /// Isotropic elasticity that yields by von Mises' criterion, of a Galerkin solid, or of state-based bonds in space with linear hardening in marches.
    Plastic(Plastic),
}

/// An orthotropic material in space.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OrthotropicSolid {
    /// Young's moduli along the three material axes \[F/L²\].
    pub young: [Positive; 3],
    /// Poisson's ratios ν₁₂, ν₂₃, ν₁₃: contraction along the second axis under stress along the first \[–\].
    pub poisson: [f64; 3],
    /// Shear moduli G₁₂, G₂₃, G₁₃ \[F/L²\].
    pub shear: [Positive; 3],
    /// Density \[F T²/L⁴\].
    pub density: Positive,
    /// Conductivities along the three material axes, by any unit Θ of temperature \[F/(T Θ)\].
    pub conductivity: Option<[Positive; 3]>,
    /// Heat that a mass takes up by degree, of a solid that warms in time \[L²/(T² Θ)\].
    #[serde(rename = "specific_heat")]
    pub specific_heat: Option<Positive>,
    /// First and second material axis, perpendicular; their length does not matter. Left out, x and y.
    pub axes: Option<[[f64; 3]; 2]>,
}

impl OrthotropicSolid {
    /// Its constants, for the moduli.
    pub(crate) fn constants(&self) -> Orthotropic {
        let [young, shear] = [self.young, self.shear].map(|list| list.map(Positive::get));
        Orthotropic { young, poisson: self.poisson, shear }
    }
}

impl SolidMaterial {
    /// Young's modulus \[F/L²\] and Poisson's ratio \[–\], if it has no preferred direction.
    pub(crate) fn isotropic(&self) -> Option<(f64, f64)> {
        match self {
            Self::Elastic(elastic) => Some((elastic.young.get(), elastic.poisson)),
            Self::Plastic(plastic) => Some((plastic.young.get(), plastic.poisson)),
            Self::Orthotropic(_) => None,
        }
    }

    /// Its constants, if it is elastic and has no preferred direction.
    pub fn elastic(&self) -> Option<&Elastic> {
        match self {
            Self::Elastic(elastic) => Some(elastic),
            Self::Orthotropic(_) | Self::Plastic(_) => None,
        }
    }

    /// Conductivities along the material axes, if they are known \[F/(T Θ)\].
    pub(crate) fn conductivity(&self) -> Option<[f64; 3]> {
        match self {
            Self::Elastic(elastic) => elastic.conductivity.map(|k| [k.get(); 3]),
            Self::Orthotropic(orthotropic) => orthotropic.conductivity.map(|all| all.map(Positive::get)),
            Self::Plastic(_) => None,
        }
    }

    /// Heat that it stores by volume and degree, if that is known \[F/(L² Θ)\].
    pub(crate) fn heat_by_volume(&self) -> Option<f64> {
        let specific = match self {
            Self::Elastic(elastic) => elastic.specific_heat,
            Self::Orthotropic(orthotropic) => orthotropic.specific_heat,
            Self::Plastic(_) => None,
        };
        specific.map(|own| own.get() * self.density())
    }

    /// Its word.
    pub(crate) fn word(&self) -> &'static str {
        match self {
            Self::Elastic(_) => "elastic",
            Self::Orthotropic(_) => "orthotropic",
            Self::Plastic(_) => "plastic",
        }
    }

    /// Whether points remember what they went through.
    pub fn yields(&self) -> bool {
        matches!(self, Self::Plastic(_))
    }

    /// Density \[F T²/L⁴\].
    pub fn density(&self) -> f64 {
        match self {
            Self::Elastic(elastic) => elastic.density.get(),
            Self::Orthotropic(orthotropic) => orthotropic.density.get(),
            Self::Plastic(plastic) => plastic.density.get(),
        }
    }
}
