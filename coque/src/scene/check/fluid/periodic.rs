//! Checks of periodic sides: as far apart as rows of particles and the kernel want, and what does not go with them.

use super::WHOLE;
use crate::scene::error::{SceneError, Verdict};
use crate::scene::fluid::FluidScene;
use crate::scene::fluid::formulation::{FluidMethod, WallMethod};
use crate::scene::fluid::geometry::Extent;
use crate::scene::fluid::periodic::PeriodicSides;
use crate::scene::problem::{BodyScene, Scene};
use crate::scene::scope::Scope;
use crate::scene::sets::OF_WALLS;
use crate::scene::walls::WallGeometry;

/// Names of the axes.
const AXES: [&str; 3] = ["x", "y", "z"];

/// Refuses periodic sides that no lattice fits, and what they do not go with.
pub(in crate::scene::check) fn check_periodic(scene: &Scene) -> Verdict {
    let Some((name, fluid)) = scene.fluid() else { return Ok(()) };
    let Some(periodic) = &fluid.periodic else { return Ok(()) };
    let s = &scene.source.body(name, "fluid");
    check_sides(s, fluid, periodic)?;
    check_method(s, fluid)?;
    if let Some((structure, _)) = scene.structures().next() {
        let value = format!("a structure in a fluid with periodic sides, `{name}`");
        let repair = "leave out `periodic`, or make it of walls, which stand or have a given motion";
        let bound = "none: nothing wets a structure across a side";
        return Err(SceneError::Choice(scene.scope().fault(
            &format!("bodies.{structure}"),
            &value,
            bound,
            repair,
        )));
    }
    for (body, walls) in &scene.bodies {
        let BodyScene::Walls(walls) = walls else { continue };
        let WallGeometry::Basin(basin) = &walls.geometry else { continue };
        for (axis, _) in periodic.sides().iter().enumerate().filter(|(_, sides)| sides.is_some()) {
            let sides = &OF_WALLS[1 + 2 * axis..3 + 2 * axis];
            if let Some(closed) = sides.iter().find(|side| basin.open.iter().all(|open| open != *side)) {
                let value = format!("a basin closed at {closed}, along which the fluid is periodic");
                let repair = format!("add \"{closed}\" to it, or take {} out of `periodic`", AXES[axis]);
                let bound = "open at both periodic sides";
                return Err(scene.source.body(body, "walls").value(
                    "geometry.basin.open",
                    value,
                    bound,
                    &repair,
                ));
            }
        }
    }
    Ok(())
}

fn check_sides(s: &Scope<'_>, fluid: &FluidScene, periodic: &PeriodicSides) -> Verdict {
    let (spacing, smoothing) = (fluid.geometry.spacing(), fluid.formulation.options().smoothing());
    if periodic.sides().iter().all(Option::is_none) {
        let repair = "give the two sides across an axis, as in periodic = { x = [0.0, 1.0] }";
        return Err(s.value("periodic", "a table without an axis", "one with x, y or z", repair));
    }
    for (axis, sides) in periodic.sides().iter().enumerate() {
        let (Some([low, high]), path) = (*sides, format!("periodic.{}", AXES[axis])) else { continue };
        s.sized_all(&path, &[low, high])?;
        if axis >= fluid.dimensions() {
            let repair = "remove it: a plane fluid has x and y";
            return Err(s.value(
                &path,
                format!("[{low}, {high}]"),
                "an axis of the plane of the fluid",
                repair,
            ));
        }
        let (length, least) = (high - low, 4.1 * smoothing * spacing);
        if length < least {
            let bound = format!(
                "at least {least:.6}, twice the reach of the kernel: nothing may see a particle twice, nor itself"
            );
            let repair = "put the second side farther behind the first, or use a narrower spacing";
            return Err(s.value(&path, format!("[{low}, {high}], {length:.6} apart"), &bound, repair));
        }
        let rows = length / spacing;
        if (rows - libm::round(rows)).abs() > WHOLE {
            let nearest = low + libm::round(rows) * spacing;
            let value = format!("[{low}, {high}], {rows:.3} spacings of {spacing} apart");
            let bound = "a whole number of spacings apart: rows of particles go on through the sides";
            return Err(s.value(&path, value, bound, &format!("make it [{low}, {nearest:.6}]")));
        }
        let wide = |extent: &Extent| extent.lengths[axis] > length + WHOLE * spacing;
        if let Some(extent) = fluid.geometry.extents().iter().find(|extent| wide(extent)) {
            let value = format!("[{low}, {high}], {length:.6} apart");
            let bound = format!("at least as far apart as the fluid is long, {:.6}", extent.lengths[axis]);
            let repair = "put the second side farther behind the first, or shorten the fluid";
            return Err(s.value(&path, value, &bound, repair));
        }
    }
    Ok(())
}

fn check_method(s: &Scope<'_>, fluid: &FluidScene) -> Verdict {
    let options = fluid.formulation.options();
    let refused = |what: &str, repair: &str| {
        let bound = format!("none with `{what}`");
        Err(SceneError::Choice(s.fault("periodic", "periodic sides", &bound, repair)))
    };
    if matches!(options.method, FluidMethod::Source) {
        return refused("method = \"source\"", "leave the method out");
    }
    if options.walls == Some(WallMethod::Dynamic) {
        return refused("walls = \"dynamic\"", "leave `walls` out");
    }
    Ok(())
}
