//! Structures as a fluid wets them.

use super::body::Structure;
use crate::bodies::Made;
use crate::scene::error::SceneError;
use crate::scene::{BodyScene, FluidScene, Scene};

/// A structure with what the fluid asks of it.
pub(super) struct Wet {
    pub made: Made<Box<dyn Structure>>,
    /// Mass by area of its surface, ρ_s t \[F T²/L³\].
    pub area_density: f64,
}

/// Builds one of the structures of a scene, alone, and wets it.
pub(super) fn wet(scene: &Scene, name: &str, _fluid: &FluidScene, _threads: usize) -> Result<Wet, SceneError> {
    let kind = scene.bodies.get(name).map_or("solid", BodyScene::word);
    let (bound, repair) = ("none in a fluid yet", "remove it");
    let fault = scene.source.fault(&format!("bodies.{name}"), &format!("a {kind}"), bound, repair);
    Err(SceneError::Choice(fault))
}
