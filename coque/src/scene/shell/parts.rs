//! Parts of a shell: cells with a material, section or height of their own; masses lumped at particles; edges tied to cells; rigid sets.

use schemars::JsonSchema;
use serde::Deserialize;
use serde::de::IgnoredAny;

use super::material::Material;
use super::section::Section;
use crate::scene::bounded::{NotNegative, Positive};
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
    /// What of the particle method belongs to its cells alone; stencils are one a shell.
    pub formulation: Option<PartFormulation>,
}

/// The particle method of a part; what a shell has one of is read to be refused with its reason.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct PartFormulation {
    /// Strains at one point per cell.
    pub stress_point: Option<PartStressPoint>,
    #[schemars(skip)]
    pub(crate) nodal: Option<IgnoredAny>,
    #[schemars(skip)]
    pub(crate) strong_form: Option<IgnoredAny>,
}

/// Options of a part's sampling points.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PartStressPoint {
    /// Measure of the curvature; left out, that of the shell.
    pub curvature: Option<String>,
    #[schemars(skip)]
    pub(crate) support: Option<IgnoredAny>,
    #[schemars(skip)]
    pub(crate) kernel: Option<IgnoredAny>,
}

impl PartFormulation {
    /// Measure of the curvature, where the part has its own.
    pub(crate) fn curvature(&self) -> Option<&str> {
        self.stress_point.as_ref()?.curvature.as_deref()
    }

    /// The first key of what only a whole shell has.
    pub(crate) fn of_whole_shell(&self) -> Option<&'static str> {
        let point = self.stress_point.as_ref();
        let given = [
            (self.nodal.is_some(), "nodal"),
            (self.strong_form.is_some(), "strong-form"),
            (point.is_some_and(|point| point.support.is_some()), "stress-point.support"),
            (point.is_some_and(|point| point.kernel.is_some()), "stress-point.kernel"),
        ];
        given.into_iter().find(|(given, _)| *given).map(|(_, key)| key)
    }
}

/// A mass lumped at the particles of a set, such as that of an engine on its feet.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LumpedMass {
    /// Particle set, which shares it equally.
    pub on: String,
    /// The whole mass \[F T²/L\].
    pub mass: Positive,
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
    pub mass: NotNegative,
    /// Moments of inertia of that mass about the reference point, along x, y and z or one for all \[F T² L\].
    pub inertia: Option<PerAxis>,
    /// Off-diagonal terms xy, yz, zx of the same tensor, `−∫xy dm` and so on \[F T² L\].
    pub products: Option<[f64; 3]>,
}
