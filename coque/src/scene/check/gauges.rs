//! Checks of gauges: points at which a fluid is looked at, sections through which it flows.

use sph_core::Vec3;

use crate::scene::body_in_scene::{BodyInScene, OnSet};
use crate::scene::curve::{Measured, Probe};
use crate::scene::error::{SceneError, Verdict};
use crate::scene::problem::BodyScene;
use crate::scene::scope::Scope;

/// A cut of a shell goes all through it, and what goes through it is what cells bear.
pub(super) fn check_cut(scene: &BodyInScene<'_>, probe: &OnSet<'_, Probe>) -> Verdict {
    let Some((shell, through)) = scene.as_shell().zip(probe.through).filter(|_| probe.of.is_of_section())
    else {
        return Ok(());
    };
    let s = &scene.scope();
    for (key, bounds) in [("min", through.min), ("max", through.max)] {
        if bounds.is_some() {
            let bound = "none of a cut, which goes all through the shell";
            let repair = "remove it; `on` names the particles that count";
            let fault = s.fault(&probe.at(&format!("through.{key}")), "a bound", bound, repair);
            return Err(SceneError::Choice(fault));
        }
    }
    let value = format!("\"{}\"", probe.of.word());
    let beside = [
        ("ties", !shell.ties.is_empty()),
        ("stiffeners", !shell.stiffeners.is_empty()),
        ("rigid", !shell.rigid.is_empty()),
    ];
    if let Some((key, _)) = beside.into_iter().find(|(_, any)| *any) {
        let bound = format!("none beside [[{key}]]: what these carry over a cut is in no cell");
        let repair = "measure `reaction` of what is held on one side, or `membrane-force` along the cut";
        return Err(SceneError::Choice(s.fault(&probe.at("of"), &value, &bound, repair)));
    }
    Ok(())
}

/// Refuses a point and a section where nothing is measured at one, and what needs one without it.
pub(super) fn check_gauge(body: &BodyScene, s: &Scope<'_>, probe: &OnSet<'_, Probe>) -> Verdict {
    check_point(body, s, probe)?;
    check_section(body, s, probe)?;
    check_staying(body, s, probe)
}

/// Of particles that come and go through openings no set stays.
fn check_staying(body: &BodyScene, s: &Scope<'_>, probe: &OnSet<'_, Probe>) -> Verdict {
    let BodyScene::Fluid(fluid) = body else { return Ok(()) };
    if fluid.openings.is_empty() || probe.at.is_some() || probe.through.is_some() {
        return Ok(());
    }
    let value = format!("\"{}\" of particles that come and go through openings", probe.of.word());
    let repair =
        "measure at a point (`pressure`, `level`, `wet-length` with `at`) or through a section (`flux`)";
    let fault = s.fault(&probe.at("of"), &value, "a gauge at a place that stays", repair);
    Err(SceneError::Choice(fault))
}

fn check_point(body: &BodyScene, s: &Scope<'_>, probe: &OnSet<'_, Probe>) -> Verdict {
    let word = probe.of.word();
    let reported = matches!(probe.of, Measured::Pressure | Measured::Level | Measured::WetLength);
    let (fluid, walls) = (matches!(body, BodyScene::Fluid(_)), matches!(body, BodyScene::Walls(_)));
    let Some(point) = &probe.at else {
        if !matches!(probe.of, Measured::Level | Measured::WetLength) || !fluid {
            return Ok(());
        }
        let repair = "add the point over which it is measured, as in at = [0.1, 0.0, 0.0]";
        let bound = "given for the level of a fluid and its wet length";
        return Err(SceneError::Missing(s.fault(&probe.at("at"), "nothing", bound, repair)));
    };
    if !reported || !(fluid || walls) {
        let bound = format!("none: {word} is measured at no point");
        let repair = "remove `at`, or measure a pressure, a level or a wet length of a fluid or of walls";
        return Err(SceneError::Choice(s.fault(&probe.at("at"), "a point", &bound, repair)));
    }
    if probe.on != "all" {
        let bound = "but a point goes with all of its body";
        let repair = "use on = \"NAME.all\": on a fluid the point stays, on walls it goes with them";
        return Err(SceneError::Set(s.fault(&probe.at("on"), &format!("\"{}\"", probe.on), bound, repair)));
    }
    s.sized_all(&probe.at("at"), point)
}

fn check_section(body: &BodyScene, s: &Scope<'_>, probe: &OnSet<'_, Probe>) -> Verdict {
    let word = probe.of.word();
    let Some(through) = &probe.through else {
        if probe.of.is_of_section() {
            let repair = "add through = { point = [0.5, 0.0, 0.0], normal = [1, 0, 0] }";
            let bound = "given: a section force is that through a cut";
            return Err(SceneError::Missing(s.fault(&probe.at("through"), "nothing", bound, repair)));
        }
        if probe.of != Measured::Flux {
            return Ok(());
        }
        let repair = "add through = { point = [0.1, 0.0, 0.0], normal = [1, 0, 0] }";
        let bound = "given: a flux is that through a line or a face";
        return Err(SceneError::Missing(s.fault(&probe.at("through"), "nothing", bound, repair)));
    };
    if probe.of != Measured::Flux && !probe.of.is_of_section() {
        let bound = format!("none: {word} goes through nothing");
        let repair = "remove `through`, or measure a flux, of a shell a section force";
        return Err(SceneError::Choice(s.fault(&probe.at("through"), "a section", &bound, repair)));
    }
    s.sized_all(&probe.at("through.point"), &through.point)?;
    s.direction(&probe.at("through.normal"), through.normal)?;
    let plane = matches!(body, BodyScene::Fluid(fluid) if fluid.dimensions() == 2);
    if plane && through.normal[2] != 0.0 {
        let repair = "set its third component to zero: a plane fluid flows in its plane";
        let value = format!("{:?}", through.normal);
        return Err(s.value(&probe.at("through.normal"), value, "in the plane of x and y", repair));
    }
    if let BodyScene::Fluid(fluid) = body
        && probe.of == Measured::Flux
        && let Some(periodic) = &fluid.periodic
    {
        let normal = Vec3::from(through.normal).normalize();
        let slanted = |axis: &usize| {
            let part = normal[*axis].abs();
            periodic.sides()[*axis].is_some() && part > 0.0 && part < 1.0 - 1e-12
        };
        if let Some(axis) = (0..3).find(slanted) {
            let name = ["x", "y", "z"][axis];
            let bound = format!(
                "along {name}, along which the fluid is periodic, or across it: a slanted section ends at a side"
            );
            let repair = format!("take the axis {name} itself, or one across it");
            return Err(s.value(
                &probe.at("through.normal"),
                format!("{:?}", through.normal),
                &bound,
                &repair,
            ));
        }
    }
    let (min, max) = (through.min, through.max);
    for (key, bounds) in [("min", min), ("max", max)] {
        bounds.map_or(Ok(()), |bounds| s.sized_all(&probe.at(&format!("through.{key}")), &bounds))?;
    }
    let (Some(min), Some(max)) = (min, max) else { return Ok(()) };
    // Across the plane of a plane fluid bounds say nothing.
    let axes = if plane { 2 } else { 3 };
    match (0..axes).find(|&axis| min[axis] >= max[axis]) {
        None => Ok(()),
        Some(axis) => {
            let bound = format!("greater than the least, {}", min[axis]);
            let path = probe.at(&format!("through.max[{axis}]"));
            Err(s.value(&path, max[axis], &bound, "swap the coordinates, or leave one of them out"))
        }
    }
}
