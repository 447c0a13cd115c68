//! Solids so warm that strains are no longer small.

use crate::bodies::refusal::model_error;
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::error::SceneError;
use crate::warning::{Warning, WarningKind};

/// Free strain beyond which lengths and areas of what is warm differ by percents from those at rest.
const HOT: f64 = 0.04;

/// Warns of heat by which a free solid would strain so at most.
pub(super) fn hot(strain: f64) -> Option<Warning> {
    (strain > HOT).then(|| {
        let message = format!(
            "free, the solid would strain by {strain:.2} as it is heated, at most {HOT} of them is a small strain, by which `expansion` is meant: mind \
             the units of `expansion` and `temperature`"
        );
        Warning::new(WarningKind::LargeStrain, message)
    })
}

/// Refuses heat that leaves nothing of a solid.
///
/// # Errors
/// [`SceneError`] for a free strain of −1 or less.
pub(super) fn refuse_nothing_left<'a>(
    scene: &BodyInScene<'_>,
    strains: impl Iterator<Item = &'a f64>,
) -> Result<(), SceneError> {
    let least = strains.copied().fold(f64::INFINITY, f64::min);
    if least > -1.0 {
        return Ok(());
    }
    let message = format!(
        "free, the solid would be strained by {least:.2} and shrink to nothing; mind the units of `expansion` and `temperature`"
    );
    Err(model_error(scene.source, "loads", &message))
}
