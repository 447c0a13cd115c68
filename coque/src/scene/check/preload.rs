//! Checks of the preload: which conditions, bodies and analyses it goes with.

use crate::scene::analysis::Analysis;
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
    let load = scene.loads.iter().find(|load| load.preload).map(|load| load.at("preload"));
    let motion = || scene.supports.iter().find(|support| support.preload).map(|motion| motion.at("preload"));
    let Some(path) = load.or_else(motion) else {
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
            false => "use [analysis.static], [analysis.arc-length], [analysis.modal] or [analysis.buckling]",
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
