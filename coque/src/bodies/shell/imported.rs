//! A surface from a file as the particles of a scene: cloud, sets, edges, refusals.

use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::path::Path;

use sph_core::{Cloud, Vec3};

use crate::bodies::sets::Sets;
use crate::scene::error::SceneError;
use crate::scene::{Formulation, Load, Mesh, Scene, Section};
use mesh_io::surface::{Cells, MeshError, Surface, boundary_edges, chains, read};

/// Length below which the part of a normal in its symmetry plane has no direction.
const NO_DIRECTION: f64 = 1e-6;

/// Parts of a thickness by which points may differ from that of the section.
const SAME_THICKNESS: f64 = 1e-6;

/// Where the particles of a model come from, if from a file.
#[derive(Clone, Debug)]
pub(crate) struct Provenance {
    /// The file.
    pub(crate) file: String,
    /// Checksum of its bytes.
    pub(crate) checksum: u32,
    /// What became of its faces, in a line for the summary.
    pub(crate) line: String,
}

/// A surface, the cloud made of it, and its boundary.
#[derive(Clone, Debug)]
pub(crate) struct Imported {
    surface: Surface,
    /// Where `placed` puts it, not turned yet.
    pub(crate) cloud: Cloud,
    cells: Cells,
    /// End of the boundary edge that begins at a particle.
    edges: HashMap<u32, u32>,
    kept: Kept,
}

/// Groups of faces that stay groups of cells.
#[derive(Clone, Debug, Default)]
struct Kept {
    /// Kind of each cell: its faces lie in the same groups.
    kinds: Vec<u32>,
    /// Kinds that make up each group.
    groups: BTreeMap<String, BTreeSet<u32>>,
}

impl Imported {
    /// Reads the file of a scene, if it names one.
    pub(crate) fn read(scene: &Scene) -> Result<Option<Self>, SceneError> {
        let Some(Mesh { file, scale, flip }) = scene.shell().geometry.mesh() else { return Ok(None) };
        let refuse = |error: &MeshError| refuse(scene, error);
        let folder = Path::new(scene.source.origin()).parent().unwrap_or(Path::new(""));
        let surface = read(&folder.join(file)).map_err(|error| refuse(&error))?.scaled(*scale);
        let surface = if *flip { surface.flipped() } else { surface };
        refuse_points(scene, &surface)?;
        let (of_faces, groups) = kinds(&surface, &groups_used(scene, &surface));
        let made = surface.cloud_of_kinds(surface.node_normals(), &of_faces);
        let (cloud, cells, kinds) = made.map_err(|error| refuse(&error))?;
        let edges = boundary_edges(&surface.faces);
        Ok(Some(Self { surface, cloud, cells, edges, kept: Kept { kinds, groups } }))
    }

    /// Cells of a group of faces; none if the file has no such group.
    pub(crate) fn cells_of(&self, name: &str) -> Option<Vec<u32>> {
        let own = self.kept.groups.get(name)?;
        let cells = (0..).zip(&self.kept.kinds).filter(|(_, kind)| own.contains(kind));
        Some(cells.map(|(cell, _)| cell).collect())
    }

    /// The sets that the file brings: all particles, its groups, its boundary loops.
    pub(crate) fn sets(&self, scene: &Scene) -> Result<BTreeMap<String, Vec<u32>>, SceneError> {
        if let Some(name) = scene.sets.keys().find(|name| self.surface.set(name).is_some()) {
            let bound = format!("but {} has a set of that name", self.surface.file);
            let fault =
                scene.source.fault(&format!("sets.{name}"), "declared", &bound, "choose another name");
            return Err(SceneError::Set(fault));
        }
        let names = self.surface.set_names();
        let known = names.into_iter().filter_map(|name| {
            let particles = self.surface.set(&name)?.to_vec();
            Some((name, particles))
        });
        let all = (0..self.surface.positions.len() as u32).collect();
        Ok(known.chain([("all".to_string(), all)]).collect())
    }

    /// Particles with tributary lengths \[L\] if the set lies along the boundary; a couple needs one line of it.
    pub(crate) fn edge(
        &self,
        scene: &Scene,
        path: &str,
        load: &Load,
        particles: &[u32],
    ) -> Result<Option<Vec<(u32, f64)>>, SceneError> {
        let lines = chains(particles, &self.surface.positions, &self.edges);
        let count = lines.as_ref().map_or(0, Vec::len);
        if load.couple.is_some() && count != 1 {
            let why = match count {
                0 => "its particles do not follow the boundary".to_string(),
                count => format!("its particles lie on {count} lines of the boundary"),
            };
            let bound = format!("but a couple acts on one line along the boundary: {why}");
            let repair = "use a boundary loop, or a box or plane that holds one edge alone";
            let fault = scene.source.fault(path, &format!("\"{}\"", load.on), &bound, repair);
            return Err(SceneError::Set(fault));
        }
        Ok(lines.map(|lines| lines.into_iter().flatten().collect()))
    }

    /// The cloud with reconstructed normals turned into the symmetry planes of the scene.
    ///
    /// At a symmetry plane the faces of one side only are there, and their mean leans out of the plane.
    pub(crate) fn mirrored(&self, scene: &Scene, sets: &Sets) -> Result<Cloud, SceneError> {
        let planes: Vec<_> = scene.supports.iter().map(|support| support.symmetry).collect();
        if self.surface.normals.is_some() || planes.iter().all(Option::is_none) {
            return Ok(self.cloud.clone());
        }
        let mut normals: Vec<Vec3> = self.cloud.frames.iter().map(|frame| frame.n).collect();
        for (i, plane) in planes.into_iter().enumerate() {
            let Some(plane) = plane else { continue };
            let (path, on) = (format!("supports[{i}].on"), &scene.supports[i].on);
            let across = Vec3::from(plane.normal).normalize();
            for &a in sets.at(scene, &path, on)? {
                let normal = normals[a as usize];
                let inside = normal - across * across.dot(&normal);
                if inside.norm() < NO_DIRECTION {
                    let bound =
                        format!("but the surface is parallel to the plane at {}", self.surface.name(a));
                    let repair = "a symmetry plane cuts the surface: name the particles on the cut";
                    let fault = scene.source.fault(&path, &format!("\"{on}\""), &bound, repair);
                    return Err(SceneError::Set(fault));
                }
                normals[a as usize] = inside.normalize();
            }
        }
        let Cloud { positions, cells, .. } = self.cloud.clone();
        let cloud = Cloud::from_cells(positions, Some(normals), cells);
        cloud.map_err(|error| refuse(scene, &self.surface.refusal(&error)))
    }

    /// Where the particles come from.
    pub(crate) fn provenance(&self) -> Provenance {
        let Surface { file, checksum, normals, .. } = &self.surface;
        let from = if normals.is_some() { "the file" } else { "the faces" };
        let line = format!("surface from {file}: {}, normals from {from}", self.cells);
        Provenance { file: file.clone(), checksum: *checksum, line }
    }
}

/// Groups of faces that the scene uses as cells.
fn groups_used(scene: &Scene, surface: &Surface) -> BTreeSet<String> {
    let loads = scene.loads.iter().filter(|load| load.acts_on_cells()).map(|load| &load.on);
    loads.filter(|name| surface.face_sets.contains_key(*name)).cloned().collect()
}

/// A number for each face, the same for faces that lie in the same groups, and the numbers of each group.
fn kinds(surface: &Surface, groups: &BTreeSet<String>) -> (Vec<u32>, BTreeMap<String, BTreeSet<u32>>) {
    let mut within: Vec<Vec<u32>> = vec![Vec::new(); surface.faces.len()];
    for (number, group) in (0..).zip(groups) {
        surface.face_sets[group].iter().for_each(|&face| within[face as usize].push(number));
    }
    let mut numbers = BTreeMap::new();
    let kinds: Vec<u32> = within
        .iter()
        .map(|own| {
            let next = numbers.len() as u32;
            *numbers.entry(own).or_insert(next)
        })
        .collect();
    let of_group = |(number, group): (u32, &String)| {
        let own = numbers.iter().filter(|(within, _)| within.contains(&number)).map(|(_, kind)| *kind);
        (group.clone(), own.collect())
    };
    let groups = (0..).zip(groups).map(of_group).collect();
    (kinds, groups)
}

/// A refusal of the file, shown at its name in the scene.
fn refuse(scene: &Scene, error: &MeshError) -> SceneError {
    let mut said = error.clone();
    let repair = std::mem::take(&mut said.repair);
    let value = said.to_string();
    let value = value.trim_end_matches([';', ' ']);
    SceneError::Mesh(scene.body_scope().fault("geometry.mesh.file", value, "a sound surface", &repair))
}

/// Points without faces have neither cells nor an edge: what needs them is refused.
fn refuse_points(scene: &Scene, surface: &Surface) -> Result<(), SceneError> {
    if !surface.faces.is_empty() {
        return Ok(());
    }
    let plain = matches!(&scene.shell().formulation, Formulation::Nodal(f) if !f.divergence_consistent());
    if !plain {
        let value = format!("{} has points without faces", surface.file);
        let repair = "set formulation.nodal.consistent = false, or bring a mesh with faces";
        let bound = "a surface with faces: cells and edges are found from them";
        return Err(SceneError::Mesh(scene.body_scope().fault("geometry.mesh.file", &value, bound, repair)));
    }
    if let Some(i) = scene.loads.iter().position(|load| load.pressure.is_some()) {
        let bound = "but pressure acts on faces, and the file has points only";
        let fault = scene.source.fault(
            &format!("loads[{i}].pressure"),
            "a pressure",
            bound,
            "bring a mesh with faces",
        );
        return Err(SceneError::Set(fault));
    }
    let own = scene.shell().section.thickness();
    let other = |t: &&f64| (**t / own - 1.0).abs() > SAME_THICKNESS;
    if let Some(thickness) = surface.thicknesses.iter().find(other) {
        let bound =
            format!("{thickness} as in {}: one thickness for the whole shell is modelled", surface.file);
        let repair = "make them equal, or take the column out of the file";
        let path = match &scene.shell().section {
            Section::Homogeneous(_) => "section.homogeneous.thickness",
            Section::Layered(_) => "section.layered.plies",
        };
        return Err(scene.body_scope().value(path, own, &bound, repair));
    }
    Ok(())
}
