//! Checks of supports and loads that need no particles.

use explicit_dynamics::Amplitude;
use sph_core::Vec3;

use super::amplitude::check_amplitude;
use super::enclosed::check_enclosed;
use super::fluid::{check_load_of_fluid, check_unsupported};
use super::heat::check_temperature;
use super::rigid::{check_rigid_load, check_rigid_support};
use super::sets::{check_set_name, only_on};
use super::solid::{check_face, check_solid_load, check_solid_support, check_traction};
use crate::scene::body_in_scene::{BodyInScene, OnSet};
use crate::scene::error::{SceneError, Verdict};
use crate::scene::loads::{Axis, Load, LoadKind, Pressure};
use crate::scene::scope::Scope;
use crate::scene::sets::EDGES;
use crate::scene::supports::{Held, Spring, Support, SupportKind};

/// Directions this close to the span of others are the same but for rounding or a slip.
const PARALLEL: f64 = 1e-6;

pub(super) fn check_support(scene: &BodyInScene<'_>, support: &OnSet<'_, Support>) -> Verdict {
    let (s, at) = (&scene.scope(), support.path.as_str());
    check_unsupported(scene, at)?;
    check_set_name(scene, &support.at("on"), support.on)?;
    let kinds = support.kinds();
    let given: Vec<&str> = kinds.iter().map(|(word, _)| *word).collect();
    s.exactly_one(at, "condition", &given, &Support::WORDS)?;
    if let Some(solid) = scene.as_solid() {
        check_solid_support(scene, support, solid)?;
    }
    if scene.as_rigid().is_some() {
        check_rigid_support(scene, support)?;
    }
    if support.amplitude.is_some() && support.motion().is_none() {
        let repair = "remove it: only `moved`, `rotated` and `turned` have a course in time";
        let fault = s.fault(&format!("{at}.amplitude"), "a course in time", "none here", repair);
        return Err(SceneError::Choice(fault));
    }
    for (word, kind) in kinds {
        // Which of its vectors a spring has comes first.
        if let SupportKind::Spring(spring) = &kind {
            check_spring(scene, &support.at("spring"), support.on, spring)?;
        }
        for (key, v) in kind.vectors() {
            s.direction(&format!("{at}.{word}.{key}"), v)?;
        }
        match &kind {
            SupportKind::Held(held) => check_held(scene, &support.at("held"), held)?,
            SupportKind::Turned(turned) => s.sized_all(&support.at("turned.point"), &turned.point)?,
            _ => {}
        }
    }
    let Some((word, by)) = support.motion() else { return Ok(()) };
    s.sized(&format!("{at}.{word}.by"), by)?;
    check_course(scene, at, word, support.amplitude.as_ref())
}

fn check_spring(scene: &BodyInScene<'_>, at: &str, on: &str, spring: &Spring) -> Verdict {
    let s = &scene.scope();
    let Spring { direction, axis, to, .. } = spring;
    let known = ["direction", "axis"];
    let given = known.into_iter().zip([direction, axis]).filter_map(|(word, v)| v.map(|_| word));
    s.exactly_one(at, "direction or axis", &Vec::from_iter(given), &known)?;
    let Some(to) = to.as_ref().map(|to| scene.own_set(to)) else { return Ok(()) };
    let path = format!("{at}.to");
    if axis.is_some() {
        let repair = "leave `to` out, or give a `direction`";
        let bound = "none: a spring against turning stands on the ground";
        return Err(SceneError::Choice(s.fault(&path, "another set", bound, repair)));
    }
    if to == on {
        let repair = "name the set at the other end";
        return Err(SceneError::Set(s.fault(&path, &format!("\"{to}\""), "another set than `on`", repair)));
    }
    check_set_name(scene, &path, to)
}

fn check_held(scene: &BodyInScene<'_>, at: &str, held: &Held) -> Verdict {
    let s = &scene.scope();
    let Held { displacement, director } = held;
    if displacement.is_empty() && director.is_empty() {
        let repair =
            "held = { displacement = [[0, 0, 1]] } holds z; `director` keeps the director in a plane";
        let bound = "`displacement`, `director` or both";
        return Err(SceneError::Choice(s.fault(at, "no direction", bound, repair)));
    }
    // Directors of a shell keep their length; one that stays in two planes does not turn at all.
    let turns = if scene.as_solid().is_some() { 2 } else { 1 };
    let lists = [
        ("displacement", displacement, 3, "three hold the particle"),
        ("director", director, turns, "use `clamped` to hold both turns"),
    ];
    for (key, list, most, repair) in lists {
        let path = format!("{at}.{key}");
        if list.len() > most {
            let value = format!("{} directions", list.len());
            return Err(s.value(&path, value, &format!("at most {most}"), repair));
        }
    }
    let mut basis: Vec<Vec3> = Vec::new();
    for (i, &v) in displacement.iter().enumerate() {
        let v = Vec3::from(v).normalize();
        let rest = basis.iter().fold(v, |rest, known| rest - known * known.dot(&rest));
        if rest.norm() < PARALLEL {
            let path = format!("{at}.displacement[{i}]");
            let value = format!("{:?}", displacement[i]);
            let repair = "remove it: the directions before it hold this one already";
            return Err(s.value(&path, value, "out of the plane or line of those before it", repair));
        }
        basis.push(rest.normalize());
    }
    Ok(())
}

/// A prescribed motion follows the load level, in a transient run a course that starts at zero.
pub(super) fn check_course(
    scene: &BodyInScene<'_>,
    at: &str,
    word: &str,
    amplitude: Option<&Amplitude>,
) -> Verdict {
    let path = format!("{at}.amplitude");
    let starts_at_rest = match amplitude {
        None => !scene.analysis.kind().passes_time,
        Some(amplitude) => {
            check_amplitude(scene, &path, amplitude)?;
            match amplitude {
                Amplitude::Constant => false,
                Amplitude::Table(points) => points[0][1] == 0.0 && points[0][0] >= 0.0,
                _ => true,
            }
        }
    };
    if starts_at_rest {
        return Ok(());
    }
    let path = if amplitude.is_none() { format!("{at}.{word}") } else { path };
    let repair =
        format!("a transient run has no load level: add amplitude = {{ ramp = time }} beside `{word}`");
    let bound = "one with a course in time that starts at zero";
    Err(SceneError::Choice(scene.scope().fault(&path, "a prescribed motion", bound, &repair)))
}

fn check_pressure(s: &Scope<'_>, at: &str, pressure: &Pressure) -> Verdict {
    if pressure.value.is_none() && pressure.values.is_none() {
        let repair = "add value = the pressure, or beside it values = the name of an array in memory";
        return Err(SceneError::Missing(s.fault(
            &format!("{at}.pressure.value"),
            "nothing",
            "a number",
            repair,
        )));
    }
    s.sized(&format!("{at}.pressure.value"), pressure.value())
}

pub(super) fn check_load(scene: &BodyInScene<'_>, load: &OnSet<'_, Load>) -> Verdict {
    let (s, at) = (&scene.scope(), load.path.as_str());
    check_set_name(scene, &load.at("on"), load.on)?;
    let kinds = load.kinds();
    let given: Vec<&str> = kinds.iter().map(|(word, _)| *word).collect();
    s.exactly_one(at, "load", &given, &Load::WORDS)?;
    check_temperature(scene, load)?;
    check_load_of_fluid(scene, load)?;
    if let Some(solid) = scene.as_solid() {
        check_solid_load(scene, load, solid)?;
    }
    if scene.as_rigid().is_some() {
        check_rigid_load(scene, load)?;
    }
    for (word, kind) in kinds {
        match &kind {
            LoadKind::Force(force) => {
                s.sized_all(&format!("{at}.force.total"), &force.total)?;
                if force.by_area && scene.as_shell().is_none() {
                    let bound = "none but on the cells of a shell";
                    let repair = "remove it: a solid shares a force by volume, and takes a traction on faces";
                    let path = format!("{at}.force.by_area");
                    return Err(SceneError::Choice(s.fault(&path, "a share by area", bound, repair)));
                }
            }
            LoadKind::Couple(couple) => {
                s.sized(&format!("{at}.couple.moment"), couple.moment)?;
                if let Axis::Fixed(axis) = couple.axis {
                    s.direction(&format!("{at}.couple.axis"), axis)?;
                }
                if couple.axis == Axis::Edge {
                    only_on(scene, load, "a couple about the edge acts on an edge", &EDGES)?;
                }
            }
            LoadKind::Pressure(pressure) => check_pressure(s, at, pressure)?,
            LoadKind::Gas(_) | LoadKind::Volume(_) => check_enclosed(scene, load)?,
            LoadKind::Gravity(g) => s.sized_all(&format!("{at}.gravity.acceleration"), &g.acceleration)?,
            LoadKind::Traction(_) => check_traction(scene, load)?,
            LoadKind::Temperature(_) => {}
        }
        if matches!(kind, LoadKind::Pressure(_)) && scene.as_solid().is_some() {
            check_face(scene, load, word)?;
        } else if matches!(kind, LoadKind::Pressure(_) | LoadKind::Gravity(_)) && scene.as_shell().is_none() {
            let body = scene.body.word();
            only_on(scene, load, &format!("{word} acts on the whole {body}"), &["all"])?;
        }
    }
    match &load.amplitude {
        None => Ok(()),
        Some(amplitude) => check_amplitude(scene, &format!("{at}.amplitude"), amplitude),
    }
}
