//! What the shell is made of, as a scene says it.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::scene::bounded::Positive;
use crate::scene::shell::by_temperature::ByTemperature;
use crate::scene::shell::plastic::Plastic;
use crate::scene::shell::rubber::Rubber;
use crate::scene::shell::strength::FibreStrength;

/// Materials.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub enum Material {
    /// Isotropic linear elasticity.
    Elastic(Elastic),
    /// Orthotropic linear elasticity of plies, in plane stress.
    Orthotropic(Orthotropic),
    /// Isotropic elasticity that yields by von Mises' criterion.
    Plastic(Plastic),
    /// Incompressible rubber.
    Rubber(Rubber),
    /// Whatever a section of given stiffness is made of: it says how heavy that is.
    Smeared(Smeared),
    /// The materials that the file of the mesh gives with its sections.
    File(OfFile),
}

/// What stands in the file of the mesh: `{}`.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OfFile {}

impl Material {
    /// Word of the scene.
    pub(crate) fn word(&self) -> &'static str {
        match self {
            Self::Elastic(_) => "elastic",
            Self::Orthotropic(_) => "orthotropic",
            Self::Plastic(_) => "plastic",
            Self::Rubber(_) => "rubber",
            Self::Smeared(_) => "smeared",
            Self::File(_) => "file",
        }
    }

    /// Heat that a volume takes up by degree \[F/(L² Θ)\], where the scene gives it.
    pub fn heat_by_volume(&self) -> Option<f64> {
        let by_mass = match self {
            Self::Elastic(material) => material.specific_heat,
            Self::Orthotropic(material) => material.specific_heat,
            _ => None,
        };
        by_mass.zip(self.density()).map(|(own, density)| own.get() * density)
    }

    /// The one strain measure that its law is written in, where it is not that of small strains.
    pub(crate) fn curvature(&self) -> Option<&'static str> {
        match self {
            Self::Plastic(_) => Some("logarithmic"),
            Self::Rubber(_) => Some("green-lagrange"),
            _ => None,
        }
    }

    /// Whether it yields.
    pub(crate) fn yields(&self) -> bool {
        matches!(self, Self::Plastic(_))
    }

    /// Mass per volume \[F T²/L⁴\], where the scene gives it.
    pub fn density(&self) -> Option<f64> {
        match self {
            Self::Elastic(material) => Some(material.density.get()),
            Self::Orthotropic(material) => Some(material.density.get()),
            Self::Plastic(material) => Some(material.density.get()),
            Self::Rubber(material) => Some(material.density.get()),
            Self::Smeared(material) => Some(material.density.get()),
            Self::File(_) => None,
        }
    }
}

/// What is left of materials whose stiffness the section gives.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Smeared {
    /// Mass per area of the sheet over the thickness of its section \[F T²/L⁴\].
    pub density: Positive,
}

/// Isotropic linear elasticity.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Elastic {
    /// Young's modulus \[F/L²\].
    pub young: Positive,
    /// Name of an array in memory with a number for each particle of a shell: in a cell Young's modulus is the mean of its corners' times
    /// `young`. Python brings such arrays.
    pub young_values: Option<String>,
    /// Poisson's ratio \[–\].
    pub poisson: f64,
    /// Mass per volume \[F T²/L⁴\].
    pub density: Positive,
    /// Coefficient of thermal expansion of a shell or a solid that is heated, by any unit Θ of temperature \[1/Θ\].
    pub expansion: Option<f64>,
    /// Conductivity of a body through which heat runs, by any unit Θ of temperature \[F/(T Θ)\].
    pub conductivity: Option<Positive>,
    /// Heat that a mass takes up by degree, of a body that warms in time \[L²/(T² Θ)\].
    #[serde(rename = "specific_heat")]
    pub specific_heat: Option<Positive>,
    /// How its numbers go with the temperature, of a shell that is heated.
    #[serde(rename = "by_temperature")]
    pub by_temperature: Option<ByTemperature>,
    /// Strength of a shell that von Mises' stress is held against in reserve factors \[F/L²\], such as the yield strength; nothing yields.
    pub strength: Option<Positive>,
}

/// Orthotropic linear elasticity, alike in all directions across the fibre as far as plane stress asks.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Orthotropic {
    /// Young's modulus E_L along the fibre \[F/L²\].
    pub young_along: Positive,
    /// Young's modulus E_T across the fibre \[F/L²\].
    pub young_across: Positive,
    /// Major Poisson's ratio ν_LT: contraction across the fibre under stress along it \[–\].
    pub poisson: f64,
    /// Shear modulus G_LT in the planes that hold the fibre \[F/L²\].
    pub shear: Positive,
    /// Shear modulus G_TT in the plane across the fibre \[F/L²\]; as `shear` without.
    pub shear_across: Option<Positive>,
    /// Mass per volume \[F T²/L⁴\].
    pub density: Positive,
    /// Coefficients of thermal expansion along the fibre and across it, by any unit Θ of temperature \[1/Θ\].
    pub expansion: Option<[f64; 2]>,
    /// Conductivities along the fibre and across it, by any unit Θ of temperature \[F/(T Θ)\].
    pub conductivity: Option<[Positive; 2]>,
    /// Heat that a mass takes up by degree, of a shell that warms in time \[L²/(T² Θ)\].
    pub specific_heat: Option<Positive>,
    /// Strengths, for reserve factors of plies; nothing fails.
    pub strength: Option<FibreStrength>,
}
