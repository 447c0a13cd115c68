//! Sets of bodies that are glued to the surfaces of others.

use schemars::JsonSchema;
use serde::Deserialize;

use super::error::SceneError;
use super::owner::Owner;
use super::problem::Scene;
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

/// Glue with the bodies that it joins.
#[derive(Clone, Debug)]
pub(crate) struct GlueInScene<'a> {
    /// Where it stands in the scene, such as `glue[3]`.
    pub path: String,
    /// The body that has the set, and the set.
    pub on: (&'a str, &'a str),
    pub own: &'a GlueScene,
}

impl GlueInScene<'_> {
    /// Whether it joins a body to another.
    pub(crate) fn is_of(&self, body: &str) -> bool {
        self.on.0 == body || self.own.to == body
    }
}

/// All glue of a scene of several bodies, in its order.
///
/// # Errors
/// [`SceneError::Set`] for a set that names no body, or every one.
pub(crate) fn glued(scene: &Scene) -> Result<Vec<GlueInScene<'_>>, SceneError> {
    let mut found = Vec::new();
    for (i, own) in scene.glue.iter().enumerate() {
        let path = format!("glue[{i}]");
        let at = format!("{path}.on");
        match Owner::of(scene, &at, &own.on)? {
            Owner::Of(body, set) => found.push(GlueInScene { path, on: (body, set), own }),
            Owner::Every => {
                let repair = "name a set of one body, as in on = \"plate.u1\"";
                let bound = "but glue takes a set of one body";
                return Err(SceneError::Set(scene.source.fault(&at, "\"all\"", bound, repair)));
            }
        }
    }
    Ok(found)
}
