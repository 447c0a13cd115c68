//! From a scene to a Galerkin solid ready to be solved: nodes, cells, sets, supports, loads.

use std::collections::BTreeMap;

use heat_conduction::Capacity;
use sph_core::Support;
use sr_galerkin::{Conduction, CutCells, Galerkin, GalerkinError, Load, Parts, Supports};

use super::conditions::{conditions, driven, holds, loads, mirrors};
use super::conduction::Heated;
use super::describe::describe;
use super::parts::{axes, basis, data_until, material, support, volumes, weight};
use super::places::Places;
use super::solid::GalerkinSolid;
use super::warnings::{cut_cells, warnings_of};
use super::widened::wide_enough;
use crate::bodies::body::PrescribedPoint;
use crate::bodies::conducting::ConductingSolid;
use crate::bodies::hot::hot;
use crate::bodies::memory::Memory;
use crate::bodies::memory::check_memory;
use crate::bodies::probe::Probe;
use crate::bodies::refusal::{body_error, model_error, not_a, refuse_dof, refuse_free_motion};
use crate::bodies::rigid::free_of;
use crate::bodies::solid::conditions::probes;
use crate::bodies::solid::sets::NodeSets;
use crate::bodies::solid::skin::Skin;
use crate::bodies::{BuiltBody, Identity, Model, Ready};
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::error::SceneError;
use crate::scene::{self, Analysis, Checked, Measured, SolidMaterial, SolidScene};
use crate::warning::{Warning, WarningKind};

impl Checked {
    /// Builds the Galerkin solid alone, for programs that lead it themselves.
    ///
    /// # Errors
    /// As [`Checked::build`], and for a body of another kind.
    pub fn build_galerkin(&self, threads: usize) -> Result<Galerkin, SceneError> {
        let scene = &self.first_body()?;
        let solid = scene.as_solid().ok_or_else(|| not_a(scene, "solid"))?;
        let options = solid.formulation.galerkin();
        let options = options.ok_or_else(|| not_a(scene, "solid with formulation.galerkin"))?;
        galerkin(scene, solid, options, threads).map(|built| built.galerkin)
    }
}

/// A Galerkin solid with what an analysis asks of it.
struct GalerkinParts {
    galerkin: Galerkin,
    places: Places,
    probes: Vec<Probe>,
    driven: Option<PrescribedPoint>,
    supports: Option<Supports>,
    memory: Memory,
    /// By what the support was widened so that nodes determine the basis everywhere.
    widened: f64,
    /// How it conducts heat, and what it stores by degree; none where nobody asks for it.
    conduction: Option<(Conduction, Capacity)>,
    /// Its nodes by name of their set.
    sets: BTreeMap<String, Vec<u32>>,
}

/// Builds a Galerkin solid with what is asked of it.
pub(in crate::bodies) fn galerkin_model(
    scene: &BodyInScene<'_>,
    solid: &SolidScene,
    options: &scene::Galerkin,
    threads: usize,
) -> Result<Model, SceneError> {
    if matches!(scene.analysis, Analysis::Heat(_)) {
        let mut parts = galerkin(scene, solid, options, threads)?;
        let conduction = parts.conduction.take().ok_or_else(|| not_a(scene, "solid with [[heat]]"))?;
        let ready = |body| Ready::Heat(Box::new(ConductingSolid::new(body, conduction.0, conduction.1)));
        return Ok(looked_at(scene, (solid, options), parts)?.map(ready).model(scene.scene, threads));
    }
    let made = galerkin_made(scene, solid, options, threads)?;
    Ok(made.map(|body| Ready::Static(Box::new(body))).model(scene.scene, threads))
}

/// Builds a Galerkin solid and looks at it.
pub(in crate::bodies) fn galerkin_made(
    scene: &BodyInScene<'_>,
    solid: &SolidScene,
    options: &scene::Galerkin,
    threads: usize,
) -> Result<BuiltBody<GalerkinSolid>, SceneError> {
    looked_at(scene, (solid, options), galerkin(scene, solid, options, threads)?)
}

/// A Galerkin solid with what is known of it before it runs.
fn looked_at(
    scene: &BodyInScene<'_>,
    (solid, options): (&SolidScene, &scene::Galerkin),
    parts: GalerkinParts,
) -> Result<BuiltBody<GalerkinSolid>, SceneError> {
    let GalerkinParts { galerkin, places, probes, driven, supports, memory, widened, sets, .. } = parts;
    let doubtful = [cut_cells(scene, &galerkin), hot(galerkin.greatest_free_strain())];
    let body = GalerkinSolid::new(galerkin, &places, supports, data_until(solid));
    refuse_dof(scene, body.dof())?;
    let mut description = describe(scene, solid, options, (&body, widened), places.block.greatest_spacing());
    let mut warnings = warnings_of(scene, options, places.lattice.lengths, &places.block);
    warnings.extend(doubtful.into_iter().flatten());
    let fins = places.skin().and_then(Skin::thin_fins);
    warnings.extend(fins.map(|message| Warning::new(WarningKind::ThinFins, message)));
    description.modelled.extend(places.skin().map(|skin| skin.described.clone()));
    let identity = places.skin().map_or_else(Identity::default, |skin| skin.identity.clone());
    let judge = None;
    Ok(BuiltBody { body, description, memory, identity, probes, driven, warnings, judge, sets })
}

fn galerkin(
    scene: &BodyInScene<'_>,
    solid: &SolidScene,
    options: &scene::Galerkin,
    threads: usize,
) -> Result<GalerkinParts, SceneError> {
    let of_lattice =
        solid.lattice().cells().map_or(0.0, |cells| cells.iter().map(|&n| (n + 1) as f64).product());
    check_memory(scene, of_lattice)?;
    refuse_few_layers(scene, solid, options)?;
    let places = Places::new(scene, solid, options.gauss.get())?;
    let memory = check_memory(scene, places.block.len() as f64)?;
    let sets = NodeSets::find(scene, &places.lattice, &places.block, &places.straight, places.skin())?;
    let probes = probes(scene, &sets)?;
    let driven = driven(scene, &sets)?;
    let conditions = conditions(scene, &sets, driven.map(|(support, _)| support))?;
    refuse_free_motion(scene, || {
        let all = Vec::from_iter(0..places.block.len() as u32);
        free_of(&places.block.positions, &all, holds(&conditions))
    })?;
    let mut cells = places.cells.clone();
    let mut loads = loads(scene, solid.material.density(), &places, &mut cells, &sets)?;
    let driven = driven.map(|(_, point)| point);
    loads.extend(driven.map(|point| Load::Point {
        place: places.block.positions[point.particle as usize],
        force: point.direction,
    }));
    // Nobody pays for reactions that nobody reads.
    let read =
        scene.curve.iter().any(|probe| probe.of == Measured::Reaction) || scene.output.fields.is_some();
    let mirrors = mirrors(scene, &places, &sets)?;
    let essential = options.essential;
    let material =
        material(solid, options).map_err(|error| body_error(scene, material_path(solid), &error))?;
    let parts = |support: Support| Parts {
        nodes: places.block.positions.clone(),
        cells: cells.clone(),
        rule: options.gauss.get(),
        cut: places.filled.as_ref().map(|(filled, _)| CutCells {
            points: filled.points.clone(),
            surface: filled.face_points(&filled.facets),
            shares: filled.block.volumes.clone(),
        }),
        basis: basis(options),
        support,
        weight: weight(options),
        material: material.clone(),
        axes: axes(solid),
        density: solid.material.density(),
        mirrors: mirrors.clone(),
        conditions: conditions.clone(),
        essential,
        loads: loads.clone(),
        tangent: options.tangent,
        volumes: volumes(solid, options),
        threads: threads.max(1),
    };
    let support = support(solid, options, &places);
    let (mut galerkin, widened) = wide_enough(&support, |support| Galerkin::new(parts(support)))
        .map_err(|error| galerkin_refusal(scene, solid, &error))?;
    if widened > 1.0 && options.support.is_some() {
        return Err(too_narrow(scene, options, widened));
    }
    let sought = driven.map(|point| (point.particle, point.direction));
    let supports = read.then(|| Supports::new(&galerkin, &conditions, essential, sought));
    let heated = Heated { scene, solid, galerkin: &galerkin, places: &places, sets: &sets };
    let conduction = heated.asked()?;
    if let Some(strains) = heated.strains(conduction.as_ref().map(|own| &own.0))? {
        galerkin.warm(strains);
    }
    let sets = sets.into_members();
    Ok(GalerkinParts { galerkin, places, probes, driven, supports, memory, widened, conduction, sets })
}

/// Refuses a support that was asked for and is too narrow by a factor.
fn too_narrow(scene: &BodyInScene<'_>, options: &scene::Galerkin, factor: f64) -> SceneError {
    let (word, given) = options.support().said();
    let list = |factor: f64| {
        let radii: Vec<String> =
            given.iter().map(|radius| format!("{}", (1e3 * factor * radius).ceil() / 1e3)).collect();
        if radii.len() == 1 { radii[0].clone() } else { format!("[{}]", radii.join(", ")) }
    };
    let wide = list(factor);
    let bound = format!("about {wide} at least: nodes in less do not determine the basis at every point");
    let repair = format!("use {word} = {wide}, or leave the support out: it is then as wide as it has to be");
    let path = format!("formulation.galerkin.support.{word}");
    scene.body_scope().value(&path, list(1.0), &bound, &repair)
}

/// Refuses fewer layers of nodes along an axis than its powers in the basis ask for, whatever the support.
fn refuse_few_layers(
    scene: &BodyInScene<'_>,
    solid: &SolidScene,
    options: &scene::Galerkin,
) -> Result<(), SceneError> {
    let lattice = solid.lattice();
    let Ok(cells) = lattice.cells() else { return Ok(()) };
    let enough = [0, 1, 2].map(|axis| cells[axis].max(options.least_cells(axis)));
    let Some(axis) = (0..3).find(|&axis| cells[axis] < enough[axis]) else { return Ok(()) };
    let why = format!("the basis asks for {} nodes along {}", enough[axis] + 1, ["x", "y", "z"][axis]);
    let (key, given, bound, wide) = if solid.geometry.arc.is_some() {
        ("geometry.arc.cells", format!("{cells:?}"), "at least", format!("{enough:?}"))
    } else {
        let spacing = [0, 1, 2].map(|axis| lattice.lengths[axis] / enough[axis] as f64);
        ("geometry.block.spacing", format!("{:?}", lattice.spacing), "at most", format!("{spacing:?}"))
    };
    let repair = format!("use {wide}; basis = \"linear\" does with one cell, but locks in bending");
    Err(scene.body_scope().value(key, given, &format!("{wide} {bound}: {why}"), &repair))
}

/// Puts a refusal of the solid where the scene causes it.
fn galerkin_refusal(scene: &BodyInScene<'_>, solid: &SolidScene, error: &GalerkinError) -> SceneError {
    let of_body = |path: &str| scene.body_scope().path(path);
    let path = match error {
        GalerkinError::Shape(_) => of_body("formulation.galerkin"),
        GalerkinError::Cells(_)
        | GalerkinError::Points { .. }
        | GalerkinError::Coincident(..)
        | GalerkinError::NotFinite { .. } => of_body("geometry"),
        GalerkinError::Density(_) | GalerkinError::Axes(_) | GalerkinError::FlowWithoutSteps => {
            of_body(material_path(solid))
        }
        GalerkinError::Contradiction { .. } | GalerkinError::Direction(_) => "supports".into(),
        GalerkinError::EmptySet(_) | GalerkinError::NoSuchNode { .. } => "sets".into(),
    };
    model_error(scene.source, &path, &error.to_string())
}

/// Key of the material of a solid.
fn material_path(solid: &SolidScene) -> &'static str {
    match solid.material {
        SolidMaterial::Elastic(_) => "material.elastic",
        SolidMaterial::Orthotropic(_) => "material.orthotropic",
        SolidMaterial::Plastic(_) => "material.plastic",
    }
}
