//! Checks of glue: which bodies it joins, and where there is none.

use super::contact::without_surface;
use super::sets::check_set_name;
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::error::{SceneError, Verdict};
use crate::scene::glued::{GlueInScene, glued};
use crate::scene::problem::{BodyScene, Scene};
use crate::scene::source::suggest;

/// Refuses glue of one body, in a fluid, of bodies without a surface, and of two that also touch.
pub(super) fn check_glue(scene: &Scene) -> Verdict {
    if scene.glue.is_empty() {
        return Ok(());
    }
    if scene.bodies.len() < 2 {
        let bound = "two bodies: parts of one shell are joined by [[ties]] or [[rigid]]";
        return refuse(
            scene,
            "glue",
            "glue in a scene of one body",
            bound,
            "add the other body, or use [[ties]]",
        );
    }
    if scene.fluid().is_some() {
        let bound = "none beside a fluid: structures in a fluid are not joined";
        return refuse(
            scene,
            "glue",
            "glue",
            bound,
            "make both one body, a shell of several sheets or a solid",
        );
    }
    for own in glued(scene)? {
        check_bodies(scene, &own)?;
    }
    Ok(())
}

fn check_bodies(scene: &Scene, glue: &GlueInScene<'_>) -> Verdict {
    let GlueInScene { path, on: (body, set), own } = glue;
    let (on, to) = (format!("{path}.on"), format!("{path}.to"));
    let Some(other) = scene.bodies.get(&own.to) else {
        let known: Vec<&str> = scene.bodies.keys().map(String::as_str).collect();
        let (value, repair) = (format!("\"{}\"", own.to), suggest(&own.to, &known));
        return Err(SceneError::Set(scene.source.fault(&to, &value, "which is no body", &repair)));
    };
    if own.to == *body {
        let (value, bound) = (format!("\"{}\"", own.to), "another body than that of the set");
        return refuse(
            scene,
            &to,
            &value,
            bound,
            "name another one; within one shell use [[ties]] or [[rigid]]",
        );
    }
    let Some(with_set) = scene.bodies.get(*body) else { return Ok(()) };
    if matches!(with_set, BodyScene::Rigid(_)) {
        let bound = "a set of a shell or of a solid: a rigid body has a surface, to which others are glued";
        let repair =
            format!("name a set of `{}` here and to = \"{body}\", or make both one rigid body", own.to);
        return refuse(scene, &on, &format!("\"{}\"", own.on), bound, &repair);
    }
    for (body, path) in [(with_set, &on), (other, &to)] {
        if let BodyScene::Solid(solid) = body
            && let Some(bound) = without_surface(solid)
        {
            return refuse(scene, path, "a solid without such a surface", bound, "glue another body");
        }
    }
    if own.follow.is_some() && !matches!(other, BodyScene::Shell(_)) {
        let bound = format!("directors of a shell: `{}` is none", own.to);
        let repair = "leave `follow` out, or name a set of the solid under `on` and the shell under `to`";
        return refuse(scene, &format!("{path}.follow"), "\"director\"", &bound, repair);
    }
    check_set_name(&BodyInScene::new(scene, body, with_set)?, &on, set)?;
    if let Some(number) = scene.contact.iter().position(|contact| contact.other(body) == Some(&own.to)) {
        let value = format!("glue of \"{body}\" and \"{}\"", own.to);
        let bound = format!("none of bodies that contact[{number}] lets touch: what is glued does not touch");
        return refuse(scene, path, &value, &bound, "leave the glue out, or the contact");
    }
    Ok(())
}

fn refuse(scene: &Scene, path: &str, value: &str, bound: &str, repair: &str) -> Verdict {
    Err(SceneError::Choice(scene.scope().fault(path, value, bound, repair)))
}
