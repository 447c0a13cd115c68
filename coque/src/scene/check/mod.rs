//! The checks of a scene that need no particles, first to last.

mod amplitude;
mod analysis;
mod base;
mod cases;
mod conditions;
mod conduction;
mod contact;
mod curve;
mod enclosed;
mod fluid;
mod gauges;
mod glue;
mod harmonic;
mod heat;
mod heat_alone;
mod imperfection;
mod links;
mod made;
mod preload;
mod rigid;
mod rigid_joints;
mod rubbing;
mod sets;
mod several;
mod shell;
mod solid;
mod spectrum;
mod stresses;
mod together;
mod tools;
mod wet_rigid;

use self::analysis::check_analysis;
use self::cases::check_cases;
use self::conditions::{check_load, check_support};
use self::conduction::{check_conduction, check_heat_alone};
use self::contact::check_contact;
use self::curve::check_curve;
use self::fluid::check_velocity_of_fluid;
use self::glue::check_glue;
use self::imperfection::check_imperfection;
use self::links::check_links;
use self::made::check_circles;
use self::preload::check_preload;
use self::rigid::check_rigid;
use self::rigid_joints::check_rigid_joints;
use self::sets::{check_set_name, check_sets};
use self::shell::{check_parts, check_wetting};
use self::solid::check_solid;
use self::together::{check_coupling, check_kinds, check_together};
use self::tools::{check_tools, check_tools_of_rigid, check_tools_of_solid};

use crate::scene::body_in_scene::BodyInScene;
use crate::scene::error::{SceneError, Verdict};
use crate::scene::problem::{BodyScene, Scene};
use crate::scene::scope::Scope;
use crate::scene::velocity::Velocity;

/// Refuses the first thing that is out of bounds.
pub(super) fn check(scene: &Scene) -> Verdict {
    check_units(scene)?;
    check_circles(scene)?;
    let (name, body) = named_body(scene)?;
    check_bodies(scene)?;
    check_coupling(scene)?;
    check_contact(scene)?;
    check_glue(scene)?;
    check_links(scene)?;
    check_rigid_joints(scene)?;
    match scene.is_together() {
        true => {
            check_heat_alone(scene)?;
            check_together(scene)?;
        }
        false => check_alone(&BodyInScene::new(scene, name, body)?)?,
    }
    check_cases(scene)
}

/// The first body by name, with all that the scene says of it.
///
/// # Errors
/// [`SceneError`] for a scene without bodies, and for sets that name none.
pub(super) fn first_body(scene: &Scene) -> Result<BodyInScene<'_>, SceneError> {
    let (name, body) = named_body(scene)?;
    BodyInScene::new(scene, name, body)
}

fn named_body(scene: &Scene) -> Result<(&String, &BodyScene), SceneError> {
    if let Some(first) = scene.bodies.first_key_value() {
        return Ok(first);
    }
    let repair =
        "add [geometry], [material] and [section] for a lone shell, or [bodies.NAME.shell] with them";
    Err(SceneError::Choice(scene.scope().fault("bodies", "no body", "one body", repair)))
}

/// Refuses the first thing that is out of bounds in the scene of one body.
fn check_alone(scene: &BodyInScene<'_>) -> Verdict {
    check_body(scene)?;
    check_sets(scene)?;
    scene.supports.iter().try_for_each(|support| check_support(scene, support))?;
    scene.loads.iter().try_for_each(|load| check_load(scene, load))?;
    if let Some(solid) = scene.as_solid() {
        check_solid(scene, solid)?;
    }
    if scene.as_rigid().is_some() {
        check_rigid(scene)?;
    }
    check_conduction(scene)?;
    check_preload(scene)?;
    check_analysis(scene)?;
    check_curve(scene)
}

fn check_units(scene: &Scene) -> Verdict {
    if scene.units.consistent() {
        return Ok(());
    }
    let bound = "consistent: all three with a unit, or all three \"-\"";
    let repair = "units = { length = \"m\", force = \"N\", time = \"s\" }, or \"-\" for all three";
    Err(scene.scope().value("units", "a mixture of units and \"-\"", bound, repair))
}

fn check_bodies(scene: &Scene) -> Verdict {
    let plain = |name: &str| name.chars().all(|c| c.is_alphanumeric() || "_-".contains(c));
    if let Some(name) = scene.bodies.keys().find(|name| name.is_empty() || !plain(name)) {
        let repair = "it names sets and files: use letters, digits, _ and -";
        let (path, value) = (format!("bodies.{name}"), format!("\"{name}\""));
        return Err(scene.scope().value(&path, value, "a plain word", repair));
    }
    check_kinds(scene)
}

/// Refuses what is out of bounds in the keys of the one body.
fn check_body(scene: &BodyInScene<'_>) -> Verdict {
    let s = &scene.body_scope();
    let body = scene.body;
    match body {
        BodyScene::Shell(shell) => {
            shell.check(s)?;
            check_parts(scene, shell, s)?;
            check_tools(scene, s)?;
            check_wetting(scene, shell, s)?;
        }
        BodyScene::Solid(solid) => {
            solid.check(s)?;
            check_tools(scene, s)?;
            check_tools_of_solid(scene, solid, s)?;
        }
        BodyScene::Fluid(fluid) => {
            fluid.check(s)?;
            check_velocity_of_fluid(fluid, s)?;
        }
        BodyScene::Walls(walls) => walls.check(scene, s)?,
        BodyScene::Rigid(rigid) => {
            rigid.check(s)?;
            check_tools(scene, s)?;
            check_tools_of_rigid(scene, rigid, s)?;
        }
    }
    check_imperfection(scene, s)?;
    body.velocity().map_or(Ok(()), |velocity| check_velocity(scene, velocity, s))
}

fn check_velocity(
    scene: &BodyInScene<'_>,
    Velocity { on, linear, spin }: &Velocity,
    s: &Scope<'_>,
) -> Verdict {
    let kind = scene.analysis.kind();
    if !kind.passes_time {
        let bound = format!("none in {}", kind.name);
        let repair = "remove it, or use [analysis.explicit.transient]";
        return Err(SceneError::Choice(s.fault("velocity", "a velocity at the start", &bound, repair)));
    }
    if linear.is_none() && spin.is_none() {
        let repair = "velocity = { linear = [1, 0, 0] }, or spin = { axis = [0, 0, 1], rate = 1.0 }";
        return Err(SceneError::Choice(s.fault("velocity", "neither", "`linear`, `spin` or both", repair)));
    }
    if let Some(on) = on {
        if scene.as_shell().is_none() {
            let bound = format!("none on a {}, all of which sets out", scene.body.word());
            let repair = "remove `on`: only parts of a shell set out alone";
            return Err(SceneError::Choice(s.fault("velocity.on", &format!("\"{on}\""), &bound, repair)));
        }
        check_set_name(scene, &s.path("velocity.on"), on)?;
    }
    s.sized_all("velocity.linear", &linear.unwrap_or_default())?;
    let Some(spin) = spin else { return Ok(()) };
    s.direction("velocity.spin.axis", spin.axis)?;
    s.sized_all("velocity.spin.point", &spin.point)?;
    s.sized("velocity.spin.rate", spin.rate)
}
