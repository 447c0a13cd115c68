//! Checks of contacts: which bodies may touch, and where there is none.

use crate::scene::contact::ContactScene;
use crate::scene::error::{SceneError, Verdict};
use crate::scene::problem::{BodyScene, Scene};

/// Refuses contacts of bodies that are no shells, pairs that are named twice, and analyses that know none.
pub(super) fn check_contact(scene: &Scene) -> Verdict {
    if scene.contact.is_empty() {
        return Ok(());
    }
    for (number, own) in scene.contact.iter().enumerate() {
        match &own.between {
            Some(between) => check_pair(scene, number, between)?,
            None => check_itself(scene, number)?,
        }
    }
    let kind = scene.analysis.kind();
    if !kind.touches {
        let bound = format!("none in {}, in which nothing opens or closes", kind.name);
        let repair = "use [analysis.static] or [analysis.explicit], or leave the contact out";
        return refuse(scene, "contact", "contact", &bound, repair);
    }
    Ok(())
}

/// A body with itself: a shell that is alone in its scene, once.
fn check_itself(scene: &Scene, number: usize) -> Verdict {
    let path = format!("contact[{number}]");
    if scene.is_together() {
        let (value, bound) =
            ("nothing", "two bodies of the scene: shells touch themselves where they are alone");
        let repair = "add between = [\"…\", \"…\"], or leave the contact out";
        return refuse(scene, &format!("{path}.between"), value, bound, repair);
    }
    if number > 0 {
        let bound = "one: it is all of the contact of the body with itself";
        return refuse(scene, &path, "another contact", bound, "remove it");
    }
    if scene.as_shell().is_none() {
        let repair = "leave it out; fragments of a solid of bonds touch by [bodies.NAME.solid.contact]";
        return refuse(scene, "contact", "contact of a body with itself", "that of a shell", repair);
    }
    Ok(())
}

/// Two shells of a scene without a fluid, each pair once.
fn check_pair(scene: &Scene, number: usize, between: &[String; 2]) -> Verdict {
    let path = format!("contact[{number}].between");
    let named = format!("\"{}\" and \"{}\"", between[0], between[1]);
    if scene.fluid().is_some() {
        let repair = "leave it out, or leave the fluid out";
        return refuse(scene, &path, &named, "of a scene without a fluid", repair);
    }
    for name in between {
        if matches!(scene.bodies.get(name), Some(BodyScene::Shell(_))) {
            continue;
        }
        let shells = scene.bodies.iter().filter(|(_, body)| matches!(body, BodyScene::Shell(_)));
        let shells = shells.map(|(name, _)| name.as_str()).collect::<Vec<_>>();
        let repair = format!("name two of the shells {}", shells.join(", "));
        return refuse(scene, &path, &format!("\"{name}\""), "a shell of the scene", &repair);
    }
    if between[0] == between[1] {
        let bound = "two bodies: one touches itself where it is alone, by [[contact]] without `between`";
        return refuse(scene, &path, &named, bound, "name another body");
    }
    let same = |other: &ContactScene| {
        other.between.as_ref().is_some_and(|other| between.iter().all(|name| other.contains(name)))
    };
    if let Some(first) = scene.contact[..number].iter().position(same) {
        let bound = format!("named once: contact[{first}] is of the same two");
        return refuse(scene, &path, &named, &bound, "remove one of them");
    }
    Ok(())
}

fn refuse(scene: &Scene, path: &str, value: &str, bound: &str, repair: &str) -> Verdict {
    Err(SceneError::Choice(scene.scope().fault(path, value, bound, repair)))
}
