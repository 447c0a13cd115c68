//! Parts of a shell: cells with a material, section or height of their own; masses lumped at particles; edges tied to cells; rigid sets.

use schemars::JsonSchema;
use serde::Deserialize;

use super::formulation::Formulation;
use super::material::{Material, Section};
use crate::scene::per_axis::PerAxis;

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
    /// Measure of the curvature, as `stress-point.curvature`; stencils are one a shell.
    pub formulation: Option<Formulation>,
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

/// Particles that move as one rigid body, such as a flange, a boss or the foot of a machine.
///
/// A support on the same set is one of the body: displacements of its reference point, and with `director` all rotations but that about the
/// given normal. A force or a couple about a fixed axis on the same set acts on the body at its reference point.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RigidBody {
    /// Particle set, of two particles side by side or more; no particle is in two bodies.
    pub on: String,
    /// The reference point \[L\]; left out, the mean of its particles' places.
    pub at: Option<[f64; 3]>,
    /// Mass at the reference point beside that of the particles \[F T²/L\]; it weighs under gravity on all.
    #[serde(default)]
    pub mass: f64,
    /// Moments of inertia of that mass about the reference point, along x, y and z or one for all \[F T² L\].
    pub inertia: Option<PerAxis>,
    /// Off-diagonal terms xy, yz, zx of the same tensor, `−∫xy dm` and so on \[F T² L\].
    pub products: Option<[f64; 3]>,
}
