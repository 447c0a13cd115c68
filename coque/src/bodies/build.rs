//! From a scene to a body with its task: which kind is built, and what all kinds refuse and share.

use super::model::Model;
use crate::scene::error::SceneError;
use crate::scene::{self, Analysis, BodyScene, Scene};

impl Scene {
    /// Builds the body; a run will use `threads` threads (at least one), with the same results for any number.
    ///
    /// # Errors
    /// [`SceneError`] for whatever [`Scene::parse`] refuses (fields may have been changed since), for empty
    /// sets, supports that leave a rigid motion free in a quasi-static run, and
    /// whatever the layers below refuse.
    pub fn build(&self, threads: usize) -> Result<Model, SceneError> {
        self.check()?;
        match self.body() {
            BodyScene::Shell(_) if !self.is_together() => self.shell_model(threads),
            BodyScene::Solid(solid) if !self.is_together() => match solid.galerkin() {
                Some(options) => self.galerkin_model(solid, options, threads),
                None => self.solid_model(solid, threads),
            },
            _ => self.model_together(threads),
        }
    }

    /// Refusal of a body of another kind than a program asks for.
    pub(super) fn not_a(&self, wanted: &str) -> SceneError {
        let path = self.body_scope().path("");
        let repair =
            format!("give a scene with a {wanted}, or build it as the {} that it is", self.body().word());
        let value = format!("a {}", self.body().word());
        SceneError::Choice(self.source.fault(
            path.trim_end_matches('.'),
            &value,
            &format!("a {wanted}"),
            &repair,
        ))
    }

    /// Refuses a body of which nothing can move, and more modes than dofs.
    pub(super) fn refuse_dof(&self, dofs: usize) -> Result<(), SceneError> {
        if dofs == 0 {
            let (found, bound) = ("no freedom of any particle", "at least one that is not held");
            let repair = "take out a support, or let it name fewer particles";
            return Err(SceneError::Choice(self.source.fault("supports", found, bound, repair)));
        }
        let (path, modes) = match &self.analysis {
            Analysis::Modal(wanted) => ("analysis.modal.modes", wanted.modes),
            Analysis::Buckling(wanted) => ("analysis.buckling.modes", wanted.modes),
            _ => return Ok(()),
        };
        if modes <= dofs {
            return Ok(());
        }
        let bound = format!("at most {dofs}, the degrees of freedom that no support holds");
        Err(self.source.value(path, modes, &bound, "the lowest few modes are usual; or use more particles"))
    }

    /// Refuses supports that leave rigid motions free, where an answer needs them held; a run in real time and vibration do
    /// not.
    pub(super) fn refuse_free_motion(&self, free: impl FnOnce() -> Vec<String>) -> Result<(), SceneError> {
        let kind = self.analysis.kind();
        if kind.floats && !self.has_preload() {
            return Ok(());
        }
        let free = free();
        if free.is_empty() {
            return Ok(());
        }
        let path = if self.supports.is_empty() { "supports" } else { "supports[0]" };
        let bound = format!("every rigid motion must be held in {}", kind.name);
        let repair = match self.body() {
            BodyScene::Shell(_) => {
                "hold it: clamp an edge, add a symmetry plane, or hinge three particles out of line"
            }
            _ => "hold it: clamp a face, add a symmetry plane, or hold nodes out of line",
        };
        let value = format!("{} free to move: {}", self.body().word(), free.join(", "));
        Err(SceneError::FreeMotion(self.source.fault(path, &value, &bound, repair)))
    }

    /// Messages from below end with their repair, after the last semicolon.
    pub(super) fn model_error(&self, path: &str, message: &str) -> SceneError {
        let (value, repair) = message.rsplit_once("; ").unwrap_or((message, "change this part of the scene"));
        SceneError::Model(self.source.fault(path, value, "", repair))
    }

    /// The same for a key of the body.
    pub(super) fn body_error(&self, path: &str, message: &str) -> SceneError {
        self.model_error(&self.body_scope().path(path), message)
    }
}

/// The course of a load or a motion in time.
pub(super) fn amplitude(course: Option<&scene::Amplitude>) -> explicit_dynamics::Amplitude {
    use explicit_dynamics::Amplitude;
    match course {
        None | Some(scene::Amplitude::Constant) => Amplitude::Constant,
        Some(scene::Amplitude::Ramp(time)) => Amplitude::Ramp(*time),
        Some(scene::Amplitude::Smooth(time)) => Amplitude::Smooth(*time),
        Some(scene::Amplitude::Table(points)) => Amplitude::Table(points.clone()),
        Some(scene::Amplitude::Sine { period }) => Amplitude::Sine { period: *period },
    }
}
