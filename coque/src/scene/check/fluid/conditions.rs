//! Checks of what acts on a fluid and on walls: gravity on the one, nothing on the other.

use crate::scene::body_in_scene::{BodyInScene, OnSet};
use crate::scene::error::{SceneError, Verdict};
use crate::scene::fluid::FluidScene;
use crate::scene::loads::Load;
use crate::scene::problem::BodyScene;
use crate::scene::scope::Scope;

/// Refuses a velocity out of the plane of a plane fluid.
pub(in crate::scene::check) fn check_velocity_of_fluid(fluid: &FluidScene, s: &Scope<'_>) -> Verdict {
    let (Some(velocity), plane) = (&fluid.velocity, fluid.dimensions() == 2) else { return Ok(()) };
    s.in_plane("velocity.linear", velocity.linear.unwrap_or_default(), plane)?;
    match velocity.spin {
        Some(spin) if plane && (spin.axis[0] != 0.0 || spin.axis[1] != 0.0) => {
            let repair = "a plane fluid turns in its plane: axis = [0, 0, 1]";
            Err(s.value("velocity.spin.axis", format!("{:?}", spin.axis), "along z", repair))
        }
        _ => Ok(()),
    }
}

/// Refuses a support of what no support holds.
pub(in crate::scene::check) fn check_unsupported(scene: &BodyInScene<'_>, at: &str) -> Verdict {
    let (what, repair) = match scene.body {
        BodyScene::Fluid(_) => ("a fluid", "bound it by walls, as in [bodies.tank.walls]"),
        BodyScene::Walls(_) => ("walls", "walls stand of themselves, or move by `motion`"),
        BodyScene::Shell(_) | BodyScene::Solid(_) | BodyScene::Rigid(_) => return Ok(()),
    };
    let value = format!("a support of {what}");
    let fault = scene.scope().fault(at, &value, "one of a shell or a solid", repair);
    Err(SceneError::Choice(fault))
}

/// Refuses all loads of a fluid but constant gravity; on walls none acts.
pub(in crate::scene::check) fn check_load_of_fluid(
    scene: &BodyInScene<'_>,
    load: &OnSet<'_, Load>,
) -> Verdict {
    let (s, at) = (&scene.scope(), load.path.as_str());
    let fluid = match scene.body {
        BodyScene::Fluid(fluid) => fluid,
        // Gravity on all bodies is no fault of the walls.
        BodyScene::Walls(_) if load.on == "all" && load.gravity.is_some() => return Ok(()),
        BodyScene::Walls(_) => {
            let repair = "remove it, or let it name another body";
            let fault = s.fault(at, "a load on walls", "one of a fluid, a shell or a solid", repair);
            return Err(SceneError::Choice(fault));
        }
        BodyScene::Shell(_) | BodyScene::Solid(_) | BodyScene::Rigid(_) => return Ok(()),
    };
    let Some(gravity) = load.gravity else {
        let repair = "only gravity acts on a fluid; walls and structures do the rest";
        return Err(SceneError::Choice(s.fault(at, "another load", "gravity on a fluid", repair)));
    };
    if load.amplitude.is_some() {
        let path = format!("{at}.amplitude");
        let repair = "remove it: gravity on a fluid is constant; move the walls instead";
        return Err(SceneError::Choice(s.fault(&path, "a course in time", "none on a fluid", repair)));
    }
    let path = format!("{at}.gravity.acceleration");
    s.in_plane(&path, gravity.acceleration, fluid.dimensions() == 2)
}
