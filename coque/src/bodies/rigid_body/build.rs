//! From a scene to a rigid body ready to move: surface, mass, sets, supports, loads.

use nalgebra::Matrix3;
use rigid_body::{
    MassProperties, Outline, Parts, RestingBody, RigidBody, RigidError, RotationHold, Support, WetPoints,
};
use sph_core::Vec3;

use super::conditions::{holds, loads, probes, set_out, springs, supports};
use super::places::{outline, sets, spacing};
use super::wet::wet_points;
use crate::bodies::memory::check_memory;
use crate::bodies::refusal::{model_error, refuse_dof, refuse_free_motion};
use crate::bodies::rigid::free_of;
use crate::bodies::{BuiltBody, Description, Model, Ready};
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::error::SceneError;
use crate::scene::{Analysis, Explicit, FluidScene, RigidScene};

/// Steps between two records at least of a body that is alone, so that loads that vary in time are followed where nothing else bounds the step.
const STEPS_A_RECORD: f64 = 100.0;

/// Builds a rigid body with what is asked of it.
pub(in crate::bodies) fn rigid_model(
    scene: &BodyInScene<'_>,
    rigid: &RigidScene,
    threads: usize,
) -> Result<Model, SceneError> {
    let ready = |body| match scene.analysis {
        Analysis::Explicit(_) => Ready::Dynamic(Box::new(body)),
        _ => Ready::Static(Box::new(RestingBody::new(body))),
    };
    Ok(rigid_made(scene, rigid, None)?.map(ready).model(scene.scene, threads))
}

/// Builds a rigid body, wet if there is a fluid; in a plane one it stays in the plane.
pub(in crate::bodies) fn rigid_made(
    scene: &BodyInScene<'_>,
    rigid: &RigidScene,
    fluid: Option<&FluidScene>,
) -> Result<BuiltBody<RigidBody>, SceneError> {
    let (outline, identity) = outline(scene, &rigid.geometry)?;
    let memory = check_memory(scene, outline.vertices.len() as f64)?;
    let mass = mass_properties(rigid, &outline).map_err(|error| refused(scene, rigid, &error))?;
    let apart = spacing(&outline);
    let mut rest = outline.vertices.clone();
    rest.push(mass.centre);
    let sets = sets(scene, &rest, apart)?;
    let (mut supports, springs) = (supports(scene), springs(scene, &sets));
    if fluid.is_some_and(|fluid| fluid.dimensions() == 2) {
        let (displacement, rotation) = (vec![Vec3::z()], RotationHold::About(Vec3::z()));
        supports.push(Support::Held { displacement, rotation });
    }
    let wet = fluid.map(|fluid| wet_points(scene, rigid, (&outline, &mass), fluid)).transpose()?;
    let (wet, leaky) = wet.map_or((None, None), |(wet, leaky)| (Some(wet), leaky));
    refuse_free_motion(scene, || {
        let all = Vec::from_iter(0..rest.len() as u32);
        free_of(&rest, &all, holds(&supports, &springs, &mass.centre))
    })?;
    let probes = probes(scene, &sets, outline.vertices.len() as u32);
    let parts = Parts { outline, mass, supports, loads: loads(scene, &sets), springs };
    let mut body = RigidBody::new(parts).map_err(|error| refused(scene, rigid, &error))?;
    set_out(rigid, &mut body);
    if let Some(points) = &wet {
        body.wet(points);
    }
    if let Analysis::Explicit(Explicit { transient: Some(run), .. }) = scene.analysis {
        // Bodies beside it have steps of their own, and so has its contact with tools; what swings on links or joints has none.
        let alone = !scene.together && rigid.tools.is_empty();
        let hangs = !(scene.in_fluid || scene.scene.links.is_empty() && scene.scene.joints.is_empty());
        let steps = if alone || hangs { STEPS_A_RECORD } else { 1.0 };
        body.bound_step(run.record_every.get() / steps);
    }
    if !scene.together {
        refuse_dof(scene, body.dof())?;
    }
    let mut description = describe(&body, &mass, apart);
    description.modelled.extend(wet.map(|wet| wetted_line(&wet)));
    let (driven, warnings, judge) = (None, Vec::from_iter(leaky), None);
    Ok(BuiltBody { body, description, memory, identity, probes, driven, warnings, judge, sets })
}

/// Mass, centre and inertia that a scene gives.
fn mass_properties(rigid: &RigidScene, outline: &Outline) -> Result<MassProperties, RigidError> {
    let filled = outline.filled(1.0)?;
    // A density or a mass: the checks leave one of the two.
    let mass = rigid.mass.map(|mass| mass.get()).or_else(|| rigid.density.map(|d| d.get() * filled.mass));
    let mass = mass.unwrap_or(filled.mass);
    let even = MassProperties { mass, inertia: filled.inertia * (mass / filled.mass), ..filled };
    let Some(inertia) = &rigid.inertia else { return Ok(even) };
    let [xy, yz, zx] = rigid.products.unwrap_or_default();
    let [x, y, z] = [0, 1, 2].map(|axis| inertia.along(axis));
    Ok(MassProperties { inertia: Matrix3::new(x, xy, zx, xy, y, yz, zx, yz, z), ..even })
}

fn describe(body: &RigidBody, mass: &MassProperties, spacing: f64) -> Description {
    let ([x, y, z], [a, b, c]) = (<[f64; 3]>::from(mass.centre), <[f64; 3]>::from(body.moments()));
    Description {
        kind: "rigid",
        method: "six degrees of freedom".into(),
        particles: body.len(),
        points: 0,
        dof: body.dof(),
        spacing,
        bytes_per_particle: 48.0,
        modelled: vec![
            format!(
                "mass {:.6e} at ({x:.4}, {y:.4}, {z:.4}), principal moments {a:.6e}, {b:.6e}, {c:.6e}",
                mass.mass
            ),
            "turns of any size, by the midpoint rule in time, which keeps moment of momentum".into(),
        ],
        left_out: vec!["deformation".into()],
        ..Description::default()
    }
}

/// What a fluid wets.
fn wetted_line(wet: &WetPoints) -> String {
    let points = format!("wet by {} points behind its faces", wet.points.len());
    match wet.width {
        Some(width) => format!("{points}; moves in the plane of the fluid, {width} wide across it"),
        None => points,
    }
}

/// Puts a refusal of the body where the scene causes it.
fn refused(scene: &BodyInScene<'_>, rigid: &RigidScene, error: &RigidError) -> SceneError {
    let of_body = |path: &str| scene.body_scope().path(path);
    let moved = scene.supports.iter().find(|support| support.motion().is_some());
    let path = match error {
        RigidError::Open(_) | RigidError::Volume(_) => {
            of_body(&format!("geometry.{}", rigid.geometry.word()))
        }
        RigidError::Inertia { .. } => of_body(if rigid.inertia.is_some() { "inertia" } else { "mass" }),
        RigidError::Opposed(_) => moved.map_or("supports".into(), |support| support.path.clone()),
        RigidError::NoSuchParticle { .. } => "sets".into(),
    };
    model_error(scene.source, &path, &error.to_string())
}
