//! Checks of where a shell stands in space, and of which faces a fluid wets.

use crate::scene::body_in_scene::BodyInScene;
use crate::scene::error::{SceneError, Verdict};
use crate::scene::scope::Scope;
use crate::scene::shell::ShellScene;
use sph_core::Vec3;

/// Greatest cosine between directions at right angles: rounding of decimal numbers.
const UPRIGHT: f64 = 1e-6;

impl ShellScene {
    pub(super) fn check_placed(&self, s: &Scope<'_>) -> Verdict {
        let Some(placed) = self.placed else { return Ok(()) };
        s.sized_all("placed.origin", &placed.origin)?;
        s.direction("placed.u", placed.u)?;
        s.direction("placed.v", placed.v)?;
        if self.orientation.is_some() {
            let repair =
                "keep one: `placed` moves the shape alone, `orientation` turns conditions and probes with it";
            return Err(SceneError::Choice(s.fault(
                "placed",
                "a place",
                "none beside `orientation`",
                repair,
            )));
        }
        let [u, v] = [placed.u, placed.v].map(|v| Vec3::from(v).normalize());
        if u.dot(&v).abs() <= UPRIGHT {
            return Ok(());
        }
        let repair = "turn it until its product with `u` is zero";
        Err(s.value("placed.v", format!("{:?}", placed.v), "at right angles to `placed.u`", repair))
    }
}

/// Refuses wet faces where nothing wets them, and a turned frame beside other bodies.
pub(in crate::scene::check) fn check_wetting(
    scene: &BodyInScene<'_>,
    shell: &ShellScene,
    s: &Scope<'_>,
) -> Verdict {
    if shell.wet.is_some() && !scene.in_fluid {
        let repair = "remove it, or add a fluid, as in [bodies.water.fluid]";
        return Err(SceneError::Choice(s.fault("wet", "wet faces", "none without a fluid", repair)));
    }
    if shell.orientation.is_some() && scene.together {
        let repair = "use placed = { origin = […], u = […], v = […] }, which moves the shape alone";
        let bound = "none beside other bodies: gravity and probes would turn with it";
        return Err(SceneError::Choice(s.fault("orientation", "a rotation", bound, repair)));
    }
    Ok(())
}
