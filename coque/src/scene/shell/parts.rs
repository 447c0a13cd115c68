//! Parts of a shell: cells with a material, section or height of their own; masses lumped at particles; edges tied to cells.

use schemars::JsonSchema;
use serde::Deserialize;

use super::material::{Material, Section};

/// Cells of a shell with something of their own; what a part leaves out is that of the shell.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ShellPart {
    /// Set of cells: a group of faces of the mesh, a declared set, `all`.
    pub on: String,
    /// What it is made of.
    pub material: Option<Material>,
    /// How the material fills its thickness.
    pub section: Option<Section>,
    /// Height of the middle of its thickness over the particles, along their normals \[L\].
    #[serde(default)]
    pub offset: f64,
}

/// A mass lumped at the particles of a set, such as that of an engine on its feet.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LumpedMass {
    /// Particle set, which shares it equally.
    pub on: String,
    /// The whole mass \[F T²/L\].
    pub mass: f64,
}

/// An edge that hangs on the cells of another sheet, whose particles may stand elsewhere: it goes where they go and turns with them.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ShellTie {
    /// Particle set; those that belong to the cells already are left out.
    pub edge: String,
    /// Set of cells: a group of faces of the mesh, a declared set.
    pub to: String,
}
