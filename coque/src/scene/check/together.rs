//! Checks of bodies that are built together: which go together, what names which, and each alone.

use std::collections::BTreeSet;

use super::check_alone;
use super::curve::{check_column_name, check_measured_alike, check_plot};
use super::fluid::{
    check_current, check_openings, check_periodic, check_sound_speed, check_still, check_waves,
};
use super::made::check_owners_of_made;
use super::several::{check_joints, check_several};
use super::wet_rigid::check_wet_rigid;
use crate::scene::analysis::Analysis;
use crate::scene::body_in_scene::{BodyInScene, OnSet, gravity_on};
use crate::scene::column_names::mean_of;
use crate::scene::coupling::Coupling;
use crate::scene::curve::Measured;
use crate::scene::error::{SceneError, Verdict};
use crate::scene::owner::Owner;
use crate::scene::problem::{BodyScene, Scene};
use sph_core::Vec3;

/// Part of its own by which the spacing of a solid may differ from that of a fluid.
const ALIKE: f64 = 0.05;
/// Bounds what walls may allocate.
const MOST_PARTICLES: f64 = 1e7;

/// Refuses numbers and kinds of bodies that nothing builds together.
pub(super) fn check_kinds(scene: &Scene) -> Verdict {
    let s = &scene.scope();
    let mut fluids = scene.bodies.iter().filter(|(_, body)| matches!(body, BodyScene::Fluid(_)));
    let fluid = fluids.next();
    if let (Some((first, _)), Some((second, _))) = (fluid, fluids.next()) {
        let (path, value) = (format!("bodies.{second}"), format!("a fluid beside `{first}`"));
        let repair = "give the blocks of one fluid in `geometry.blocks`";
        return Err(SceneError::Choice(s.fault(&path, &value, "the only fluid", repair)));
    }
    if fluid.is_some() {
        return Ok(());
    }
    let walls = scene.bodies.iter().find(|(_, body)| matches!(body, BodyScene::Walls(_)));
    let Some((name, _)) = walls else { return Ok(()) };
    let value = if scene.structures().next().is_none() { "walls alone" } else { "walls" };
    let repair = "add the fluid before them, as in [bodies.water.fluid]";
    Err(SceneError::Choice(s.fault(&format!("bodies.{name}"), value, "a fluid that they bound", repair)))
}

/// Refuses what does not go with other bodies, or with a fluid, then what is wrong with each of them alone.
pub(super) fn check_together(scene: &Scene) -> Verdict {
    let in_fluid = scene.fluid().is_some();
    if in_fluid {
        check_analysis_of_fluid(scene)?;
    }
    check_owners(scene)?;
    check_joints(scene)?;
    if !in_fluid {
        check_several(scene)?;
    }
    for (name, body) in &scene.bodies {
        check_alone(&BodyInScene::new(scene, name, body)?)?;
    }
    check_dimensions(scene)?;
    check_sizes(scene)?;
    check_spacings(scene)?;
    check_wet_rigid(scene)?;
    if in_fluid {
        check_sound_speed(scene)?;
        check_waves(scene)?;
        check_periodic(scene)?;
        check_current(scene)?;
        check_openings(scene)?;
        check_contact_columns(scene)?;
    }
    check_columns_together(scene)
}

fn check_analysis_of_fluid(scene: &Scene) -> Verdict {
    let kind = scene.analysis.kind();
    if kind.passes_time {
        return Ok(());
    }
    if matches!(scene.analysis, Analysis::Modal(_)) {
        return check_still(scene);
    }
    let repair = "use [analysis.explicit.transient] or [analysis.modal]";
    let bound =
        "a transient run, or modes of shells in still water: a scene with a fluid has no other analysis";
    Err(SceneError::Choice(scene.scope().fault(&format!("analysis.{}", kind.word), kind.name, bound, repair)))
}

/// Sets say whose they are; what is said of every body at once is gravity.
fn check_owners(scene: &Scene) -> Verdict {
    let s = &scene.scope();
    if scene.bodies.len() == 1 {
        return Ok(());
    }
    check_owners_of_made(scene)?;
    for (name, region) in &scene.sets {
        if scene.owner_of(region).is_none() {
            let names = Vec::from_iter(scene.bodies.keys().map(String::as_str)).join(", ");
            let (path, repair) = (format!("sets.{name}.of"), format!("add of = \"…\", one of {names}"));
            let bound = "given where there are several bodies";
            return Err(SceneError::Missing(s.fault(&path, "nothing", bound, &repair)));
        }
    }
    let every = |path: String, what: &str, bound: &str| {
        let repair = "name the body, as in on = \"gate.all\"";
        Err(SceneError::Set(s.fault(&path, what, bound, repair)))
    };
    for (i, support) in scene.supports.iter().enumerate() {
        let path = format!("supports[{i}].on");
        if Owner::of(scene, &path, &support.on)? == Owner::Every {
            return every(path, "\"all\"", "but a support holds a set of one body");
        }
    }
    for (i, load) in scene.loads.iter().enumerate() {
        let path = format!("loads[{i}].on");
        if Owner::of(scene, &path, &load.on)? == Owner::Every && load.gravity.is_none() {
            return every(path, "\"all\"", "but only gravity acts on every body");
        }
    }
    for (i, probe) in scene.curve.iter().enumerate() {
        let path = format!("curve[{i}].on");
        if Owner::of(scene, &path, &probe.on)? == Owner::Every {
            return every(path, "\"all\"", "but a column measures a set of one body");
        }
    }
    Ok(())
}

/// A coupling is that of a fluid with structures in it.
pub(super) fn check_coupling(scene: &Scene) -> Verdict {
    let Some(Coupling { .. }) = scene.coupling else { return Ok(()) };
    if scene.fluid().is_some() && scene.structures().next().is_some() {
        return Ok(());
    }
    let (bound, repair) = ("none but of a fluid and structures in it", "remove it");
    Err(SceneError::Choice(scene.scope().fault("coupling", "a coupling", bound, repair)))
}

/// Walls and solids have as many dimensions as the fluid.
fn check_dimensions(scene: &Scene) -> Verdict {
    let Some((fluid, dimensions)) = scene.fluid().map(|(name, fluid)| (name, fluid.dimensions())) else {
        return Ok(());
    };
    for (name, body) in &scene.bodies {
        let (own, path) = match body {
            BodyScene::Walls(walls) => {
                (walls.geometry.dimensions(), format!("geometry.{}", walls.geometry.word()))
            }
            BodyScene::Solid(solid) => (solid.dimensions(), "geometry.block.lengths".into()),
            BodyScene::Fluid(_) | BodyScene::Shell(_) | BodyScene::Rigid(_) => continue,
        };
        if own != dimensions {
            let bound = format!("{dimensions}, as `{fluid}` has");
            let value = format!("a body of {own} dimensions");
            let repair = "give all bodies two lengths, for a plane problem, or all three";
            return Err(scene.source.body(name, body.word()).value(&path, value, &bound, repair));
        }
    }
    Ok(())
}

/// Walls of a size that their rows of particles can fill.
fn check_sizes(scene: &Scene) -> Verdict {
    let Some((name, fluid)) = scene.fluid() else { return Ok(()) };
    let spacing = fluid.geometry.spacing();
    let rows = 2.0 * fluid.formulation.options().smoothing();
    for (body, wanted) in &scene.bodies {
        let BodyScene::Walls(walls) = wanted else { continue };
        let particles = walls.particles_asked(spacing, libm::round(rows));
        // Beyond the numbers that arithmetic holds there is no order.
        if particles.is_nan() || particles > MOST_PARTICLES {
            let value = format!("walls of {particles:.3e} particles, {spacing} apart as those of `{name}`");
            let bound = format!("so small that {MOST_PARTICLES:e} fill them");
            let path = format!("geometry.{}", walls.geometry.word());
            let repair = "make the walls smaller, or use a wider spacing";
            return Err(scene.source.body(body, "walls").value(&path, value, &bound, repair));
        }
    }
    Ok(())
}

/// Nodes of a solid are the points that a fluid feels, each with the weight of one of its own particles: those `a` times as
/// far apart make a wall that is 1/aᵈ as dense, and pull or push the fluid beside them by as much.
fn check_spacings(scene: &Scene) -> Verdict {
    let Some((name, fluid)) = scene.fluid() else { return Ok(()) };
    let spacing = fluid.geometry.spacing();
    for (body, wanted) in &scene.bodies {
        let BodyScene::Solid(solid) = wanted else { continue };
        if solid.geometry.filled.is_some() {
            let bound =
                "a block beside a fluid, to which each node is a wall particle of the size of its own";
            let repair = "use a block, or a shell with the surface of the body";
            let s = scene.source.body(body, "solid");
            return Err(SceneError::Choice(s.fault(
                "geometry.filled",
                "a surface that nodes fill",
                bound,
                repair,
            )));
        }
        let lattice = solid.lattice();
        // Lengths and spacings were checked before.
        let Ok(cells) = lattice.cells() else { continue };
        for axis in 0..solid.dimensions() {
            let length = lattice.lengths[axis];
            let own = length / cells[axis] as f64;
            let apart = (own / spacing - 1.0).abs();
            if apart > ALIKE {
                let percent = 100.0 * ALIKE;
                let wall = percent * solid.dimensions() as f64;
                let bound = format!(
                    "within {percent} % of {spacing}, that of `{name}`, to which each node is a wall particle of its own \
                     size: {percent} % in distance are {wall} % in the density of the wall"
                );
                let nearest = length / libm::round(length / spacing).max(1.0);
                let repair = format!(
                    "use {nearest:.6} for both, a whole number of times in the edge of {length}; a thin body may be a \
                     shell, which takes any"
                );
                let value = format!("{own:.6} along {}", ["x", "y", "z"][axis]);
                let path = "geometry.block.spacing";
                return Err(scene.source.body(body, "solid").value(path, value, &bound, &repair));
            }
        }
    }
    Ok(())
}

/// What a fluid does to a structure is measured on the whole of it.
fn check_contact_columns(scene: &Scene) -> Verdict {
    let s = &scene.scope();
    let gravity = scene.fluid().map_or_else(Vec3::zeros, |(name, _)| gravity_on(scene, name));
    for (i, probe) in scene.curve.iter().enumerate().filter(|(_, probe)| probe.of.is_of_contact()) {
        let path = format!("curve[{i}]");
        let at = |key: &str| format!("{path}.{key}");
        if matches!(probe.of, Measured::Level | Measured::WetLength) && gravity == Vec3::zeros() {
            let repair = "add loads = [{ on = \"all\", gravity = { acceleration = […] } }]";
            let bound = "something without gravity, which has neither up nor down";
            return Err(SceneError::Choice(s.fault(&at("of"), probe.of.word(), bound, repair)));
        }
        let Owner::Of(name, set) = Owner::of(scene, &at("on"), &probe.on)? else { continue };
        let Some((_, body)) = scene.structures().find(|(known, _)| *known == name) else { continue };
        if !matches!(probe.of, Measured::Force | Measured::Moment) {
            let value = format!("\"{}\"", probe.of.word());
            let bound = "`force`, `moment`, or what the structure has of itself";
            let repair = "measure it on the fluid, with `at` a point beside the structure";
            return Err(SceneError::Choice(s.fault(&at("of"), &value, bound, repair)));
        }
        if set != "all" {
            let bound = "but the forces of a fluid are measured on whole structures";
            let repair = format!("use on = \"{name}.all\"");
            let value = format!("\"{}\"", probe.on);
            return Err(SceneError::Set(s.fault(&at("on"), &value, bound, &repair)));
        }
        check_measured_alike(body, s, &OnSet::new(path, set, probe))?;
    }
    Ok(())
}

/// Names of columns differ over all bodies; a plot takes those of any.
fn check_columns_together(scene: &Scene) -> Verdict {
    let s = &scene.scope();
    let forces = scene.curve.iter().filter(|probe| probe.of.has_mean());
    let means: Vec<String> = forces.map(|probe| mean_of(&probe.name)).collect();
    let always = scene.first_columns();
    let mut names: BTreeSet<&str> = always.chain(means.iter().map(String::as_str)).collect();
    for (i, probe) in scene.curve.iter().enumerate() {
        check_column_name(s, &format!("curve[{i}].name"), &probe.name, &mut names)?;
    }
    let mut bodies = scene.bodies.values();
    let extruded = scene.output.fields.is_some_and(|fields| fields.extruded);
    if extruded && !bodies.any(|body| matches!(body, BodyScene::Shell(_))) {
        let bound = "none where there is no shell: the other bodies are written as they are";
        let fault = scene.scope().fault("output.fields.extruded", "a thickness", bound, "remove it");
        return Err(SceneError::Choice(fault));
    }
    check_plot(s, &scene.output, &names)
}
