//! From a scene to a solid ready to move: nodes, sets, supports, loads.

use std::collections::BTreeMap;

use explicit_dynamics::Amplitude;
use heat_conduction::Capacity;
use peridynamics::{AppliedLoad, Parts, Solid, SolidError, StaticSolid};
use sph_core::{Block, BlockLattice};

use super::conditions::{Loads, driver, following, holds, loads, mirrors, probes, set_out, supports};
use super::conduction::{BondHeat, conduction, free_strains};
use super::describe::describe;
use super::parts::{carrier, contact, cracks, fracture, material, plastic};
use super::places::{Places, places};
use super::sets::NodeSets;
use super::warnings::warnings_of;
use crate::bodies::conducting::ConductingSolid;
use crate::bodies::imperfect::{deflection, of_modes};
use crate::bodies::refusal::{model_error, not_a, refuse_dof, refuse_free_motion};
use crate::bodies::rigid::free_of;
use crate::bodies::{BuiltBody, Identity, Memory, Model, PrescribedPoint, Probe, Ready};
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::error::SceneError;
use crate::scene::{Analysis, Checked, SolidScene};

impl Checked {
    /// Builds the solid alone, for programs that march or solve it themselves.
    ///
    /// # Errors
    /// As [`Checked::build`], and for a body of another kind.
    pub fn build_solid(&self, threads: usize) -> Result<Solid, SceneError> {
        let scene = &self.first_body()?;
        let with_bonds = scene.as_solid().filter(|solid| solid.galerkin().is_none());
        let wanted = with_bonds.ok_or_else(|| not_a(scene, "solid with bonds"))?;
        assemble_solid(scene, wanted, threads).map(|built| built.solid)
    }
}

/// A solid with what its curve measures.
struct SolidParts {
    solid: Solid,
    probes: Vec<Probe>,
    /// The one node whose motion a force that is sought brings about.
    driven: Option<PrescribedPoint>,
    memory: Memory,
    /// Its nodes by name of their set.
    sets: BTreeMap<String, Vec<u32>>,
    places: Places,
    /// How its bonds conduct heat, and what nodes store by degree; none where nobody asks for it.
    conduction: Option<(BondHeat, Capacity)>,
}

/// Builds a solid with what is asked of it.
pub(in crate::bodies) fn solid_model(
    scene: &BodyInScene<'_>,
    wanted: &SolidScene,
    threads: usize,
) -> Result<Model, SceneError> {
    if matches!(scene.analysis, Analysis::Heat(_)) {
        let mut parts = assemble_solid(scene, wanted, threads)?;
        let (heat, capacity) = parts.conduction.take().ok_or_else(|| not_a(scene, "solid with [[heat]]"))?;
        let ready = |solid| Ready::Heat(Box::new(ConductingSolid::new(solid, heat, capacity)));
        return Ok(looked_at(scene, wanted, parts).map(ready).model(scene.scene, threads));
    }
    let ready = |solid| match scene.analysis {
        Analysis::Explicit(_) => Ready::Dynamic(Box::new(solid)),
        _ => Ready::Static(Box::new(StaticSolid::new(solid))),
    };
    Ok(solid_made(scene, wanted, threads, false)?.map(ready).model(scene.scene, threads))
}

/// Builds a solid, in a fluid if it is `wet`, and looks at it.
pub(in crate::bodies) fn solid_made(
    scene: &BodyInScene<'_>,
    wanted: &SolidScene,
    threads: usize,
    wet: bool,
) -> Result<BuiltBody<Solid>, SceneError> {
    let mut parts = assemble_solid(scene, wanted, threads)?;
    if wet {
        parts.solid.wet().map_err(|error| solid_refusal(scene, wanted, &error))?;
    }
    Ok(looked_at(scene, wanted, parts))
}

/// A solid with what is known of it before it runs.
fn looked_at(scene: &BodyInScene<'_>, wanted: &SolidScene, parts: SolidParts) -> BuiltBody<Solid> {
    let SolidParts { solid, probes, driven, memory, sets, places, .. } = parts;
    let mut description = describe(scene, wanted, &solid);
    let warnings = warnings_of(scene, wanted, &solid, (&places, &sets));
    let identity = places.skin.as_ref().map_or_else(Identity::default, |skin| skin.identity.clone());
    description.modelled.extend(places.skin.map(|skin| skin.described));
    let judge = None;
    BuiltBody { body: solid, description, memory, identity, probes, driven, warnings, judge, sets }
}

fn assemble_solid(
    scene: &BodyInScene<'_>,
    wanted: &SolidScene,
    threads: usize,
) -> Result<SolidParts, SceneError> {
    let (places, memory) = places(scene, wanted)?;
    let Places { lattice, block: perfect, skin } = &places;
    let block = bent(scene, wanted, lattice, perfect, threads)?;
    let sets = NodeSets::find(scene, lattice, perfect, &perfect.positions, skin.as_ref())?;
    let probes = probes(scene, &sets)?;
    let driver = driver(scene, &sets)?;
    let supports = supports(scene, wanted.has_directors(), &sets, driver.as_ref())?;
    let mirrors = mirrors(scene, lattice, &sets)?;
    let material = material(wanted);
    let Loads { mut loads, passed } = loads(scene, material.density, &block, &sets, &mirrors)?;
    let driven = driver.map(|driver| driver.point(&supports)).transpose();
    let driven = driven.map_err(|error| solid_refusal(scene, wanted, &error))?;
    if let Some(PrescribedPoint { particle, direction, .. }) = driven {
        let (forces, amplitude) = (vec![(particle, direction)], Amplitude::Constant);
        loads.push(AppliedLoad { forces, amplitude });
    }
    refuse_free_motion(scene, || {
        let all = Vec::from_iter(0..block.len() as u32);
        free_of(&block.positions, &all, holds(wanted, &supports, &block, &mirrors))
    })?;
    let fracture = fracture(scene, wanted, &sets)?;
    let parts = Parts {
        material,
        formulation: carrier(wanted, lattice),
        plastic: plastic(wanted),
        fracture,
        cracks: cracks(wanted, lattice),
        contact: contact(wanted),
        supports,
        loads,
        threads: threads.max(1),
        block,
    };
    let mut solid = Solid::mirrored(parts, &mirrors).map_err(|error| solid_refusal(scene, wanted, &error))?;
    let mut passed = passed.into_iter();
    let kept = passed.try_for_each(|(load, forces)| solid.pass_through(load, forces));
    kept.map_err(|error| solid_refusal(scene, wanted, &error))?;
    let mut following = following(scene, &sets)?.into_iter();
    let followed = following.try_for_each(|pressure| solid.follow(pressure));
    followed.map_err(|error| solid_refusal(scene, wanted, &error))?;
    set_out(wanted, &mut solid);
    refuse_dof(scene, solid.dof())?;
    refuse_pieces(scene, wanted, &solid)?;
    let conduction = conduction(scene, wanted, &solid, &sets)?;
    if let Some(strains) =
        free_strains(scene, wanted, &solid, (&sets, conduction.as_ref().map(|own| &own.0)))?
    {
        solid.warm(strains).map_err(|error| solid_refusal(scene, wanted, &error))?;
        if matches!(scene.analysis, Analysis::Explicit(_)) {
            solid.expand(1.0);
        }
    }
    let sets = sets.into_members();
    Ok(SolidParts { solid, probes, driven, memory, sets, places, conduction })
}

/// The block with the imperfection put in.
fn bent(
    scene: &BodyInScene<'_>,
    wanted: &SolidScene,
    lattice: &BlockLattice,
    perfect: &Block,
    threads: usize,
) -> Result<Block, SceneError> {
    let mut block = perfect.clone();
    let Some(imperfection) = wanted.imperfection else { return Ok(block) };
    let Some(waves) = imperfection.half_waves else {
        let modes = of_modes(scene.scene);
        let view = BodyInScene::new(&modes, scene.name, scene.body)?;
        let perfect = SolidScene { imperfection: None, ..wanted.clone() };
        let mut system = StaticSolid::new(assemble_solid(&view, &perfect, threads)?.solid);
        let read = |system: &StaticSolid| {
            let solid = system.solid();
            [(0..solid.len()).map(|node| solid.position(node)).collect(), Vec::new()]
        };
        let found = deflection(scene, &imperfection, &mut system, read, |v| *v)?;
        block.positions.iter_mut().zip(&found.displacements).for_each(|(x, u)| *x += u);
        return Ok(block);
    };
    let waves = waves.map(|n| f64::from(n) * std::f64::consts::PI);
    for x in &mut block.positions {
        let along = |axis: usize| (x[axis] - lattice.origin[axis]) / lattice.lengths[axis];
        let shape = libm::sin(waves[0] * along(0)) * libm::sin(waves[1] * along(1));
        x.z += imperfection.amplitude * shape;
    }
    Ok(block)
}

/// A body in pieces has rigid motions of its own for each: a static answer needs one piece.
fn refuse_pieces(scene: &BodyInScene<'_>, wanted: &SolidScene, solid: &Solid) -> Result<(), SceneError> {
    let pieces = solid.fragments().len();
    if scene.analysis.kind().floats || pieces == 1 {
        return Ok(());
    }
    let (path, repair) = match (&wanted.geometry.filled, wanted.cracks.is_empty()) {
        (Some(_), true) => {
            let repair = "make each piece a body of its own and join them by springs, use a wider horizon, or [analysis.explicit.transient]";
            ("geometry.filled.file", repair)
        }
        _ => ("cracks", "shorten the cracks, or use [analysis.explicit.transient]"),
    };
    let path = scene.body_scope().path(path);
    let bound = format!("a body in one piece in {}", scene.analysis.kind().name);
    let value = format!("solid in {pieces} pieces, each with rigid motions of its own");
    Err(SceneError::FreeMotion(scene.source.fault(&path, &value, &bound, repair)))
}

/// Puts a refusal of the solid where the wanted causes it.
fn solid_refusal(scene: &BodyInScene<'_>, wanted: &SolidScene, error: &SolidError) -> SceneError {
    let moved = scene.supports.iter().find_map(|support| Some(support.at(support.motion()?.0)));
    let of_body = |path: &str| scene.body_scope().path(path);
    let formulation = format!("formulation.{}", wanted.formulation.word());
    let path = match error {
        SolidError::Material { .. } | SolidError::Pairwise(..) => {
            of_body(&format!("material.{}", wanted.material.word()))
        }
        SolidError::Horizon(_) | SolidError::Alone(_) => of_body(&format!("{formulation}.horizon")),
        SolidError::Coincident(..) | SolidError::Volume { .. } | SolidError::OneLayer => {
            of_body(&format!("geometry.{}", wanted.geometry.word()))
        }
        SolidError::Contradiction { .. } | SolidError::TwoTurns(_) => moved.unwrap_or("supports".into()),
        SolidError::EmptySet(_) | SolidError::NoSuchNode { .. } => "sets".into(),
        SolidError::Unbalanced(_) | SolidError::Flat { .. } => of_body(&format!("{formulation}.correction")),
        SolidError::Limit { .. } => of_body("fracture"),
        SolidError::Yielding(_) => of_body("material.plastic"),
        SolidError::Crack { number, .. } => of_body(&format!("cracks[{number}]")),
        SolidError::NotThin | SolidError::WetSheets | SolidError::NotShared(_) => of_body(&formulation),
        SolidError::SheetContact | SolidError::MirroredContact => of_body("contact"),
        SolidError::Conduction => "heat".into(),
        SolidError::Heat(_) => "loads".into(),
        SolidError::Mirror { .. } => "supports".into(),
    };
    model_error(scene.source, &path, &error.to_string())
}
