//! Checks of named sets, and of names of sets.

use crate::scene::body_in_scene::{BodyInScene, OnSet};
use crate::scene::error::{SceneError, Verdict};
use crate::scene::problem::BodyScene;
use crate::scene::sets::{
    BUILT_IN, EDGES, Made, OF_FILLED, OF_FLUIDS, OF_RIGID_BODIES, OF_SOLIDS, OF_WALLS, Region,
};
use crate::scene::source::suggest;
use crate::scene::walls::WallGeometry;

pub(super) fn check_sets(scene: &BodyInScene<'_>) -> Verdict {
    let s = &scene.scope();
    let (built_in, solid) = (built_in(scene.body), scene.as_solid().is_some());
    for (name, region) in &scene.sets {
        let Region { of, nearest, near, inside, plane, layer, union, intersection, difference } = region;
        let at = format!("sets.{name}");
        if let Some(of) = of {
            s.word(&format!("{at}.of"), of, &[scene.name])?;
        }
        if built_in.contains(name) {
            let fault =
                s.fault(&at, "declared", "but there is a built-in set of that name", "choose another name");
            return Err(SceneError::Set(fault));
        }
        let mut given = Vec::new();
        given.extend(nearest.map(|_| "nearest"));
        given.extend(near.map(|_| "near"));
        given.extend(inside.map(|_| "box"));
        given.extend(plane.map(|_| "plane"));
        given.extend(layer.as_ref().map(|_| "layer"));
        given.extend(union.as_ref().map(|_| "union"));
        given.extend(intersection.as_ref().map(|_| "intersection"));
        given.extend(difference.as_ref().map(|_| "difference"));
        let known = ["nearest", "near", "box", "plane", "union", "intersection", "difference", "layer"];
        s.exactly_one(&at, "region", &given, if solid { &known } else { &known[..7] })?;
        if let Some((made, names)) = region.made() {
            check_names(scene, name, made, names)?;
        }
        if let Some(point) = nearest {
            s.sized_all(&format!("{at}.nearest"), point)?;
        }
        if let Some(near) = near {
            s.sized_all(&format!("{at}.near.point"), &near.point)?;
        }
        if let Some(plane) = plane {
            s.sized_all(&format!("{at}.plane.point"), &plane.point)?;
            s.direction(&format!("{at}.plane.normal"), plane.normal)?;
        }
        if let Some(layer) = layer {
            let at = |key: &str| format!("{at}.layer.{key}");
            if !solid {
                let found = "a layer under a face";
                let bound = match scene.body {
                    BodyScene::Shell(_) => "`nearest`, `near`, `box` or `plane` on a shell",
                    _ => "`nearest`, `near`, `box` or `plane` here",
                };
                let fault = s.fault(&at("face"), found, bound, "use a box: only solids have layers");
                return Err(SceneError::Choice(fault));
            }
            s.word(&at("face"), &layer.face, &built_in[1..built_in.len().min(OF_SOLIDS.len())])?;
        }
        if let Some(region) = inside {
            s.sized_all(&format!("{at}.box.min"), &region.min)?;
            s.sized_all(&format!("{at}.box.max"), &region.max)?;
            if (0..3).any(|i| region.min[i] > region.max[i]) {
                let value = format!("min {:?}, max {:?}", region.min, region.max);
                let bound = "min ≤ max in every coordinate";
                return Err(s.value(&format!("{at}.box"), value, bound, "swap the coordinates"));
            }
        }
    }
    Ok(())
}

/// Refuses too few names, and names of no sets.
fn check_names(scene: &BodyInScene<'_>, name: &str, made: Made, names: &[String]) -> Verdict {
    let at = format!("sets.{name}.{}", made.word());
    let least = if made == Made::Difference { 2 } else { 1 };
    if names.len() < least {
        let (bound, repair) = match made {
            Made::Difference => ("two names or more", "name a set and those that are taken out of it"),
            _ => ("one name or more", "name the sets, as in [\"u0\", \"u1\"]"),
        };
        let value = if names.is_empty() { "an empty list" } else { "a list of one name" };
        return Err(scene.scope().value(&at, value, bound, repair));
    }
    let mut numbered = names.iter().enumerate();
    numbered.try_for_each(|(i, other)| check_set_name(scene, &format!("{at}[{i}]"), scene.own_set(other)))
}

/// Sets that the body has of itself.
pub(super) fn built_in(body: &BodyScene) -> &'static [&'static str] {
    match body {
        BodyScene::Shell(_) => &BUILT_IN,
        // In a plane all nodes lie on z0 and z1: only two sheets have a use for that.
        BodyScene::Solid(solid) if solid.is_plane() => &OF_SOLIDS[..5],
        BodyScene::Solid(solid) if solid.geometry.filled.is_some() => &OF_FILLED,
        BodyScene::Solid(_) => &OF_SOLIDS,
        BodyScene::Fluid(_) => &OF_FLUIDS,
        BodyScene::Rigid(_) => &OF_RIGID_BODIES,
        BodyScene::Walls(walls) => match &walls.geometry {
            WallGeometry::Basin(basin) => &OF_WALLS[..=2 * basin.min.len()],
            _ => &OF_WALLS[..1],
        },
    }
}

/// Refuses a name that is no set; those of a mesh are known when its file has been read.
pub(super) fn check_set_name(scene: &BodyInScene<'_>, path: &str, name: &str) -> Verdict {
    let of_file = scene.as_solid().is_some_and(|solid| solid.geometry.filled.is_some());
    if of_file || scene.as_shell().is_some_and(|shell| shell.geometry.mesh().is_some()) {
        return Ok(());
    }
    let own = scene.sets.keys().copied();
    let known: Vec<&str> = built_in(scene.body).iter().copied().chain(own).collect();
    if known.contains(&name) && !is_open_side(scene.body, name) {
        return Ok(());
    }
    let is_list = |name: &str| scene.source.is_called(&format!("sets.{name}"));
    let known: Vec<&str> =
        known.into_iter().filter(|known| !is_open_side(scene.body, known) && !is_list(known)).collect();
    let repair = suggest(name, &known);
    Err(SceneError::Set(scene.scope().fault(path, &format!("\"{name}\""), "which is no set", &repair)))
}

/// Whether a name is that of a side of a basin without a wall.
fn is_open_side(body: &BodyScene, name: &str) -> bool {
    match body {
        BodyScene::Walls(walls) => match &walls.geometry {
            WallGeometry::Basin(basin) => basin.open.iter().any(|open| open == name),
            _ => false,
        },
        _ => false,
    }
}

/// Refuses other sets than those on which something acts.
pub(super) fn only_on<T>(scene: &BodyInScene<'_>, item: &OnSet<'_, T>, why: &str, fit: &[&str]) -> Verdict {
    let on = item.on;
    // Whether a set of a mesh is an edge is known when its file has been read.
    let of_mesh = || scene.as_shell().is_some_and(|shell| shell.geometry.mesh().is_some());
    if fit.contains(&on) || (fit == EDGES && of_mesh()) {
        return Ok(());
    }
    let repair = format!("use one of {}", fit.join(", "));
    Err(SceneError::Set(scene.scope().fault(
        &item.at("on"),
        &format!("\"{on}\""),
        &format!("but {why}"),
        &repair,
    )))
}
