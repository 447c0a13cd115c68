//! What shells and solids that conduct heat have alike: which loads take it up, and that nothing moves where temperatures alone are sought.

use crate::scene::body_in_scene::BodyInScene;
use crate::scene::error::{SceneError, Verdict};
use crate::scene::loads::Load;

/// Whether a load takes conducted temperatures.
pub(super) fn conducted(load: &Load) -> bool {
    load.temperature.as_ref().is_some_and(|own| own.conducted.is_some())
}

/// Refuses a key of mechanics in a heat analysis.
pub(super) fn refuse_mechanics(scene: &BodyInScene<'_>, key: &str) -> Verdict {
    if key == "output.fields" {
        let bound = "`every` and `extruded` alone in a heat analysis, in which nothing is strained: temperatures and where heat runs are always in the files";
        let (value, repair) = (
            "stresses",
            "remove them, or use [analysis.static] with a load whose `temperature` is `conducted`",
        );
        return Err(SceneError::Choice(scene.scope().fault(key, value, bound, repair)));
    }
    let s = if matches!(key, "supports" | "loads") { scene.scope() } else { scene.body_scope() };
    let (value, bound) = (format!("`{key}`"), "none in a heat analysis, in which nothing moves");
    let repair = "remove it, or use [analysis.static] with a load whose `temperature` is `conducted`";
    Err(SceneError::Choice(s.fault(key, &value, bound, repair)))
}
