//! Checks of what cells enclose: gases and liquids.

use crate::scene::analysis::Analysis;
use crate::scene::body_in_scene::{BodyInScene, OnSet};
use crate::scene::error::{SceneError, Verdict};
use crate::scene::loads::Load;

/// Refuses contents without pressure, analyses that have no place for what is enclosed, and bodies that enclose nothing.
pub(super) fn check_enclosed(scene: &BodyInScene<'_>, load: &OnSet<'_, Load>) -> Verdict {
    let (s, at) = (&scene.scope(), load.path.as_str());
    let word = if load.gas.is_some() { "gas" } else { "volume" };
    if scene.as_shell().is_none() {
        let bound = format!("none on a {}", scene.body.word());
        let repair = "put it on a shell: cells enclose it";
        return Err(SceneError::Choice(s.fault(&load.at(word), &format!("a `{word}`"), &bound, repair)));
    }
    if let Some(gas) = &load.gas {
        s.sized(&format!("{at}.gas.pressure"), gas.pressure)?;
        let whole = gas.pressure + gas.ambient.get();
        if whole <= 0.0 {
            let (bound, repair) = match gas.pressure {
                0.0 => (
                    "above zero, or beside an `ambient` pressure".into(),
                    "add ambient = the pressure of the surroundings",
                ),
                _ => (
                    format!("above {}: a gas does not pull", -gas.ambient.get()),
                    "raise it, or the `ambient` pressure",
                ),
            };
            return Err(s.value(&format!("{at}.gas.pressure"), gas.pressure, &bound, repair));
        }
    }
    if let Some(volume) = &load.volume {
        s.sized(&format!("{at}.volume.added"), volume.added)?;
    }
    if matches!(scene.analysis, Analysis::Buckling(_)) {
        let bound =
            "none in [analysis.buckling]: a pressure that goes with the volume couples all of the shell";
        let repair = "follow the path by [analysis.static] or [analysis.arc-length], which locate critical points, or take a `pressure` in its place";
        return Err(SceneError::Choice(s.fault(&load.at(word), &format!("a `{word}`"), bound, repair)));
    }
    Ok(())
}
