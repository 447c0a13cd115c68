//! What a Galerkin solid models and what it leaves out, for summaries.

use std::collections::BTreeMap;

use super::solid::GalerkinSolid;
use crate::bodies::{Description, TangentCost};
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::{Analysis, Galerkin, GalerkinLaw, SolidMaterial, SolidScene};

/// Bytes of a number.
const NUMBER: f64 = 8.0;
/// Numbers that a quadrature point keeps: history, trial, place.
const POINT: f64 = 90.0;

/// What the Galerkin solid of a scene is; `spacing` is the greatest between its nodes \[L\].
pub(super) fn describe(
    scene: &BodyInScene<'_>,
    solid: &SolidScene,
    options: &Galerkin,
    (body, widened): (&GalerkinSolid, f64),
    spacing: f64,
) -> Description {
    let galerkin = body.galerkin();
    let (mut modelled, left_out) = if matches!(scene.analysis, Analysis::Heat(_)) {
        of_heat(scene)
    } else {
        lists(scene, solid, options, galerkin.dependent_conditions())
    };
    if widened > 1.0 {
        modelled.push(format!("a support {widened:.2} times as wide as said: in less, nodes do not determine the basis everywhere"));
    }
    Description {
        kind: "solid",
        method: options.describe(),
        particles: galerkin.nodes(),
        points: galerkin.points(),
        dof: body.dof(),
        spacing,
        bytes_per_particle: NUMBER * POINT * galerkin.points() as f64 / galerkin.nodes() as f64,
        rotary_inertia_over_true: None,
        bodies: BTreeMap::new(),
        modelled,
        left_out,
        resultants: None,
        tangent: TangentCost::Expensive,
    }
}

/// What an analysis of heat models of it, and what not.
fn of_heat(scene: &BodyInScene<'_>) -> (Vec<String>, Vec<String>) {
    let how = if scene.analysis.kind().passes_time { "in time" } else { "in balance" };
    let radiates = scene.scene.heat.iter().any(|own| own.radiation.is_some());
    let left_out = radiates.then(|| "radiation from face to face".to_string());
    (
        vec![format!("heat conducted by the shape functions of displacements, {how}")],
        left_out.into_iter().collect(),
    )
}

/// Lines of what is modelled, and of what is not.
fn lists(
    scene: &BodyInScene<'_>,
    solid: &SolidScene,
    options: &Galerkin,
    dependent: usize,
) -> (Vec<String>, Vec<String>) {
    let mut modelled = vec![
        format!("finite rotations, {}", options.describe()),
        match &solid.material {
            SolidMaterial::Elastic(_) => "isotropic elasticity".into(),
            SolidMaterial::Orthotropic(_) => "orthotropic elasticity, its axes turning with the point".into(),
            SolidMaterial::Plastic(given) => format!(
                "isotropic elasticity that yields by von Mises' criterion, {} hardening, volumes by the mean of a cell",
                given.hardening.word()
            ),
        },
    ];
    let mut left_out: Vec<String> = vec!["fracture".into(), "contact".into()];
    if !solid.material.yields() {
        left_out.insert(0, "plasticity".into());
    }
    if options.law != GalerkinLaw::StVenant {
        left_out.push("an elastic energy: the law of increments is meant for strains below 0.2".into());
    }
    if scene.loads.iter().any(|load| load.heats()) && !scene.scene.heat.is_empty() {
        modelled.push("heat conducted by the shape functions of displacements, in balance".into());
    }
    for support in &scene.supports {
        modelled.extend(support.kinds().iter().map(|(word, _)| format!("{word} on {}", support.on)));
    }
    if dependent > 0 {
        modelled.push(format!("{dependent} conditions of supports follow from others and were left out"));
    }
    for load in &scene.loads {
        modelled.extend(load.kinds().iter().map(|(word, _)| format!("{word} on {}", load.on)));
    }
    if scene.loads.iter().any(|load| load.pressure.is_some()) {
        left_out.push(
            "the skew part of the stiffness of a pressure that follows: large ones converge slowly".into(),
        );
    }
    if scene.loads.is_empty() {
        left_out.push("loads".into());
    }
    (modelled, left_out)
}
