//! From a checked scene to a body with its task: which kind is built.

use super::contacts_of_scene::ContactsOfScene;
use super::coupled::build::coupled_model;
use super::coupled::still::still_model;
use super::galerkin::build::galerkin_model;
use super::model::Model;
use super::refusal::not_a;
use super::rigid_body::build::rigid_model;
use super::shell::build::shell_model;
use super::solid::build::solid_model;
use super::together::build::together_model;
use crate::scene::body_in_scene::{BodyInScene, ShellInScene};
use crate::scene::error::SceneError;
use crate::scene::{Analysis, BodyScene, Checked};

impl Checked {
    /// Builds the body; a run will use `threads` threads (at least one), with the same results for any number.
    ///
    /// # Errors
    /// [`SceneError`] for empty sets, supports that leave a rigid motion free in a quasi-static run, and
    /// whatever the layers below refuse.
    pub fn build(&self, threads: usize) -> Result<Model, SceneError> {
        let mut model = self.body_model(threads)?;
        model.contacts = ContactsOfScene::of(self, model.body.body());
        model.cases = (!self.cases().is_empty()).then(|| Box::new(self.clone()));
        model.shaken = self.analysis.is_shaken_by_bases().then(|| Box::new(self.clone()));
        model.barred = self.error.as_ref().map(|_| Box::new(self.clone()));
        Ok(model)
    }

    /// The body of its kind.
    fn body_model(&self, threads: usize) -> Result<Model, SceneError> {
        let bodies = self.bodies_in_scene()?;
        for of_fluid in &bodies {
            if let BodyScene::Fluid(fluid) = of_fluid.body {
                if matches!(of_fluid.analysis, Analysis::Modal(_)) {
                    return still_model(&bodies, of_fluid, fluid, threads);
                }
                return coupled_model(&bodies, of_fluid, fluid, threads);
            }
        }
        // A shell has its tools itself.
        let has_tools = |of: &BodyInScene<'_>| of.as_shell().is_none() && !of.body.tools().is_empty();
        if bodies.len() > 1
            || !(self.links.is_empty() && self.joints.is_empty())
            || bodies.iter().any(has_tools)
        {
            return together_model(self, &bodies, threads);
        }
        let scene = &self.first_body()?;
        match scene.body {
            BodyScene::Shell(shell) => shell_model(&ShellInScene::new(scene, shell), threads),
            BodyScene::Solid(solid) => match solid.galerkin() {
                Some(options) => galerkin_model(scene, solid, options, threads),
                None => solid_model(scene, solid, threads),
            },
            BodyScene::Rigid(rigid) => rigid_model(scene, rigid, threads),
            BodyScene::Fluid(_) | BodyScene::Walls(_) => Err(not_a(scene, "fluid")),
        }
    }
}
