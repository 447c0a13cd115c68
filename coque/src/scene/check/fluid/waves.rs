//! Checks of waves: what a wall makes of them, and the beach on which they run out.

use fluid_sph::Waves;
use sph_core::Vec3;

use crate::scene::body_in_scene::gravity_on;
use crate::scene::error::{SceneError, Verdict};
use crate::scene::fluid::FluidScene;
use crate::scene::fluid::formulation::FluidMethod;
use crate::scene::problem::{BodyScene, Scene};
use crate::scene::scope::Scope;
use crate::scene::walls::WallMotion;
use crate::scene::waves::{Beach, WallWaves};

/// Cosine of the angle to gravity beyond which a direction is not horizontal: rounding.
const LEVEL: f64 = 1e-9;

/// Refuses waves that no wall makes, and beaches on which none run out.
pub(in crate::scene::check) fn check_waves(scene: &Scene) -> Verdict {
    let Some((name, fluid)) = scene.fluid() else { return Ok(()) };
    let gravity = gravity_on(scene, name);
    for (body, walls) in &scene.bodies {
        let BodyScene::Walls(walls) = walls else { continue };
        let Some(WallMotion { waves: Some(waves), translation, rotation }) = &walls.motion else { continue };
        let s = &scene.source.body(body, "walls");
        if translation.is_some() || rotation.is_some() {
            let (bound, repair) = ("the whole motion of the walls", "remove `translation` and `rotation`");
            return Err(SceneError::Choice(s.fault(
                "motion.waves",
                "waves beside another motion",
                bound,
                repair,
            )));
        }
        check_direction(s, "motion.waves.along", waves.along, &gravity, fluid)?;
        check_made(s, waves, &gravity)?;
    }
    let Some(beach) = &fluid.beach else { return Ok(()) };
    check_beach(&scene.source.body(name, "fluid"), fluid, beach, &gravity)
}

/// Waves need gravity, and go across it.
fn check_direction(
    s: &Scope<'_>,
    path: &str,
    along: [f64; 3],
    gravity: &Vec3,
    fluid: &FluidScene,
) -> Verdict {
    if gravity.norm() == 0.0 {
        let (bound, repair) =
            ("gravity on the fluid", "add loads = [{ on = \"all\", gravity = { acceleration = […] } }]");
        return Err(SceneError::Choice(s.fault(path, "waves", &format!("none without {bound}"), repair)));
    }
    s.direction(path, along)?;
    s.in_plane(path, along, fluid.dimensions() == 2)?;
    let along = Vec3::from(along).normalize();
    if along.dot(&gravity.normalize()).abs() > LEVEL {
        let repair = "give a direction along the surface of the water";
        return Err(s.value(path, format!("{:?}", <[f64; 3]>::from(along)), "across gravity", repair));
    }
    Ok(())
}

fn check_made(s: &Scope<'_>, waves: &WallWaves, gravity: &Vec3) -> Verdict {
    let of = Waves { period: waves.period.get(), depth: waves.depth.get(), gravity: gravity.norm() };
    if waves.height.get() > of.breaking_height() {
        let bound = format!(
            "at most {:.4}, at which waves {:.4} long in water {} deep break",
            of.breaking_height(),
            of.length(),
            waves.depth
        );
        return Err(s.value(
            "motion.waves.height",
            waves.height,
            &bound,
            "lower it, or give a longer period",
        ));
    }
    waves.hinge.map_or(Ok(()), |hinge| s.sized_all("motion.waves.hinge", &hinge))
}

fn check_beach(s: &Scope<'_>, fluid: &FluidScene, beach: &Beach, gravity: &Vec3) -> Verdict {
    s.sized_all("beach.from", &beach.from)?;
    check_direction(s, "beach.along", beach.along, gravity, fluid)?;
    if matches!(fluid.formulation.options().method, FluidMethod::Source) {
        let (bound, repair) = ("none with `method = \"source\"`", "leave the method out");
        return Err(SceneError::Choice(s.fault("beach", "a beach", bound, repair)));
    }
    let of = Waves { period: beach.period.get(), depth: beach.depth.get(), gravity: gravity.norm() };
    if beach.length.get() < of.length() {
        let bound =
            format!("at least {:.4}, the length of the waves: shorter ones send them back", of.length());
        return Err(s.value("beach.length", beach.length, &bound, "make the tank and its beach longer"));
    }
    Ok(())
}
