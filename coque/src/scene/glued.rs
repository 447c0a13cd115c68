//! Glue of a scene with the bodies that it joins.

use super::error::SceneError;
use super::glue::GlueScene;
use super::owner::Owner;
use super::problem::Scene;

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
