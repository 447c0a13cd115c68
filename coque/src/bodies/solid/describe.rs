//! What a solid models and what it leaves out, for summaries.

use std::collections::BTreeMap;

use peridynamics::Solid;

use crate::bodies::{Description, TangentCost};
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::{BondMeasure, SolidFormulation, SolidScene};

/// What the solid of a scene is.
pub(super) fn describe(scene: &BodyInScene<'_>, solid_scene: &SolidScene, solid: &Solid) -> Description {
    let (modelled, left_out) = lists(scene, solid_scene, solid);
    let block = solid.block();
    Description {
        kind: "solid",
        method: solid_scene.formulation.describe(solid_scene.correction()),
        particles: solid.len(),
        points: solid.bonds(),
        dof: solid.dof(),
        spacing: block.greatest_spacing(),
        bytes_per_particle: solid.bytes_per_particle(),
        rotary_inertia_over_true: None,
        bodies: BTreeMap::new(),
        modelled,
        left_out,
        resultants: None,
        tangent: TangentCost::Expensive,
    }
}

/// Lines of what is modelled, and of what is not.
fn lists(scene: &BodyInScene<'_>, solid_scene: &SolidScene, solid: &Solid) -> (Vec<String>, Vec<String>) {
    let word = match solid_scene.formulation {
        SolidFormulation::BondBased(_) => "pairwise forces",
        SolidFormulation::StateBased(_) => "pairwise forces and dilatation",
        SolidFormulation::TwoSheets(_) | SolidFormulation::Galerkin(_) => {
            "two plane-stress sheets on directors, shear and thickness held"
        }
    };
    let bonds = solid.bonds() / 2;
    let mut modelled = vec![
        format!(
            "{bonds} bonds, {word}, finite rotations, {}",
            solid_scene.formulation.describe(solid_scene.correction())
        ),
        match solid_scene.material.yields() {
            true => "elasticity that yields by von Mises: families of bonds by the energy of their deviators"
                .into(),
            false => "isotropic elasticity, linear in the extension of bonds".into(),
        },
    ];
    let mut left_out: Vec<String> = Vec::new();
    if !solid_scene.material.yields() {
        left_out.push("plasticity".into());
    }
    match &solid_scene.fracture {
        Some(fracture) => modelled.push(match (fracture.energy, fracture.by.unwrap_or_default()) {
            (Some(energy), BondMeasure::Stretch) => {
                format!("bonds break by stretch, {energy} a unit of crack")
            }
            (Some(energy), BondMeasure::Work) => format!("bonds break by work, {energy} a unit of crack"),
            (None, _) => "bonds break at given stretches".into(),
        }),
        None => left_out.push("fracture".into()),
    }
    match solid_scene.cracks.len() {
        0 => {}
        1 => modelled.push("a crack at the start".into()),
        cracks => modelled.push(format!("{cracks} cracks at the start")),
    }
    match &solid_scene.contact {
        Some(contact) if contact.walls.is_empty() => modelled.push("contact of fragments".into()),
        Some(contact) => {
            modelled.push(format!("contact of fragments, and with {} walls", contact.walls.len()))
        }
        None => left_out.push("contact".into()),
    }
    for support in &scene.supports {
        modelled.extend(support.kinds().iter().map(|(word, _)| format!("{word} on {}", support.on)));
    }
    for load in &scene.loads {
        modelled.extend(load.kinds().iter().map(|(word, _)| format!("{word} on {}", load.on)));
    }
    if scene.loads.iter().any(|load| load.heats()) && !scene.scene.heat.is_empty() {
        modelled.push("heat conducted along bonds, in balance".into());
    }
    modelled.extend(solid_scene.imperfection.map(|_| "deflection of the unstrained body".into()));
    modelled.extend(solid_scene.velocity.as_ref().map(|_| "velocity at the start".into()));
    if scene.loads.is_empty() {
        left_out.push("loads".into());
    }
    (modelled, left_out)
}
