//! What the shell is made of and how it fills the thickness, as a scene says it.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::scene::bounded::{PlyAngle, Positive, Slices, ThroughThickness};
use crate::scene::shell::plastic::Plastic;
use crate::scene::shell::rubber::Rubber;

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
            Self::File(_) => "file",
        }
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
            Self::File(_) => None,
        }
    }
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
}

/// Sections.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub enum Section {
    /// One isotropic material through the thickness.
    Homogeneous(Homogeneous),
    /// Plies of an orthotropic material on one another.
    Layered(Layered),
    /// The homogeneous sections that the file of the mesh gives to groups of its faces.
    File(OfFile),
}

impl Section {
    /// Thickness of the whole section \[L\], where the scene gives it.
    pub fn thickness(&self) -> Option<f64> {
        match self {
            Self::Homogeneous(section) => Some(section.thickness.get()),
            Self::Layered(section) => Some(section.plies.iter().map(|ply| ply.thickness.get()).sum()),
            Self::File(_) => None,
        }
    }

    /// Whether one law holds through the thickness, so that stresses run linearly.
    pub(crate) fn homogeneous(&self) -> bool {
        matches!(self, Self::Homogeneous(_) | Self::File(_))
    }
}

/// One isotropic material through the thickness.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Homogeneous {
    /// Thickness \[L\].
    pub thickness: Positive,
    /// Gauss points through the thickness; closed form without.
    pub gauss_points: Option<ThroughThickness>,
    /// Slices through the thickness of a material that yields; six without.
    pub slices: Option<Slices>,
    /// How the thickness goes with the place; the same everywhere without.
    pub taper: Option<Taper>,
    /// Thickness from a table, in units of `thickness`; in place of a taper.
    pub table: Option<ThicknessTable>,
    /// Name of an array in memory with a number for each particle: a cell is as thick as the mean of its corners' times `thickness`. Python
    /// brings such arrays; in place of a taper or a table.
    pub values: Option<String>,
}

impl Homogeneous {
    /// Slices through the thickness of a material that yields.
    pub fn slices(&self) -> usize {
        self.slices.map_or(6, |slices| slices.get())
    }

    /// Whether the thickness differs from cell to cell.
    pub(crate) fn varies(&self) -> bool {
        self.taper.is_some() || self.table.is_some() || self.values.is_some()
    }
}

/// A thickness from a file of comma-separated values with columns `x`, `y`, `z` \[L\] and one of numbers, in the un-turned frame.
///
/// A corner of a cell takes the number of the row nearest to it, no farther away than the cell is long, a cell the mean of its
/// corners times the thickness of the section.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ThicknessTable {
    /// The file, relative to the folder of the scene.
    pub file: String,
    /// Name of the column.
    pub column: String,
}

/// A thickness that is linear in space, in each cell that at its centre.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Taper {
    /// Place at which the thickness is that of the section, in the un-turned frame \[L\].
    pub point: [f64; 3],
    /// Change of the thickness by length along each axis \[–\].
    pub gradient: [f64; 3],
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
    pub thickness: Positive,
    /// Angle of the fibre from the axis, positive about the normal \[degrees\].
    pub angle: PlyAngle,
}

/// A material with a section that suits it.
pub(crate) enum MaterialSection<'a> {
    Homogeneous(&'a Elastic, &'a Homogeneous),
    Plastic(&'a Plastic, &'a Homogeneous),
    Rubber(&'a Rubber, &'a Homogeneous),
    Layered(&'a Orthotropic, &'a Layered),
    /// One of the two, or both, as the file gives them.
    OfFile(Option<&'a Elastic>, Option<&'a Homogeneous>),
}
