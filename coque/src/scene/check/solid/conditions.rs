//! Checks of supports, loads and the velocity of a solid.

use crate::scene::analysis::Analysis;
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
                let bound = match solid.galerkin() {
                    None => "`held`, `moved`, `turned`, `symmetry` or `clamped` on a solid",
                    Some(_) => "`held`, `moved`, `symmetry` or `clamped` on a Galerkin solid",
                };
                let repair = "use held = { displacement = […] } with the directions that do not move";
                let fault = s.fault(&support.at(word), &format!("`{word}`"), bound, repair);
                return Err(SceneError::Choice(fault));
            }
            Some(OnNodes::Turned(_)) if solid.galerkin().is_some() => {
                let bound = "`held`, `moved`, `symmetry` or `clamped` on a Galerkin solid";
                let repair = "use moved = { direction = […], by = … } for a small turn, or a solid of bonds";
                return Err(SceneError::Choice(s.fault(&support.at(word), "`turned`", bound, repair)));
            }
            Some(OnNodes::Turned(turned)) => {
                if plane && (turned.axis[0] != 0.0 || turned.axis[1] != 0.0) {
                    let repair = "a plane block turns in its plane: axis = [0, 0, 1]";
                    return Err(s.value(
                        &support.at("turned.axis"),
                        format!("{:?}", turned.axis),
                        "along z",
                        repair,
                    ));
                }
                continue;
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
            LoadKind::Pressure(pressure) => {
                if pressure.values.is_some() {
                    let (value, bound) = ("numbers by particle", "one `value`, on a solid");
                    let repair = "remove `values`, or put pressures on several faces";
                    let fault = s.fault(&format!("{at}.pressure.values"), value, bound, repair);
                    return Err(SceneError::Choice(fault));
                }
                let (value, bound, repair) = match (solid.galerkin(), pressure.follower) {
                    (Some(_), false) => {
                        let repair = "add follower = true, or use traction = { value = […] }";
                        ("a dead pressure", "one that follows, on a Galerkin solid", repair)
                    }
                    (None, true) => {
                        let Some((bound, repair)) = without_following(scene, solid) else { continue };
                        ("a pressure that follows", bound, repair)
                    }
                    _ => continue,
                };
                let fault = s.fault(&format!("{at}.pressure"), value, bound, repair);
                return Err(SceneError::Choice(fault));
            }
            // Checked with those of shells.
            LoadKind::Temperature(_) => {}
            LoadKind::Couple(_) | LoadKind::Gas(_) | LoadKind::Volume(_) => {
                let bound = "`force`, `traction`, `pressure` or `gravity` on a solid";
                let repair = "use traction = { value = […] } on a face: dead force by area";
                let fault = s.fault(&format!("{at}.{word}"), &format!("`{word}`"), bound, repair);
                return Err(SceneError::Choice(fault));
            }
        }
    }
    Ok(())
}

/// Why no pressure follows the faces of a solid of bonds, and what to do.
fn without_following(scene: &BodyInScene<'_>, solid: &SolidScene) -> Option<(&'static str, &'static str)> {
    if solid.geometry.filled.is_none() {
        return Some((
            "a dead one on a block of bonds: it follows the triangles of a surface",
            "remove `follower`, fill a surface with nodes (geometry.filled), or use [bodies.NAME.solid.formulation.galerkin], whose faces it follows",
        ));
    }
    if !matches!(scene.analysis, Analysis::Explicit(_)) {
        return Some((
            "a dead one on a solid of bonds at rest: the tangent has no stiffness of it",
            "march it, by [analysis.explicit.quasi-static], remove `follower`, or use [bodies.NAME.solid.formulation.galerkin]",
        ));
    }
    let mirrored = scene.supports.iter().any(|support| support.symmetry.is_some());
    mirrored.then_some((
        "a dead one beside planes of symmetry of a solid of bonds: nodes behind them carry no surface",
        "model the whole body, or remove `follower`",
    ))
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
    let faces = &built_in(scene.body)[1..];
    if traction.depth.is_some() && solid.geometry.filled.is_some() && !faces[..6].contains(&load.on) {
        let (path, repair) = (format!("{at}.traction.depth"), "remove it, or load one of x0 to z1");
        let bound = "none but under a plane of the box round the surface";
        return Err(SceneError::Choice(s.fault(&path, "a depth", bound, repair)));
    }
    check_face(scene, load, "traction")
}

/// What acts by area acts on a face of the block; where shape functions carry it, also on a declared part of one. Of a surface that nodes fill each
/// set has a part, which is known when its file has been read.
pub(in super::super) fn check_face(scene: &BodyInScene<'_>, load: &OnSet<'_, Load>, word: &str) -> Verdict {
    let part = scene.as_solid().is_some_and(|solid| solid.galerkin().is_some());
    let filled = scene.as_solid().is_some_and(|solid| solid.geometry.filled.is_some());
    if filled || part && scene.sets.contains_key(load.on) {
        return Ok(());
    }
    let faces = &built_in(scene.body)[1..];
    only_on(scene, load, &format!("a {word} acts on a face of the block"), faces)
}

/// Heat that enters by area enters a face of the block, a declared part of one, or a part of a surface that is known when its file has been read.
pub(super) fn check_face_of_heat(scene: &BodyInScene<'_>, path: &str, on: &str) -> Verdict {
    let filled = scene.as_solid().is_some_and(|solid| solid.geometry.filled.is_some());
    let faces = &built_in(scene.body)[1..];
    let parts = scene.as_solid().is_some_and(|solid| solid.galerkin().is_some());
    if filled || on == "all" || faces.contains(&on) || parts && scene.sets.contains_key(on) {
        return Ok(());
    }
    let of_parts = if parts { ", or a declared set that holds a part of one" } else { "" };
    let bound = format!("but heat by area enters a face, {}{of_parts}", faces.join(", "));
    let repair = "heat by area enters a face; use `flow` on other nodes, or `source` by volume";
    Err(SceneError::Set(scene.scope().fault(path, &format!("\"{on}\""), &bound, repair)))
}
