//! From a scene of several bodies to one that marches them together.

use crate::bodies::Model;
use crate::scene::Scene;
use crate::scene::error::SceneError;

impl Scene {
    /// Builds a fluid with its walls and the structures in it.
    pub(in crate::bodies) fn model_together(&self, _threads: usize) -> Result<Model, SceneError> {
        let name = self.fluid().map_or("", |(name, _)| name);
        let (bound, repair) = ("a shell or a solid", "wait for a program that runs fluids");
        Err(SceneError::Choice(self.source.fault(&format!("bodies.{name}"), "a fluid", bound, repair)))
    }
}
