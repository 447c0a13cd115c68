//! Sets of bodies that are glued to the surfaces of others.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::scene::bounded::Positive;

/// A set of one body glued to the surface of another: each of its particles stays where it stands at rest over the nearest face of that
/// surface, at the same place of the face and the same distance off it, as the face moves and turns.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GlueScene {
    /// Particle set of a shell or a solid, written `body.set`. Particles on one line, as on the edge of a shell, are a hinge about that line;
    /// a strip of two rows or more holds turns too.
    pub on: String,
    /// The other body: a shell, a solid or a rigid body.
    pub to: String,
    /// Factor on the stiffness; left out, 1: at rest two hundred times that of cells of both bodies; in time what shortens steps by a tenth at
    /// most.
    pub stiffness: Option<Positive>,
}
