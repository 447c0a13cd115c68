//! How the material fills the thickness, as a scene says it.

use schemars::JsonSchema;
use serde::Deserialize;
use shell_kinematics::Stiffness;

use super::material::{Elastic, Material, OfFile};
use super::plastic::Plastic;
use super::plies::Layered;
use super::rubber::Rubber;
use crate::scene::bounded::{Positive, Slices, ThroughThickness};

/// Sections.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub enum Section {
    /// One isotropic material through the thickness.
    Homogeneous(Homogeneous),
    /// Plies on one another.
    Layered(Layered),
    /// Stiffness as it is given: sandwich, corrugated or stiffened sheets.
    Stiffness(Box<GivenStiffness>),
    /// The homogeneous sections that the file of the mesh gives to groups of its faces.
    File(OfFile),
}

impl Section {
    /// Thickness of the whole section \[L\], where the scene gives it.
    pub fn thickness(&self) -> Option<f64> {
        match self {
            Self::Homogeneous(section) => Some(section.thickness.get()),
            Self::Layered(section) => Some(section.plies.iter().map(|ply| ply.thickness.get()).sum()),
            Self::Stiffness(section) => Some(section.thickness.get()),
            Self::File(_) => None,
        }
    }

    /// The materials through the thickness, that of the shell where none is given.
    pub(crate) fn materials<'a>(&'a self, shell: &'a Material) -> Vec<&'a Material> {
        match self {
            Self::Layered(section) => section.materials(shell).collect(),
            Self::Homogeneous(_) | Self::Stiffness(_) | Self::File(_) => vec![shell],
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

/// Forces and moments by strains and curvatures, `N = A e + B κ`, `M = B e + D κ`, `Q = S γ`, in the components 11, 22, 12; shear strain
/// and twist are 2·12.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GivenStiffness {
    /// Thickness \[L\]: between the faces, for pictures, contact and mass.
    pub thickness: Positive,
    /// Direction whose projection on the surface is that of the component 1, in the un-turned frame; 2 lies 90° from it about the normal.
    pub axis: [f64; 3],
    /// A \[F/L\], symmetric: `[[A11, A12, A16], [A12, A22, A26], [A16, A26, A66]]`.
    pub membrane: [[f64; 3]; 3],
    /// B \[F\], symmetric; none without.
    pub coupling: Option<[[f64; 3]; 3]>,
    /// D \[F L\], symmetric.
    pub bending: [[f64; 3]; 3],
    /// S of transverse shear \[F/L\], symmetric, with whatever factor the section has: `[[S11, S12], [S12, S22]]`, 1 across the surface along the axis.
    pub shear: [[f64; 2]; 2],
}

impl GivenStiffness {
    /// Its matrices.
    pub(crate) fn matrices(&self) -> Stiffness {
        let Self { membrane, coupling, bending, shear, .. } = *self;
        Stiffness { membrane, coupling: coupling.unwrap_or_default(), bending, shear }
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

/// A material with a section that suits it.
pub(crate) enum MaterialSection<'a> {
    Homogeneous(&'a Elastic, &'a Homogeneous),
    Plastic(&'a Plastic, &'a Homogeneous),
    Rubber(&'a Rubber, &'a Homogeneous),
    Layered(&'a Material, &'a Layered),
    Given(&'a GivenStiffness),
    /// One of the two, or both, as the file gives them.
    OfFile(Option<&'a Elastic>, Option<&'a Homogeneous>),
}
