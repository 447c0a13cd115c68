//! What all kinds of bodies refuse, and the words of refusals from the layers below.

use crate::scene::body_in_scene::BodyInScene;
use crate::scene::error::SceneError;
use crate::scene::source::Source;
use crate::scene::{Analysis, BodyScene, Harmonic, Scene};

/// Refusal of a body of another kind than a program asks for.
pub(super) fn not_a(scene: &BodyInScene<'_>, wanted: &str) -> SceneError {
    let path = scene.body_scope().path("");
    let word = scene.body.word();
    let repair = format!("give a scene with a {wanted}, or build it as the {word} that it is");
    let (path, wanted) = (path.trim_end_matches('.'), format!("a {wanted}"));
    SceneError::Choice(scene.source.fault(path, &format!("a {word}"), &wanted, &repair))
}

/// Refuses a body of which nothing can move, and more modes than dofs.
pub(super) fn refuse_dof(scene: &BodyInScene<'_>, dofs: usize) -> Result<(), SceneError> {
    if dofs == 0 {
        let (found, bound) = ("no freedom of any particle", "at least one that is not held");
        let repair = "take out a support, or let it name fewer particles";
        return Err(SceneError::Choice(scene.source.fault("supports", found, bound, repair)));
    }
    if scene.together { Ok(()) } else { refuse_modes(scene.scene, dofs) }
}

/// Refuses more modes than there are unknowns.
pub(super) fn refuse_modes(scene: &Scene, dofs: usize) -> Result<(), SceneError> {
    let (path, modes) = match &scene.analysis {
        Analysis::Modal(wanted) => ("analysis.modal.modes", wanted.modes),
        Analysis::Harmonic(Harmonic { modes: Some(modes), .. }) => ("analysis.harmonic.modes", *modes),
        Analysis::ResponseSpectrum(wanted) => ("analysis.response-spectrum.modes", wanted.modes),
        Analysis::RandomVibration(wanted) => ("analysis.random-vibration.modes", wanted.modes),
        Analysis::Buckling(wanted) => ("analysis.buckling.modes", wanted.modes),
        _ => return Ok(()),
    };
    if modes.get() <= dofs {
        return Ok(());
    }
    let bound = format!("at most {dofs}, the degrees of freedom that no support holds");
    Err(scene.source.value(path, modes, &bound, "the lowest few modes are usual; or use more particles"))
}

/// Refuses supports that leave rigid motions free, where an answer needs them held; a run in real time and vibration do not.
pub(super) fn refuse_free_motion(
    scene: &BodyInScene<'_>,
    free: impl FnOnce() -> Vec<String>,
) -> Result<(), SceneError> {
    let kind = scene.analysis.kind();
    // What joins it to another body may hold it: the balance tells.
    if scene.joined || kind.floats && !scene.has_preload() {
        return Ok(());
    }
    let free = free();
    if free.is_empty() {
        return Ok(());
    }
    let path = scene.supports.first().map_or("supports", |first| &first.path);
    let bound = format!("every rigid motion must be held in {}", kind.name);
    let repair = match scene.body {
        BodyScene::Shell(_) => {
            "hold it: clamp an edge, add a symmetry plane, or hinge three particles out of line"
        }
        BodyScene::Rigid(_) => "hold it: `clamped`, `held`, or springs to the ground or to another body",
        _ => "hold it: clamp a face, add a symmetry plane, or hold nodes out of line",
    };
    let word = if scene.as_rigid().is_some() { "rigid body" } else { scene.body.word() };
    let value = format!("{word} free to move: {}", free.join(", "));
    Err(SceneError::FreeMotion(scene.source.fault(path, &value, &bound, repair)))
}

/// Messages from below end with their repair, after the last semicolon.
pub(super) fn model_error(source: &Source, path: &str, message: &str) -> SceneError {
    let (value, repair) = message.rsplit_once("; ").unwrap_or((message, "change this part of the scene"));
    SceneError::Model(source.fault(path, value, "", repair))
}

/// The same for a key of the body.
pub(super) fn body_error(scene: &BodyInScene<'_>, path: &str, message: &str) -> SceneError {
    model_error(scene.source, &scene.body_scope().path(path), message)
}

/// The refusal of a body that stands in one of its tools, or in walls that are one, before anything moves.
pub(super) fn in_tool(scene: &BodyInScene<'_>, number: usize, value: String, bound: &str) -> SceneError {
    match scene.body.tools().get(number).and_then(|tool| tool.of_contact) {
        Some(contact) => {
            let repair = "move the body out of the walls by that depth, or leave the contact out";
            scene.scope().value(&format!("contact[{contact}]"), value, bound, repair)
        }
        None => {
            let repair = "move the tool away by that depth, and let `moved` bring it";
            scene.body_scope().value(&format!("tools[{number}]"), value, bound, repair)
        }
    }
}
