//! Links of a scene with the sets that they join.

use super::error::SceneError;
use super::links::LinkScene;
use super::owner::Owner;
use super::problem::Scene;

/// A link with the sets that it joins.
#[derive(Clone, Debug)]
pub(crate) struct LinkInScene<'a> {
    /// Where it stands in the scene, such as `links[3]`.
    pub path: String,
    /// The set at the near end, with its body.
    pub on: (&'a str, &'a str),
    /// That at the far end; none at the ground.
    pub to: Option<(&'a str, &'a str)>,
    pub own: &'a LinkScene,
}

impl LinkInScene<'_> {
    /// Whether an end of it is on a body.
    pub(crate) fn is_of(&self, body: &str) -> bool {
        self.on.0 == body || self.to.is_some_and(|(other, _)| other == body)
    }
}

/// All links of a scene, in its order.
///
/// # Errors
/// [`SceneError::Set`] for a set that names no body, or every one.
pub(crate) fn links(scene: &Scene) -> Result<Vec<LinkInScene<'_>>, SceneError> {
    let end = |path: String, set| match Owner::of(scene, &path, set)? {
        Owner::Of(body, set) => Ok((body, set)),
        Owner::Every => {
            let repair = "name a set of one body, as in on = \"box.all\"";
            let bound = "but the end of a link is a set of one body";
            Err(SceneError::Set(scene.source.fault(&path, "\"all\"", bound, repair)))
        }
    };
    let mut found = Vec::with_capacity(scene.links.len());
    for (path, own) in scene.links.iter().enumerate().map(|(i, own)| (format!("links[{i}]"), own)) {
        let on = end(format!("{path}.on"), &own.on)?;
        let to = own.to.as_ref().map(|to| end(format!("{path}.to"), to)).transpose()?;
        found.push(LinkInScene { path, on, to, own });
    }
    Ok(found)
}
