//! Checks of courses in time.

use explicit_dynamics::Amplitude;

use crate::scene::body_in_scene::BodyInScene;
use crate::scene::error::{SceneError, Verdict};

/// Refuses a course where no time passes, and one out of bounds.
pub(super) fn check_amplitude(scene: &BodyInScene<'_>, at: &str, amplitude: &Amplitude) -> Verdict {
    let s = &scene.scope();
    if !scene.analysis.kind().passes_time {
        let what = scene.analysis.kind().name;
        let repair = format!("remove it: in {what} the load level takes its place");
        let fault = s.fault(at, "a course in time", &format!("none in {what}"), &repair);
        return Err(SceneError::Choice(fault));
    }
    match amplitude {
        Amplitude::Constant => Ok(()),
        Amplitude::Ramp(time) => s.positive(&format!("{at}.ramp"), *time),
        Amplitude::Smooth(time) => s.positive(&format!("{at}.smooth"), *time),
        Amplitude::Sine { period, growth } => {
            s.positive(&format!("{at}.sine.period"), *period)?;
            growth.map_or(Ok(()), |growth| s.positive(&format!("{at}.sine.growth"), growth))
        }
        Amplitude::Table(points) => {
            for (i, point) in points.iter().enumerate() {
                s.sized_all(&format!("{at}.table[{i}]"), point)?;
            }
            if !points.is_empty() && points.windows(2).all(|w| w[0][0] < w[1][0]) {
                return Ok(());
            }
            let bound = "a list of [time, factor] with ascending times";
            Err(s.value(&format!("{at}.table"), "empty or out of order", bound, "sort it by time"))
        }
    }
}
