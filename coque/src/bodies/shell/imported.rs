//! A surface from a file as the particles of a scene: cloud, sets, edges, refusals.

use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::path::Path;

use sph_core::{Cloud, Vec3};
use sph_shell::Tie;

use crate::bodies::sets::Sets;
use crate::scene::body_in_scene::{OnSet, ShellInScene};
use crate::scene::error::SceneError;
use crate::scene::{Axis, Formulation, Load, Mesh, Reach, Section};
use mesh_io::surface::{
    Cells, FileMaterial, FileSection, MeshError, Surface, boundary_edges, chains, quality, read,
    read_to_be_tied,
};

/// Length below which the part of a normal in its symmetry plane has no direction.
const NO_DIRECTION: f64 = 1e-6;

/// Warping of a quadrangle \[rad\] beyond which it is reported, as by `coque mesh`.
const WARPED: f64 = 0.2;

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
    /// What of its faces makes answers worse, if anything does.
    pub(crate) poor: Option<String>,
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
    kept: CellLists,
}

/// Groups of faces that stay groups of cells.
#[derive(Clone, Debug, Default)]
struct CellLists {
    /// Kind of each cell: its faces lie in the same groups.
    kinds: Vec<u32>,
    /// Kinds that make up each group.
    groups: BTreeMap<String, BTreeSet<u32>>,
    /// Kinds that make up each section of the file, where the scene asks for them.
    sections: Vec<BTreeSet<u32>>,
}

impl Imported {
    /// Reads the file of a scene, if it names one.
    pub(crate) fn read(scene: &ShellInScene<'_>) -> Result<Option<Self>, SceneError> {
        let Some(Mesh { file, scale, flip }) = scene.shell.geometry.mesh() else { return Ok(None) };
        let refuse = |error: &MeshError| refuse(scene, error);
        let folder = Path::new(scene.source.origin()).parent().unwrap_or(Path::new(""));
        let path = folder.join(file);
        let tied = !scene.shell.ties.is_empty();
        let surface = match scene.scene.surfaces.get(file) {
            Some(arrays) => arrays.surface(file, tied),
            None if tied => read_to_be_tied(&path),
            None => read(&path),
        };
        let surface = surface.map_err(|error| refuse(&error))?.scaled(scale.get());
        let surface = if *flip { surface.flipped() } else { surface };
        refuse_points(scene, &surface)?;
        let surface =
            if of_cells(scene) { surface } else { surface.undivided().map_err(|error| refuse(&error))? };
        let names = groups_used(scene, &surface);
        let sections = sections_used(scene, &surface)?;
        let mut lists: Vec<&[u32]> = names.iter().map(|name| &surface.face_sets[name][..]).collect();
        lists.extend(sections.iter().map(|section| &section.faces[..]));
        let (of_faces, mut of_lists) = kinds(surface.faces.len(), &lists);
        let of_sections = of_lists.split_off(names.len());
        let made = surface.cloud_of_kinds(surface.node_normals(), &of_faces);
        let (cloud, cells, kinds) = made.map_err(|error| refuse(&error))?;
        let edges = boundary_edges(&surface.faces);
        let kept =
            CellLists { kinds, groups: names.into_iter().zip(of_lists).collect(), sections: of_sections };
        Ok(Some(Self { surface, cloud, cells, edges, kept }))
    }

    /// Refuses a node on a foreign edge that no tie takes up.
    pub(super) fn refuse_hanging(&self, scene: &ShellInScene<'_>, ties: &[Tie]) -> Result<(), SceneError> {
        let places = |tie: &Tie| -> Vec<Vec3> {
            tie.edge.iter().map(|&a| self.surface.positions[a as usize]).collect()
        };
        let tied: Vec<Vec3> = ties.iter().flat_map(places).collect();
        let loose = self.surface.hanging.iter().find(|node| !tied.contains(&node.place));
        let refused = |refusal: &MeshError| {
            refuse(scene, &MeshError { file: self.surface.file.clone(), ..refusal.clone() })
        };
        loose.map_or(Ok(()), |node| Err(refused(&node.refusal)))
    }

    /// Cells of a group of faces; none if the file has no such group.
    pub(crate) fn cells_of(&self, name: &str) -> Option<Vec<u32>> {
        let own = self.kept.groups.get(name)?;
        let cells = (0..).zip(&self.kept.kinds).filter(|(_, kind)| own.contains(kind));
        Some(cells.map(|(cell, _)| cell).collect())
    }

    /// The section that the file gives to a cell, and its material.
    pub(crate) fn section_of(&self, cell: u32) -> Option<(usize, &FileSection, &FileMaterial)> {
        let kind = self.kept.kinds.get(cell as usize)?;
        let number = self.kept.sections.iter().position(|kinds| kinds.contains(kind))?;
        let section = &self.surface.sections[number];
        Some((number, section, self.surface.materials.get(&section.material.to_lowercase())?))
    }

    /// The sets that the file brings: all particles, its groups, its boundary loops.
    pub(crate) fn sets(&self, scene: &ShellInScene<'_>) -> Result<BTreeMap<String, Vec<u32>>, SceneError> {
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

    /// Particles with tributary lengths \[L\] if the set lies along the boundary; a couple about the edge needs one line of it.
    pub(crate) fn edge(
        &self,
        scene: &ShellInScene<'_>,
        path: &str,
        load: &OnSet<'_, Load>,
        particles: &[u32],
    ) -> Result<Option<Vec<(u32, f64)>>, SceneError> {
        let lines = self.lines(particles);
        let count = lines.as_ref().map_or(0, Vec::len);
        if load.couple.is_some_and(|couple| couple.axis == Axis::Edge) && count != 1 {
            let why = match count {
                0 => "its particles do not follow the boundary".to_string(),
                count => format!("its particles lie on {count} lines of the boundary"),
            };
            let bound = format!("but a couple about the edge acts on one line along the boundary: {why}");
            let repair = "use a boundary loop, or a box or plane that holds one edge alone";
            let fault = scene.source.fault(path, &format!("\"{}\"", load.on), &bound, repair);
            return Err(SceneError::Set(fault));
        }
        Ok(lines.map(|lines| lines.into_iter().flatten().collect()))
    }

    /// The lines of the boundary along which some particles lie, with tributary lengths \[L\]; none if they do not.
    pub(crate) fn lines(&self, particles: &[u32]) -> Option<Vec<Vec<(u32, f64)>>> {
        chains(particles, &self.surface.positions, &self.edges)
    }

    /// The cloud with reconstructed normals turned into the symmetry planes of the scene.
    ///
    /// At a symmetry plane the faces of one side only are there, and their mean leans out of the plane.
    pub(crate) fn mirrored(&self, scene: &ShellInScene<'_>, sets: &Sets) -> Result<Cloud, SceneError> {
        if self.surface.normals.is_some() || scene.supports.iter().all(|support| support.symmetry.is_none()) {
            return Ok(self.cloud.clone());
        }
        let mut normals: Vec<Vec3> = self.cloud.frames.iter().map(|frame| frame.n).collect();
        for support in &scene.supports {
            let Some(plane) = support.symmetry else { continue };
            let (path, on) = (support.at("on"), support.on);
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
        let Cloud { positions, cells, joined, .. } = self.cloud.clone();
        let cloud = Cloud::from_sheets(positions, Some(normals), cells, joined);
        cloud.map_err(|error| refuse(scene, &self.surface.refusal(&error)))
    }

    /// Where the particles come from.
    pub(crate) fn provenance(&self) -> Provenance {
        let Surface { file, checksum, normals, .. } = &self.surface;
        let from = if normals.is_some() { "the file" } else { "the faces" };
        let mut line = format!("surface from {file}: {}, normals from {from}", self.cells);
        if !self.surface.joined.is_empty() {
            line.push_str(&format!("; {}", self.surface.tied()));
        }
        let poor = warped(&self.surface);
        Provenance { file: file.clone(), checksum: *checksum, line, poor }
    }
}

/// What is said of faces that are warped. Hollow ones are cut; what `coque mesh` says beside that is about the stable step.
fn warped(surface: &Surface) -> Option<String> {
    let figures = quality(surface);
    (figures.warp > WARPED).then(|| {
        format!(
            "quadrangles of {} are warped by up to {:.0}°: one point in the middle does not stand for such a cell, and answers may be off \
             by percents, buckling loads most; mend the mesh there, or refine it where it curves",
            surface.file,
            figures.warp.to_degrees()
        )
    })
}

/// Whether strains are sampled at cells, which keep the sheets of a junction apart.
fn of_cells(scene: &ShellInScene<'_>) -> bool {
    matches!(&scene.shell.formulation, Formulation::StressPoint(f) if f.support == Reach::Cell)
}

/// Groups of faces that the scene uses as cells.
fn groups_used(scene: &ShellInScene<'_>, surface: &Surface) -> BTreeSet<String> {
    let loads = scene.loads.iter().filter(|load| load.acts_on_cells()).map(|load| load.on);
    let parts = scene.shell.parts.iter().map(|part| part.on.as_str());
    let hosts = scene.shell.ties.iter().map(|tie| tie.to.as_str());
    let used = scene.with_operands(loads.chain(parts).chain(hosts)).into_iter();
    used.filter(|name| surface.face_sets.contains_key(*name)).map(Into::into).collect()
}

/// The sections of the file, if the scene asks for them: every face in one, each with a material that the file has.
fn sections_used<'a>(
    scene: &ShellInScene<'_>,
    surface: &'a Surface,
) -> Result<&'a [FileSection], SceneError> {
    let shell = scene.shell;
    let in_parts = (0..shell.parts.len()).map(|i| (format!("parts[{i}]."), shell.in_part(i)));
    let mut all = in_parts.chain([(String::new(), shell.clone())]);
    let Some((at, asking)) = all.find(|(_, shell)| shell.takes_from_file()) else { return Ok(&[]) };
    let key = if asking.section.thickness().is_none() { "section.file" } else { "material.file" };
    let path = format!("{at}{key}");
    let (file, sections) = (&surface.file, &surface.sections);
    let refuse = |value: String, bound: &str, repair: &str| {
        Err(SceneError::Mesh(scene.body_scope().fault(&path, &value, bound, repair)))
    };
    if sections.is_empty() {
        let repair =
            "give [section.homogeneous] and [material.elastic], and [[parts]] for groups that differ";
        let value = format!("{file} gives no section to any group of faces");
        return refuse(value, "a homogeneous *Shell Section in an Abaqus file", repair);
    }
    if shell.geometry.mesh().is_some_and(|mesh| *mesh.scale != 1.0) && asking.density().is_none() {
        let value = format!("the moduli of {file} are in units of its own, and its lengths are scaled");
        return refuse(value, "moduli in the units of the scene", "write the scene in the units of the file");
    }
    if surface.turned > 0 && sections.iter().any(|section| section.offset != 0.0) {
        let value = format!(
            "{file} gives sections with an offset, and {} of its faces were turned round: offsets go along normals",
            surface.turned
        );
        return refuse(value, "faces that agree", "turn the faces in the file, or give offsets in [[parts]]");
    }
    let name = |face: usize| format!("face {} (line {})", surface.origins[face].0, surface.origins[face].1);
    let mut of_face: Vec<Option<&FileSection>> = vec![None; surface.faces.len()];
    for section in sections {
        if !surface.materials.contains_key(&section.material.to_lowercase()) {
            let value = format!(
                "the section at line {} of {file} is of a material \"{}\", which the file does not have",
                section.line, section.material
            );
            return refuse(value, "a *Material of that name", "add it to the file");
        }
        for &face in &section.faces {
            if let Some(other) = of_face[face as usize].replace(section) {
                let value = format!(
                    "{} of {file} lies in the sections at lines {} and {}",
                    name(face as usize),
                    other.line,
                    section.line
                );
                return refuse(value, "one section a face", "take it out of one of the two groups");
            }
        }
    }
    // Faces that parts of the scene name need none of the file.
    let named: BTreeSet<u32> = (shell.parts.iter())
        .filter(|part| part.section.is_some() && part.material.is_some())
        .flat_map(|part| faces_of(scene, surface, &part.on))
        .collect();
    let bare = |face: &usize| of_face[*face].is_none() && !named.contains(&(*face as u32));
    if let Some(face) = (0..surface.faces.len()).find(bare) {
        let value = format!("{} of {file} lies in no section", name(face));
        return refuse(
            value,
            "a section for every face",
            "add its group to a *Shell Section, or to a part of the scene",
        );
    }
    Ok(sections)
}

/// Faces of a group of the file, or of what is made of groups; of any other set none.
fn faces_of(scene: &ShellInScene<'_>, surface: &Surface, name: &str) -> Vec<u32> {
    match scene.sets.get(name).and_then(|region| region.made()) {
        Some((made, sets)) => {
            let each = sets.iter().map(|set| faces_of(scene, surface, scene.own_set(set)));
            made.members(&each.collect::<Vec<_>>())
        }
        None => surface.face_sets.get(name).cloned().unwrap_or_default(),
    }
}

/// A number for each of so many faces, the same for faces that lie in the same lists, and the numbers of each list.
fn kinds(faces: usize, lists: &[&[u32]]) -> (Vec<u32>, Vec<BTreeSet<u32>>) {
    let mut within: Vec<Vec<usize>> = vec![Vec::new(); faces];
    for (number, list) in lists.iter().enumerate() {
        list.iter().for_each(|&face| within[face as usize].push(number));
    }
    let mut numbers = BTreeMap::new();
    let number = |own: &Vec<usize>| {
        let next = numbers.len() as u32;
        *numbers.entry(own.clone()).or_insert(next)
    };
    let kinds: Vec<u32> = within.iter().map(number).collect();
    let of_list = |list: usize| {
        numbers.iter().filter(|(within, _)| within.contains(&list)).map(|(_, kind)| *kind).collect()
    };
    let of_lists = (0..lists.len()).map(of_list).collect();
    (kinds, of_lists)
}

/// A refusal of the file, shown at its name in the scene.
fn refuse(scene: &ShellInScene<'_>, error: &MeshError) -> SceneError {
    let mut said = error.clone();
    let repair = std::mem::take(&mut said.repair);
    let value = said.to_string();
    let value = value.trim_end_matches([';', ' ']);
    SceneError::Mesh(scene.body_scope().fault("geometry.mesh.file", value, "a sound surface", &repair))
}

/// Points without faces have neither cells nor an edge: what needs them is refused.
fn refuse_points(scene: &ShellInScene<'_>, surface: &Surface) -> Result<(), SceneError> {
    if !surface.faces.is_empty() {
        return Ok(());
    }
    let plain = matches!(&scene.shell.formulation, Formulation::Nodal(f) if !f.divergence_consistent());
    if !plain {
        let value = format!("{} has points without faces", surface.file);
        let repair = "set formulation.nodal.consistent = false, or bring a mesh with faces";
        let bound = "a surface with faces: cells and edges are found from them";
        return Err(SceneError::Mesh(scene.body_scope().fault("geometry.mesh.file", &value, bound, repair)));
    }
    if let Some(load) = scene.loads.iter().find(|load| load.pressure.is_some()) {
        let (bound, repair) =
            ("but pressure acts on faces, and the file has points only", "bring a mesh with faces");
        let fault = scene.source.fault(&load.at("pressure"), "a pressure", bound, repair);
        return Err(SceneError::Set(fault));
    }
    // Without a thickness of its own the scene has been refused: the file gives no section.
    let own = scene.shell.section.thickness().unwrap_or_default();
    let other = |t: &&f64| (**t / own - 1.0).abs() > SAME_THICKNESS;
    if let Some(thickness) = surface.thicknesses.iter().find(other) {
        let bound =
            format!("{thickness} as in {}: one thickness for the whole shell is modelled", surface.file);
        let repair = "make them equal, or take the column out of the file";
        let path = match &scene.shell.section {
            Section::Layered(_) => "section.layered.plies",
            Section::Stiffness(_) => "section.stiffness.thickness",
            _ => "section.homogeneous.thickness",
        };
        return Err(scene.body_scope().value(path, own, &bound, repair));
    }
    Ok(())
}
