//! Checks of a base that is shaken in time.

use explicit_dynamics::Amplitude;

use super::amplitude::check_amplitude;
use crate::scene::analysis::MovingBase;
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::error::{SceneError, Verdict};

/// Refuses a base without a direction, one that goes on accelerating after its record, and what does not go along with it.
pub(super) fn check_base(scene: &BodyInScene<'_>, base: &MovingBase, duration: f64) -> Verdict {
    let (s, at) = (&scene.scope(), "analysis.explicit.transient.base");
    if scene.in_fluid {
        let bound = "none of a fluid, whose walls and structures move by themselves";
        let repair = "move the walls by `motion`, and structures by `moved`, each with the amplitude of the displacement";
        return Err(SceneError::Choice(s.fault(at, "a base that is shaken", bound, repair)));
    }
    s.direction(&format!("{at}.acceleration"), base.acceleration)?;
    let course = format!("{at}.amplitude");
    check_amplitude(scene, &course, &base.amplitude)?;
    if let Amplitude::Table(points) = &base.amplitude
        && let Some([end, last]) = points.last()
        && *last != 0.0
        && *end < duration
    {
        let value = format!("{last} at its end, the time {end}");
        let bound = format!(
            "zero there, or beyond the run of {duration}: a table stays as it ends, and the base would go on accelerating"
        );
        let repair = "add a point with the factor 0 behind the last, or shorten the run";
        return Err(s.value(&format!("{course}.table"), value, &bound, repair));
    }
    Ok(())
}
