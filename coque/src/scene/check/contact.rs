//! Checks of contacts: which bodies may touch, and where there is none.

use crate::scene::contact::ContactScene;
use crate::scene::error::{SceneError, Verdict};
use crate::scene::problem::Scene;

/// Refuses contacts of bodies that are no lone shell, of several bodies, a second one, and analyses that know none.
pub(super) fn check_contact(scene: &Scene) -> Verdict {
    let Some(ContactScene { between, .. }) = scene.contact.first() else { return Ok(()) };
    let s = scene.scope();
    let refuse = |path: &str, value: &str, bound: &str, repair: &str| {
        Err(SceneError::Choice(s.fault(path, value, bound, repair)))
    };
    if between.is_some() || scene.is_together() {
        let (path, value) = match between {
            Some(_) => ("contact[0].between", "contact of two bodies"),
            None => ("contact", "contact of a body in a scene of several"),
        };
        let repair =
            "leave it out; a lone shell touches itself by [[contact]] without `between`, and rigid [[tools]]";
        return refuse(path, value, "none: bodies of one scene do not touch each other yet", repair);
    }
    if scene.contact.len() > 1 {
        let bound = "one: it is all of the contact of the body with itself";
        return refuse("contact[1]", "another contact", bound, "remove it");
    }
    if scene.as_shell().is_none() {
        let repair = "leave it out; fragments of a solid of bonds touch by [bodies.NAME.solid.contact]";
        return refuse("contact", "contact of a body with itself", "that of a shell", repair);
    }
    let kind = scene.analysis.kind();
    if !kind.touches {
        let bound = format!("none in {}, in which nothing opens or closes", kind.name);
        let repair = "use [analysis.static] or [analysis.explicit], or leave the contact out";
        return refuse("contact", "contact of the shell with itself", &bound, repair);
    }
    Ok(())
}
