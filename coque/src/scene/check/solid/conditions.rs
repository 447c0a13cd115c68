//! Checks of supports, loads and the velocity of a solid.

use crate::scene::body_in_scene::{BodyInScene, OnSet};
use crate::scene::check::sets::{built_in, only_on};
use crate::scene::error::{SceneError, Verdict};
use crate::scene::loads::{Load, LoadKind};
use crate::scene::solid::SolidScene;
use crate::scene::supports::{OnNodes, Support};

/// Refuses a velocity out of the plane of a plane block.
pub(super) fn check_solid_velocity(scene: &BodyInScene<'_>, solid: &SolidScene) -> Verdict {
    let (s, plane) = (&scene.body_scope(), solid.is_plane());
    let Some(velocity) = &solid.velocity else { return Ok(()) };
    s.in_plane("velocity.linear", velocity.linear.unwrap_or_default(), plane)?;
    match velocity.spin {
        Some(spin) if plane && (spin.axis[0] != 0.0 || spin.axis[1] != 0.0) => {
            let repair = "a plane block turns in its plane: axis = [0, 0, 1]";
            Err(s.value("velocity.spin.axis", format!("{:?}", spin.axis), "along z", repair))
        }
        _ => Ok(()),
    }
}

/// Refuses what nodes cannot be held by.
pub(in super::super) fn check_solid_support(
    scene: &BodyInScene<'_>,
    support: &OnSet<'_, Support>,
    solid: &SolidScene,
) -> Verdict {
    let (s, plane, at) = (&scene.scope(), solid.is_plane(), &support.path);
    for (word, kind) in support.kinds() {
        match kind.on_nodes() {
            None => {
                let bound = "`held`, `moved`, `symmetry` or `clamped` on a solid";
                let repair = "use held = { displacement = […] } with the directions that do not move";
                let fault = s.fault(&support.at(word), &format!("`{word}`"), bound, repair);
                return Err(SceneError::Choice(fault));
            }
            Some(OnNodes::Held(held))
                if word == "held" && !held.director.is_empty() && !solid.has_directors() =>
            {
                let repair = "remove it: only plates of two sheets have directors";
                let fault = s.fault(&support.at("held.director"), "a director", "none here", repair);
                return Err(SceneError::Choice(fault));
            }
            Some(_) => {}
        }
        for (key, v) in kind.vectors() {
            s.in_plane(&format!("{at}.{word}.{key}"), v, plane)?;
        }
    }
    Ok(())
}

/// Refuses what nodes cannot carry.
pub(in super::super) fn check_solid_load(
    scene: &BodyInScene<'_>,
    load: &OnSet<'_, Load>,
    solid: &SolidScene,
) -> Verdict {
    let (s, plane, at) = (&scene.scope(), solid.is_plane(), &load.path);
    for (word, kind) in load.kinds() {
        match kind {
            LoadKind::Force(force) => s.in_plane(&format!("{at}.force.total"), force.total, plane)?,
            LoadKind::Gravity(gravity) => {
                s.in_plane(&format!("{at}.gravity.acceleration"), gravity.acceleration, plane)?
            }
            LoadKind::Traction(traction) => {
                s.in_plane(&format!("{at}.traction.value"), traction.value, plane)?
            }
            LoadKind::Pressure(pressure) if solid.galerkin().is_some() => {
                if pressure.values.is_some() {
                    let (value, bound) = ("numbers by particle", "one `value`, on a solid");
                    let repair = "remove `values`, or put pressures on several faces";
                    let fault = s.fault(&format!("{at}.pressure.values"), value, bound, repair);
                    return Err(SceneError::Choice(fault));
                }
                if !pressure.follower {
                    let (value, bound) = ("a dead pressure", "one that follows, on a solid");
                    let repair = "add follower = true, or use traction = { value = […] }";
                    let fault = s.fault(&format!("{at}.pressure"), value, bound, repair);
                    return Err(SceneError::Choice(fault));
                }
            }
            LoadKind::Couple(_)
            | LoadKind::Pressure(_)
            | LoadKind::Gas(_)
            | LoadKind::Volume(_)
            | LoadKind::Temperature(_) => {
                let bound = match solid.galerkin() {
                    None => "`force`, `traction` or `gravity` on a solid",
                    Some(_) => "`force`, `traction`, `pressure` or `gravity` on a solid",
                };
                let repair = "use traction = { value = […] } on a face: dead force by area";
                let fault = s.fault(&format!("{at}.{word}"), &format!("`{word}`"), bound, repair);
                return Err(SceneError::Choice(fault));
            }
        }
    }
    Ok(())
}

/// A traction acts on a face of a block, or on cells of a shell.
pub(in super::super) fn check_traction(scene: &BodyInScene<'_>, load: &OnSet<'_, Load>) -> Verdict {
    let (s, at) = (&scene.scope(), &load.path);
    let Some(traction) = load.traction else { return Ok(()) };
    s.sized_all(&format!("{at}.traction.value"), &traction.value)?;
    let Some(solid) = scene.as_solid() else {
        if traction.depth.is_none() {
            return Ok(());
        }
        let (path, repair) =
            (format!("{at}.traction.depth"), "remove it: a shell has one layer of particles");
        return Err(SceneError::Choice(s.fault(&path, "a depth", "none on a shell", repair)));
    };
    if traction.depth.is_some() && solid.galerkin().is_some() {
        let repair = "remove it: a Galerkin solid takes a traction on the face itself";
        let path = format!("{at}.traction.depth");
        return Err(SceneError::Choice(s.fault(&path, "a depth", "none without bonds", repair)));
    }
    check_face(scene, load, "traction")
}

/// What acts by area acts on a face of the block; where shape functions carry it, also on a declared part of one.
pub(in super::super) fn check_face(scene: &BodyInScene<'_>, load: &OnSet<'_, Load>, word: &str) -> Verdict {
    let part = scene.as_solid().is_some_and(|solid| solid.galerkin().is_some());
    if part && scene.sets.contains_key(load.on) {
        return Ok(());
    }
    let faces = &built_in(scene.body)[1..];
    only_on(scene, load, &format!("a {word} acts on a face of the block"), faces)
}
