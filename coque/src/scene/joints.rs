//! Springs of which each end is at another body: supports whose `spring.to` names a set of another one.

use super::error::SceneError;
use super::owner::Owner;
use super::problem::Scene;
use super::supports::{Spring, Support};

/// A spring between two bodies.
#[derive(Clone, Debug)]
pub(crate) struct JointInScene<'a> {
    /// Where it stands in the scene, such as `supports[3]`.
    pub path: String,
    /// The sets at both ends, each with its body.
    pub ends: [(&'a str, &'a str); 2],
    pub support: &'a Support,
    pub spring: &'a Spring,
}

/// All springs between bodies, in the order of the scene.
///
/// # Errors
/// [`SceneError::Set`] for a support on, and a spring to, a set that names no body.
pub(crate) fn joints(scene: &Scene) -> Result<Vec<JointInScene<'_>>, SceneError> {
    let mut found = Vec::new();
    if scene.bodies.len() < 2 {
        return Ok(found);
    }
    for (i, support) in scene.supports.iter().enumerate() {
        let path = format!("supports[{i}]");
        let Some(spring) = &support.spring else { continue };
        let Some(to) = &spring.to else { continue };
        let Owner::Of(body, set) = Owner::of(scene, &format!("{path}.on"), &support.on)? else { continue };
        let (other, end) = match Owner::of(scene, &format!("{path}.spring.to"), to) {
            Ok(Owner::Of(other, end)) => (other, end),
            // A name without a body is one of a set of the same body.
            Err(error) if to.contains('.') => return Err(error),
            _ => continue,
        };
        if other != body {
            found.push(JointInScene { path, ends: [(body, set), (other, end)], support, spring });
        }
    }
    Ok(found)
}
