//! What the shell is made of and how it fills the thickness, as a scene says it.

use schemars::JsonSchema;
use serde::Deserialize;

/// Materials.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub enum Material {
    /// Isotropic linear elasticity.
    Elastic(Elastic),
    /// Orthotropic linear elasticity of plies, in plane stress.
    Orthotropic(Orthotropic),
}

impl Material {
    /// Word of the scene.
    pub(crate) fn word(&self) -> &'static str {
        match self {
            Self::Elastic(_) => "elastic",
            Self::Orthotropic(_) => "orthotropic",
        }
    }

    /// Mass per volume \[F T²/L⁴\].
    pub fn density(&self) -> f64 {
        match self {
            Self::Elastic(material) => material.density,
            Self::Orthotropic(material) => material.density,
        }
    }
}

/// Isotropic linear elasticity.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Elastic {
    /// Young's modulus \[F/L²\].
    pub young: f64,
    /// Poisson's ratio \[–\].
    pub poisson: f64,
    /// Mass per volume \[F T²/L⁴\].
    pub density: f64,
}

/// Orthotropic linear elasticity, alike in all directions across the fibre as far as plane stress asks.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Orthotropic {
    /// Young's modulus E_L along the fibre \[F/L²\].
    pub young_along: f64,
    /// Young's modulus E_T across the fibre \[F/L²\].
    pub young_across: f64,
    /// Major Poisson's ratio ν_LT: contraction across the fibre under stress along it \[–\].
    pub poisson: f64,
    /// Shear modulus G_LT in the planes that hold the fibre \[F/L²\].
    pub shear: f64,
    /// Shear modulus G_TT in the plane across the fibre \[F/L²\]; as `shear` without.
    pub shear_across: Option<f64>,
    /// Mass per volume \[F T²/L⁴\].
    pub density: f64,
}

/// Sections.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub enum Section {
    /// One isotropic material through the thickness.
    Homogeneous(Homogeneous),
    /// Plies of an orthotropic material on one another.
    Layered(Layered),
}

impl Section {
    /// Thickness of the whole section \[L\].
    pub fn thickness(&self) -> f64 {
        match self {
            Self::Homogeneous(section) => section.thickness,
            Self::Layered(section) => section.plies.iter().map(|ply| ply.thickness).sum(),
        }
    }

    /// Whether one law holds through the thickness, so that stresses run linearly.
    pub(crate) fn homogeneous(&self) -> bool {
        matches!(self, Self::Homogeneous(_))
    }
}

/// One isotropic material through the thickness.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Homogeneous {
    /// Thickness \[L\].
    pub thickness: f64,
    /// Gauss points through the thickness; closed form without.
    pub gauss_points: Option<usize>,
}

/// Plies of an orthotropic material on one another, their middle on the mid-surface.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Layered {
    /// Direction whose projection on the surface has the angle zero, in the un-turned frame.
    pub axis: [f64; 3],
    /// From the lowest, against the normal, to the highest.
    pub plies: Vec<Ply>,
}

/// One ply.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Ply {
    /// Thickness \[L\].
    pub thickness: f64,
    /// Angle of the fibre from the axis, positive about the normal \[degrees\].
    pub angle: f64,
}

/// A material with a section that suits it.
pub(crate) enum MaterialSection<'a> {
    Homogeneous(&'a Elastic, &'a Homogeneous),
    Layered(&'a Orthotropic, &'a Layered),
}
