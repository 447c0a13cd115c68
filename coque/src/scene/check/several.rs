//! Checks of several bodies without a fluid: what drives them, what is applied before, springs that join them.

use super::analysis::check_driver;
use super::sets::check_set_name;
use super::wet_rigid::stays_in_plane;
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::error::{SceneError, Verdict};
use crate::scene::joints::{JointInScene, joints};
use crate::scene::problem::{BodyScene, Scene};
use crate::scene::supports::Support;

/// Refuses what bodies cannot have beside each other.
pub(super) fn check_several(scene: &Scene) -> Verdict {
    let bodies = scene.bodies.iter().map(|(name, body)| BodyInScene::new(scene, name, body));
    let bodies = bodies.collect::<Result<Vec<_>, _>>()?;
    check_depths(scene)?;
    bodies.iter().try_for_each(check_before)?;
    if !scene.analysis.kind().wants_driver || bodies.iter().any(|body| check_driver(body).is_ok()) {
        return Ok(());
    }
    bodies.first().map_or(Ok(()), check_driver)
}

/// Energies of plane bodies are those of a unit of depth, of others their own.
fn check_depths(scene: &Scene) -> Verdict {
    if scene.is_by_depth() {
        return Ok(());
    }
    let by_depth = |body: &BodyScene| match body {
        BodyScene::Solid(solid) => {
            solid.dimensions() == 2 && solid.geometry.block.as_ref().is_some_and(|b| b.thickness.is_none())
        }
        _ => false,
    };
    let Some((name, body)) = scene.bodies.iter().find(|(_, body)| by_depth(body)) else { return Ok(()) };
    let bound = "one with a thickness beside a body in space: forces of a plane body without it are those of a unit of depth";
    let scope = scene.source.body(name, body.word());
    let fault = scope.fault("geometry.block", "a plane block", bound, "add thickness = … to the block");
    Err(SceneError::Choice(fault))
}

/// What is applied before the analysis is applied to one body.
pub(super) fn check_before(body: &BodyInScene<'_>) -> Verdict {
    let refuse = |path: &str, value: &str| {
        let bound = match body.together {
            true => "none of one of several bodies: all of them are led by one level",
            false => "none beside [[links]]: all is led by one level",
        };
        let repair = "remove it, or let it grow with the other loads";
        Err(SceneError::Choice(body.source.fault(path, value, bound, repair)))
    };
    let load = body.loads.iter().find(|load| load.preload).map(|load| load.at("preload"));
    let motion = || body.supports.iter().find(|support| support.preload).map(|motion| motion.at("preload"));
    if let Some(path) = load.or_else(motion) {
        return refuse(&path, "a preload");
    }
    if body.is_stressed() && body.analysis.kind().preloads {
        return refuse(&body.body_scope().path("initial_stress"), "an initial stress");
    }
    Ok(())
}

/// Springs between bodies: along a direction, of sets that both bodies have, and nothing else in their support.
pub(super) fn check_joints(scene: &Scene) -> Verdict {
    let s = &scene.scope();
    let plane_fluid = scene.fluid().is_some_and(|(_, fluid)| fluid.dimensions() == 2);
    for JointInScene { path, ends, support, spring } in joints(scene)? {
        let at = |key: &str| format!("{path}.{key}");
        let refuse = |key: &str, value: &str, bound: &str, repair: &str| {
            Err(SceneError::Choice(s.fault(&at(key), value, bound, repair)))
        };
        for ((name, _), key) in ends.iter().zip(["on", "spring.to"]) {
            let Some(body @ (BodyScene::Fluid(_) | BodyScene::Walls(_))) = scene.bodies.get(*name) else {
                continue;
            };
            let value = match body {
                BodyScene::Fluid(_) => "a set of a fluid",
                _ => "a set of walls",
            };
            let bound = "one of a shell, a solid or a rigid body";
            return refuse(
                key,
                value,
                bound,
                "leave `to` out for springs to the ground, or name a structure",
            );
        }
        let given: Vec<&str> = support.kinds().iter().map(|(word, _)| *word).collect();
        s.exactly_one(&path, "condition", &given, &Support::WORDS)?;
        if support.preload || support.amplitude.is_some() {
            let (key, value) =
                if support.preload { ("preload", "a preload") } else { ("amplitude", "a course in time") };
            return refuse(key, value, "none of a spring, which no level scales", "remove it");
        }
        if spring.axis.is_some() {
            let bound = "none of a spring between two bodies, which resists displacements";
            return refuse("spring.axis", "an axis", bound, "give a `direction`");
        }
        let Some(direction) = spring.direction else {
            let fault = s.fault(&at("spring.direction"), "nothing", "given", "add `direction`");
            return Err(SceneError::Missing(fault));
        };
        s.direction(&at("spring.direction"), direction)?;
        for ((name, set), key) in ends.into_iter().zip(["on", "spring.to"]) {
            let Some(body) = scene.bodies.get(name) else { continue };
            let view = BodyInScene::new(scene, name, body)?;
            check_set_name(&view, &at(key), set)?;
            if let Some(solid) = view.as_solid() {
                s.in_plane(&at("spring.direction"), direction, solid.is_plane())?;
            }
            if plane_fluid && view.as_rigid().is_some() {
                stays_in_plane(s, &at("spring.direction"), direction)?;
            }
        }
    }
    Ok(())
}
