//! Sets of bodies that are glued to the surfaces of others.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::scene::bounded::Positive;

/// What of a shell particles glued to it follow.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Followed {
    /// Its directors: a particle stays at the mean about it of `Σ w_i (x_i + ζ d_i)`, of corners of nearest cells, over the faces of the set, or at that of its own place where it has none.
    Director,
}

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
    /// What the particles follow of a shell: left out, the normal of its surface; `director`, its directors, so that the face of a solid across
    /// an edge of the shell, half its thickness to both sides, hands on moments as well as forces.
    pub follow: Option<Followed>,
    /// Factor on the stiffness; left out, 1: at rest two hundred times that of cells of both bodies; in time what shortens steps by a tenth at
    /// most.
    pub stiffness: Option<Positive>,
}
