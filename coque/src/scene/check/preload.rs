//! Checks of the preload: which conditions, bodies and analyses it goes with.

use crate::scene::analysis::Analysis;
use crate::scene::analysis_kind::Contacts;
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::error::{SceneError, Verdict};
use crate::scene::statics::Prebuckling;

/// Refuses a preload where nothing could apply or hold it.
pub(super) fn check_preload(scene: &BodyInScene<'_>) -> Verdict {
    let s = &scene.scope();
    let refuse = |path: &str, bound: &str, repair: &str| {
        Err(SceneError::Choice(s.fault(path, "a preload", bound, repair)))
    };
    let mut moved = scene.supports.iter().filter(|support| support.preload);
    if let Some(support) = moved.find(|support| support.motion().is_none()) {
        let repair = "remove it: what stands still needs none";
        return refuse(&support.at("preload"), "`moved`, `rotated` or `turned` beside it", repair);
    }
    check_frozen(scene)?;
    let load = scene.loads.iter().find(|load| load.preload).map(|load| load.at("preload"));
    let motion = || scene.supports.iter().find(|support| support.preload).map(|motion| motion.at("preload"));
    let tool = || {
        let tools = &scene.as_shell()?.tools;
        let number = tools.iter().position(|tool| tool.preload)?;
        Some(scene.body_scope().path(&format!("tools[{number}].preload")))
    };
    let Some(path) = load.or_else(motion).or_else(tool) else {
        return Ok(());
    };
    if scene.as_shell().is_none() {
        let bound = format!("none on a {}", scene.body.word());
        return refuse(&path, &bound, "remove it: only shells are preloaded");
    }
    let kind = scene.analysis.kind();
    if !kind.preloads {
        let repair = match kind.passes_time {
            true => "remove it, and let an `amplitude` bring the load up and hold it",
            false => {
                "use [analysis.static], arc-length, modal, harmonic, response-spectrum, random-vibration or buckling"
            }
        };
        return refuse(&path, &format!("none in {}", kind.name), repair);
    }
    match &scene.analysis {
        Analysis::Buckling(wanted) if wanted.prebuckling == Prebuckling::Stress => {
            let bound = "\"rotations\" from a state with stresses of its own";
            let repair = "leave it out: the stresses of the load alone are computed from an unloaded shell";
            Err(s.value("analysis.buckling.prebuckling", "\"stress\" beside a preload", bound, repair))
        }
        _ => Ok(()),
    }
}

/// Refuses contact that stays as it is where nothing brings it about, and friction of a shell on itself there.
fn check_frozen(scene: &BodyInScene<'_>) -> Verdict {
    let kind = scene.analysis.kind();
    if !(kind.contacts == Contacts::Frozen && scene.may_touch()) {
        return Ok(());
    }
    let tools = scene.as_shell().is_some_and(|shell| !shell.tools.is_empty());
    let s = if tools { scene.body_scope() } else { scene.scope() };
    if !scene.has_preload() {
        let key = if tools { "tools" } else { "contact" };
        let bound =
            format!("beside a preload that brings it about: in {} it stays as that leaves it", kind.name);
        let repair =
            "add `preload = true` to a load, a support or a tool that moves, or leave the contact out";
        return Err(SceneError::Choice(s.fault(key, "contact", &bound, repair)));
    }
    let rough = scene.scene.contact.iter().position(|contact| contact.is_rough());
    if let Some(number) = rough {
        let bound = format!("smooth in {}: of what rubs, tools alone were measured there", kind.name);
        let path = format!("contact[{number}].friction");
        let fault =
            scene.scope().fault(&path, "friction of the shell on itself", &bound, "leave `friction` out");
        return Err(SceneError::Choice(fault));
    }
    Ok(())
}
