//! Material, formulation, fracture and contact of a solid, from the scene's words to those of `peridynamics`.

use peridynamics::{
    Contact, Crack, Criterion, Elastic, Formulation, Fracture, Idealisation, Law, Plastic, Sheets, Volumes,
};
use sph_core::{BlockLattice, CutOut, Vec3};

use super::sets::NodeSets;
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::error::SceneError;
use crate::scene::{self, BondMeasure, Hardening, SolidFormulation, SolidMaterial, SolidScene};

/// The constants; Poisson's ratio of bonds that feel their own extension alone is that of pairwise forces, which scenes round.
pub(super) fn material(solid: &SolidScene) -> Elastic {
    let (young, poisson) = solid.material.isotropic().unwrap_or_default();
    let density = solid.material.density();
    let poisson = law(&solid.formulation).poisson(solid.space(), poisson);
    Elastic { young, poisson, density }
}

/// How bonds yield; the checks leave them linear hardening alone.
pub(super) fn plastic(solid: &SolidScene) -> Option<Plastic> {
    match &solid.material {
        SolidMaterial::Plastic(scene::Plastic { hardening: Hardening::Linear(linear), .. }) => {
            Some(Plastic { yield_stress: linear.yield_stress.get(), hardening: linear.slope.get() })
        }
        _ => None,
    }
}

/// What a bond feels; a body without bonds is carried by none of them.
fn law(formulation: &SolidFormulation) -> Law {
    match formulation {
        SolidFormulation::BondBased(_) => Law::BondBased,
        SolidFormulation::StateBased(_) | SolidFormulation::TwoSheets(_) | SolidFormulation::Galerkin(_) => {
            Law::StateBased
        }
    }
}

/// How bonds carry the solid.
pub(super) fn carrier(solid: &SolidScene, lattice: &BlockLattice) -> Idealisation {
    let law = law(&solid.formulation);
    let influence = solid.formulation.influence();
    let correction = solid.correction();
    let horizon = solid.formulation.horizon();
    let formulation =
        Formulation { space: solid.space(), law, horizon, volumes: Volumes::Partial, influence, correction };
    match solid.has_directors() {
        true => Idealisation::Sheets(Sheets { thickness: lattice.lengths[2], formulation }),
        false => Idealisation::Bonds(formulation),
    }
}

/// When bonds break.
pub(super) fn fracture(
    scene: &BodyInScene<'_>,
    solid: &SolidScene,
    sets: &NodeSets<'_>,
) -> Result<Option<Fracture>, SceneError> {
    let Some(limits) = &solid.fracture else { return Ok(None) };
    let criterion = match (limits.energy, limits.stretch) {
        (Some(energy), _) => match limits.by.unwrap_or_default() {
            BondMeasure::Stretch => Criterion::EnergyByStretch(energy.get()),
            BondMeasure::Work => Criterion::EnergyByWork(energy.get()),
        },
        (None, Some(stretch)) => Criterion::Stretch {
            tension: stretch.tension.get(),
            compression: stretch.compression.as_deref().copied(),
        },
        // The checks leave one of the two.
        (None, None) => return Ok(None),
    };
    let mut unbreakable = Vec::new();
    for (i, set) in solid.unbreakable.iter().enumerate() {
        let path = scene.body_scope().path(&format!("unbreakable[{i}]"));
        unbreakable.extend_from_slice(sets.at(&path, set)?);
    }
    unbreakable.sort_unstable();
    unbreakable.dedup();
    Ok(Some(Fracture { criterion, unbreakable }))
}

/// The cracks, those of a plane block at its height.
pub(super) fn cracks(solid: &SolidScene, lattice: &BlockLattice) -> Vec<Crack> {
    let point = |v: &Vec<f64>| Vec3::new(v[0], v[1], lattice.origin.z);
    let crack = |crack: &scene::Crack| match (&crack.from, &crack.to, &crack.corners) {
        (Some(from), Some(to), _) => Some(Crack::Segment([point(from), point(to)])),
        (_, _, Some(corners)) => Some(Crack::Polygon(corners.iter().map(|&x| Vec3::from(x)).collect())),
        // The checks leave no other.
        _ => None,
    };
    solid.cracks.iter().filter_map(crack).collect()
}

/// Contact of fragments and walls.
pub(super) fn contact(solid: &SolidScene) -> Option<Contact> {
    let wall = |wall: &scene::Wall| [Vec3::from(wall.point), Vec3::from(wall.normal).normalize()];
    let contact = solid.contact.as_ref()?;
    Some(Contact { distance: contact.distance.get(), walls: contact.walls.iter().map(wall).collect() })
}

/// What is cut out of the block.
pub(super) fn cut_outs(solid: &SolidScene, lattice: &BlockLattice) -> Vec<CutOut> {
    let z = lattice.origin.z;
    let point = |v: &[f64]| Vec3::new(v[0], v[1], v.get(2).copied().unwrap_or(z));
    let cut_out = |cut_out: &scene::CutOut| match cut_out {
        scene::CutOut::Ball(ball) => CutOut::Ball { centre: point(&ball.centre), radius: ball.radius.get() },
        scene::CutOut::Cylinder(hole) => CutOut::Cylinder {
            point: Vec3::from(hole.point),
            axis: Vec3::from(hole.axis).normalize(),
            radius: hole.radius.get(),
        },
        scene::CutOut::Box(cuboid) => CutOut::Box { min: point(&cuboid.min), max: point(&cuboid.max) },
        scene::CutOut::Polygon(polygon) => CutOut::Prism(polygon.corners.clone()),
    };
    solid.geometry.cut_outs.iter().map(cut_out).collect()
}
