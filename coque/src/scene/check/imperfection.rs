//! Checks of the deflection of the unstrained body.

use crate::scene::body_in_scene::BodyInScene;
use crate::scene::error::{SceneError, Verdict};
use crate::scene::imperfection::Imperfection;
use crate::scene::scope::Scope;

/// Refuses an imperfection that the body cannot have.
pub(super) fn check_imperfection(scene: &BodyInScene<'_>, s: &Scope<'_>) -> Verdict {
    let Some(Imperfection { mode, half_waves, amplitude }) = scene.imperfection() else { return Ok(()) };
    let mut given = Vec::new();
    given.extend(mode.map(|_| "mode"));
    given.extend(half_waves.map(|_| "half_waves"));
    s.exactly_one("imperfection", "shape", &given, &["mode", "half_waves"])?;
    s.sized("imperfection.amplitude", amplitude)?;
    if mode.is_some() {
        let refuse = |value: &str, bound: &str, repair: &str| {
            Err(SceneError::Choice(s.fault("imperfection.mode", value, bound, repair)))
        };
        if scene.is_united() {
            let bound =
                "a body alone: where several act on each other, or links on one, its loads are not its own";
            return refuse("a mode of a body that others act on", bound, "remove the imperfection");
        }
        if scene.has_preload() {
            let bound = "none beside a preload";
            let repair = "remove `preload`, or give a mesh that has the deflection";
            return refuse("a mode", bound, repair);
        }
    }
    let Some(waves) = half_waves else { return Ok(()) };
    if !scene.as_solid().is_some_and(|solid| solid.has_directors()) {
        let fault = s.fault(
            "imperfection.half_waves",
            "half-waves",
            "none but of a plate of two sheets",
            "use mode = 1 in their place, or [formulation.two-sheets]",
        );
        return Err(SceneError::Choice(fault));
    }
    for (i, waves) in waves.into_iter().enumerate() {
        let repair = "1 is one bulge from edge to edge";
        s.within(&format!("imperfection.half_waves[{i}]"), f64::from(waves), [1.0, 1000.0], repair)?;
    }
    Ok(())
}
