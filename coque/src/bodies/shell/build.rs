//! From a scene to a shell ready to move: particles, sets, supports, loads.

use std::collections::BTreeMap;

use explicit_dynamics::Amplitude;
use nalgebra::Rotation3;
use sph_core::{Cell, Vec3};
use sph_shell::{
    AppliedLoad, Conduction, Parts, Shell, ShellError, StaticShell, Supported, Wetting, origin_of,
};

use super::balance::warning_of_start;
use super::cells::CellSets;
use super::conducting::ConductingShell;
use super::describe::describe;
use super::edges::free_edges;
use super::heated::Heated;
use super::imported::{Imported, Provenance};
use super::places;
use super::rigid::free_motions;
use super::warnings::{warnings_of, warnings_of_shapes};
use crate::bodies::memory::{check_memory, particles_asked};
use crate::bodies::refusal::{not_a, refuse_dof, refuse_free_motion};
use crate::bodies::sets::Sets;
use crate::bodies::{BuiltBody, Identity, Memory, Model, PrescribedPoint, Probe, Ready, Shape};
use crate::scene::body_in_scene::ShellInScene;
use crate::scene::error::SceneError;
use crate::scene::{self, Checked, SupportKind};
use crate::warning::{Warning, WarningKind};

impl Checked {
    /// Builds the shell alone, for programs that march or solve it themselves.
    ///
    /// # Errors
    /// As [`Checked::build`], and for a body of another kind.
    pub fn build_shell(&self, threads: usize) -> Result<Shell, SceneError> {
        let scene = &self.first_body()?;
        let shell = scene.as_shell().ok_or_else(|| not_a(scene, "shell"))?;
        assemble(&ShellInScene::new(scene, shell), threads, None).map(|built| built.shell)
    }
}

/// Builds a shell with what is asked of it.
pub(in crate::bodies) fn shell_model(scene: &ShellInScene<'_>, threads: usize) -> Result<Model, SceneError> {
    if matches!(scene.analysis, scene::Analysis::Heat(_)) {
        return conducting_model(scene, threads);
    }
    let ready = |shell| match scene.analysis {
        scene::Analysis::Explicit(_) => Ready::Dynamic(Box::new(shell)),
        _ => Ready::Static(Box::new(StaticShell::new(shell))),
    };
    Ok(shell_made(scene, threads, None)?.map(ready).model(scene.scene, threads))
}

/// Builds a shell that conducts heat.
fn conducting_model(scene: &ShellInScene<'_>, threads: usize) -> Result<Model, SceneError> {
    let mut parts = assemble(scene, threads, None)?;
    let conduction = parts.conduction.take().ok_or_else(|| not_a(scene, "shell with [[heat]]"))?;
    let capacities = std::mem::take(&mut parts.capacities);
    let ready = |shell| Ready::Heat(Box::new(ConductingShell::new(shell, conduction, capacities)));
    Ok(looked_at(scene, parts).map(ready).model(scene.scene, threads))
}

/// Builds a shell, wets it if that is wanted, and looks at it.
pub(in crate::bodies) fn shell_made(
    scene: &ShellInScene<'_>,
    threads: usize,
    wetting: Option<Wetting>,
) -> Result<BuiltBody<Shell>, SceneError> {
    Ok(looked_at(scene, assemble(scene, threads, wetting)?))
}

/// A shell with what is known of it before it runs.
fn looked_at(scene: &ShellInScene<'_>, parts: ShellParts) -> BuiltBody<Shell> {
    let ShellParts { mut shell, probes, driven, surface, turn, memory, said, sets, .. } = parts;
    let description = describe(scene, &shell, surface.as_ref(), said);
    let mut warnings = warnings_of(scene, turn, &shell);
    let poor = surface.iter().filter_map(|surface| surface.poor.clone());
    warnings.extend(poor.map(|message| Warning::new(WarningKind::PoorMesh, message)));
    warnings.extend(warning_of_start(scene, &mut shell));
    let cloud = &shell.reference().cloud;
    let (loss, area) = (shell.chord_loss(), cloud.areas.iter().sum());
    let judge = move |cells: &[Cell], shapes: &[Shape]| warnings_of_shapes(cells, loss, area, shapes);
    let identity = surface.map_or_else(Identity::default, |surface| Identity {
        file: Some(surface.file),
        checksum: Some(surface.checksum),
    });
    let judge = Some(Box::new(judge) as _);
    BuiltBody { body: shell, description, memory, identity, probes, driven, warnings, judge, sets }
}

pub(super) fn assemble(
    scene: &ShellInScene<'_>,
    threads: usize,
    wetting: Option<Wetting>,
) -> Result<ShellParts, SceneError> {
    let mut builder = Builder { scene, turn: turn(scene), warmed: Vec::new() };
    let weights = places::end_weights(scene);
    let asked =
        particles_asked(&scene.shell.geometry).map(|particles| check_memory(scene, particles)).transpose()?;
    let mut imported = Imported::read(scene)?;
    if let Some(imported) = &mut imported {
        imported.cloud = places::placed(scene, imported.cloud.clone());
    }
    let memory = match (asked, &imported) {
        (Some(memory), _) => memory,
        (None, Some(imported)) => check_memory(scene, imported.cloud.len() as f64)?,
        (None, None) => check_memory(scene, 0.0)?,
    };
    let flat = match &imported {
        Some(imported) => imported.cloud.clone(),
        None => places::placed(scene, places::place(scene, weights)?),
    };
    let brought = imported.as_ref().map(|imported| imported.sets(scene)).transpose()?;
    let sets = Sets::find(scene, &flat, brought)?;
    let flat = imported.as_ref().map_or(Ok(flat), |imported| imported.mirrored(scene, &sets))?;
    let cloud = builder.bent(flat.transformed(&builder.turn, &Vec3::zeros()), threads)?;
    let driver = builder.driver(&sets)?;
    let supports = builder.supports(&sets, driver)?;
    let cells = CellSets::new(scene, &flat, &sets, imported.as_ref());
    let (conduction, capacities) = match scene.scene.heat.is_empty() {
        true => (None, Vec::new()),
        false => {
            let imported = imported.as_ref();
            let (flat, cloud, sets, cells) = (&flat, &cloud, &sets, &cells);
            let heated = Heated { flat, cloud, sets, cells, imported, weights };
            let in_time =
                matches!(&scene.scene.analysis, scene::Analysis::Heat(heat) if heat.transient.is_some());
            let stored = if in_time { builder.heat_capacities(heated)? } else { Vec::new() };
            (Some(builder.conduction(heated)?), stored)
        }
    };
    let temperatures = builder.temperatures(&cells, &cloud, conduction.as_ref())?;
    builder.warm(&temperatures, cloud.cells.len());
    let sections = builder.sections(&flat, &cells, imported.as_ref())?;
    let mut loads = builder.loads(&sets, &cells, &sections, &cloud, weights, imported.as_ref())?;
    let driven = builder.driven(&sets, driver, &supports)?;
    if let Some(PrescribedPoint { particle, direction, .. }) = driven {
        let force = sph_shell::Force { shares: vec![(particle, 1.0)], total: direction };
        loads.push(AppliedLoad { load: Box::new(force), amplitude: Amplitude::Constant });
    }
    let rigid = builder.rigid(&sets, &cloud)?;
    let springs = builder.springs(&sets, &cloud)?;
    let ties = builder.ties(&sets, &cells)?;
    imported.as_ref().map_or(Ok(()), |imported| imported.refuse_hanging(scene, &ties))?;
    refuse_free_motion(scene, || {
        let held = supports.iter().map(|s| (s.particles.clone(), s.support.holds()));
        free_motions(&cloud, &held.collect::<Vec<_>>(), &ties, &rigid, &springs)
    })?;
    let wetting = wetting.map(|wetting| Wetting { free_edges: free_edges(&cloud, &supports), ..wetting });
    let masses = builder.masses(&sets)?;
    let stiffeners = builder.stiffeners(&sets)?;
    let stresses = builder.stresses(&cells)?;
    let tools = builder.tools(&sections, &cloud);
    let own_contact = builder.own_contact(&sections, &cloud);
    let parts = Parts {
        cloud,
        section: sections.base,
        strain: sections.strain,
        material_axis: sections.axis,
        density: sections.density,
        formulation: builder.formulation(),
        supports,
        loads,
        threads,
    };
    // Files may stand anywhere, and a part of several bodies shares its places with the others.
    let far = imported.is_some() && !scene.together && scene.scene.links.is_empty();
    let origin = if far { origin_of(&parts.cloud) } else { Vec3::zeros() };
    let mut shell = Shell::builder(parts)
        .regions(sections.regions)
        .origin(origin)
        .ties(ties)
        .masses(masses)
        .stiffeners(stiffeners)
        .rigid(rigid)
        .springs(springs)
        .tools(tools)
        .touching_itself(own_contact)
        .stresses(stresses)
        .temperatures(temperatures);
    if scene.stress_drives() {
        shell = shell.stress_by_level();
    }
    if let Some(wetting) = wetting {
        shell = shell.wetted(wetting);
    }
    let mut shell = shell.build().map_err(|e| builder.refusal(&e))?;
    builder.refuse_stress_alone(&mut shell)?;
    builder.refuse_in_tools(&mut shell)?;
    builder.refuse_in_itself(&mut shell)?;
    let probes = builder.probes(&sets, &cells, &shell)?;
    builder.set_out(&sets, &mut shell)?;
    refuse_dof(scene, shell.dof())?;
    let surface = imported.map(|imported| imported.provenance());
    let (turn, said) = (builder.turn, sections.said);
    let sets = sets.into_members();
    Ok(ShellParts { shell, conduction, capacities, probes, driven, surface, turn, memory, said, sets })
}

fn turn(scene: &ShellInScene<'_>) -> Rotation3<f64> {
    scene.shell.orientation.map_or_else(Rotation3::identity, |turn| turn.rotation())
}

/// A shell with what its curve measures.
pub(super) struct ShellParts {
    pub(super) shell: Shell,
    /// How it conducts heat, where the scene has any.
    conduction: Option<Conduction>,
    /// Heat that its particles store by degree \[F L/Θ\].
    capacities: Vec<(u32, f64)>,
    probes: Vec<Probe>,
    driven: Option<PrescribedPoint>,
    /// Where the surface comes from, if it was read from a file.
    surface: Option<Provenance>,
    turn: Rotation3<f64>,
    memory: Memory,
    /// Its parts, a line each.
    said: Vec<String>,
    /// Its particles by name of their set.
    sets: BTreeMap<String, Vec<u32>>,
}

pub(crate) struct Builder<'a> {
    pub(crate) scene: &'a ShellInScene<'a>,
    turn: Rotation3<f64>,
    /// By how much each cell is warmer once all loads are there in full \[Θ\]; empty where none is.
    pub(super) warmed: Vec<f64>,
}

impl Builder<'_> {
    /// A place as the scene gives it.
    pub(crate) fn turn_back(&self, v: &Vec3) -> Vec3 {
        self.turn.inverse() * v
    }

    pub(crate) fn turned(&self, v: [f64; 3]) -> Vec3 {
        self.turn * Vec3::from(v)
    }

    /// The axes of the scene in space, as columns.
    pub(crate) fn turned_axes(&self) -> nalgebra::Matrix3<f64> {
        *self.turn.matrix()
    }

    fn supports(&self, sets: &Sets, driver: Option<usize>) -> Result<Vec<Supported>, SceneError> {
        let mut supports = Vec::new();
        for (i, support) in self.scene.supports.iter().enumerate() {
            let particles = sets.at(self.scene, &support.at("on"), support.on)?;
            if self.scene.shell.rigid_body(support.on).is_some() {
                continue; // it holds the body
            }
            for (_, kind) in support.kinds() {
                if driver == Some(i) && matches!(kind, SupportKind::Moved(_)) {
                    continue; // its direction is left free for the force that brings it about
                }
                let course = support.amplitude.clone().unwrap_or_default();
                let Some(mut found) = self.support(kind, course) else { continue };
                if support.preload {
                    found = Box::new(sph_shell::Preloaded(found));
                }
                supports.push(Supported { particles: particles.to_vec(), support: found });
            }
        }
        Ok(supports)
    }

    /// Number of the support whose motion becomes a force that is sought: all that drives an analysis by levels, and of
    /// one particle. Every other motion is prescribed.
    fn driver(&self, sets: &Sets) -> Result<Option<usize>, SceneError> {
        let Some(i) = self.scene.sole_motion() else { return Ok(None) };
        let support = &self.scene.supports[i];
        let particles = sets.at(self.scene, &support.at("on"), support.on)?;
        Ok((particles.len() == 1).then_some(i))
    }

    /// The motion of that support.
    fn driven(
        &self,
        sets: &Sets,
        driver: Option<usize>,
        supports: &[Supported],
    ) -> Result<Option<PrescribedPoint>, SceneError> {
        let support = driver.map(|i| &self.scene.supports[i]);
        let Some((support, moved)) = support.and_then(|support| Some((support, support.moved?))) else {
            return Ok(None);
        };
        let &[particle] = sets.at(self.scene, &support.at("on"), support.on)? else { return Ok(None) };
        let direction = self.turned(moved.direction).normalize() * moved.by.signum();
        let others = supports.iter().filter(|s| s.particles.contains(&particle));
        for held in others.flat_map(|s| s.support.holds().translations) {
            let along = direction.dot(&held);
            if along.abs() > 1e-9 {
                let wanted = along * moved.by.abs();
                return Err(self.refusal(&ShellError::Contradiction { particle, wanted, held: 0.0 }));
            }
        }
        Ok(Some(PrescribedPoint { particle, direction, by: moved.by.abs() }))
    }

    pub(super) fn support(
        &self,
        kind: SupportKind,
        amplitude: Amplitude,
    ) -> Option<Box<dyn sph_shell::Support>> {
        Some(match kind {
            SupportKind::Clamped => Box::new(sph_shell::Clamped),
            SupportKind::Hinged => Box::new(sph_shell::Hinged),
            SupportKind::Symmetry(s) => Box::new(sph_shell::SymmetryPlane { normal: self.turned(s.normal) }),
            SupportKind::Diaphragm(s) => {
                Box::new(sph_shell::Diaphragm { axis: self.turned(s.axis), section: s.whole_section })
            }
            SupportKind::Held(s) => Box::new(sph_shell::Held {
                displacement: s.displacement.iter().map(|&v| self.turned(v)).collect(),
                director: s.director.first().map(|&v| self.turned(v)),
            }),
            SupportKind::Rotated(s) => {
                Box::new(sph_shell::Rotated { axis: self.turned(s.axis), by: s.by.to_radians(), amplitude })
            }
            SupportKind::Moved(s) => {
                Box::new(sph_shell::Moved { direction: self.turned(s.direction), by: s.by, amplitude })
            }
            SupportKind::Turned(s) => Box::new(sph_shell::Turned {
                axis: self.turned(s.axis),
                point: self.turned(s.point),
                by: s.by.to_radians(),
                amplitude,
            }),
            // It holds nothing.
            SupportKind::Spring(_) => return None,
        })
    }
}
