//! Surfaces from files: nodes in use, faces turned the same way, sheets cut where they meet, sets, boundary loops; and the cloud made of them.
//!
//! [`parse`] lets the reader of the format take what stands in a file, and makes it a sound [`Surface`] or refuses it.

mod arrays;
mod boundary;
mod curved;
mod error;
mod formats;
mod hollow;
mod junctions;
mod order;
mod orient;
mod outward;
mod quality;
mod raw;
mod refine;
mod refusal;
mod report;
mod sections;
mod sides;
mod tetrahedra;
mod undivided;

use std::{collections::BTreeMap, fmt};

use sph_core::{Cell, Cloud, Frame, Vec3, pair_triangles};

use boundary::{free_edges, loops};
use hollow::{Shape, shape};
use order::{along_the_surface, renumber};
use orient::{Turned, check_faces, orient, refuse_pinched, reversed};
use raw::{Raw, counted, node_name};

pub use self::{outward::side, refine::Finer, report::report};
pub use arrays::Arrays;
pub use boundary::{HangingNode, Loop, boundary_edges, chains};
pub use error::MeshError;
pub use formats::{Format, parse, parse_body, read, read_body, read_to_be_tied};
pub use junctions::Junctions;
pub use quality::{Quality, quality};
pub use sections::{FileMaterial, FileSection};

/// The bound of every scene; ten million particles take about ten gigabytes.
const MOST_NODES: usize = 10_000_000;

/// A surface that has passed every check.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    /// Name of the file.
    pub file: String,
    /// What the file was; none of arrays.
    pub format: Option<Format>,
    /// Checksum of its bytes.
    pub checksum: u32,
    /// Positions of the nodes `[L]`.
    pub positions: Vec<Vec3>,
    /// Triangles and quadrangles, counter-clockwise about the normal; none for points.
    pub faces: Vec<Cell>,
    /// Groups of the file by name, ascending.
    pub sets: BTreeMap<String, Vec<u32>>,
    /// Faces of the groups that the file gives as faces, by name, ascending; their nodes are in `sets`.
    pub face_sets: BTreeMap<String, Vec<u32>>,
    /// Sections of groups of faces, in the order of the file.
    pub sections: Vec<FileSection>,
    /// Materials that sections name, by name in small letters.
    pub materials: BTreeMap<String, FileMaterial>,
    /// Normals from the file (any length), where it gives all of them.
    pub normals: Option<Vec<Vec3>>,
    /// Tributary areas of points `[L²]`; empty for faces.
    pub areas: Vec<f64>,
    /// Thicknesses of points `[L]`, where the file gives them.
    pub thicknesses: Vec<f64>,
    /// Closed lines of boundary nodes, the longest first: the sets `boundary0`, `boundary1`, …
    pub loops: Vec<Loop>,
    /// Nodes of different sheets on one place, at junctions; each list ascending.
    pub joined: Vec<Vec<u32>>,
    /// Nodes on an edge that they do not belong to, where the surface is to be tied.
    pub hanging: Vec<HangingNode>,
    /// Edges at which sheets meet.
    pub junctions: Junctions,
    /// Connected pieces.
    pub pieces: usize,
    /// Faces that were turned round to agree with their neighbours.
    pub turned: usize,
    /// What was left aside, changed, or looks wrong, in words.
    pub notes: Vec<String>,
    /// Numbers of the nodes in the file, by which messages name them; empty where they have none.
    pub labels: Vec<u64>,
    /// Number and line of each face in the file, for messages; the line is zero where the format has none.
    pub origins: Vec<(u64, usize)>,
}

/// What became of the faces in a cloud.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cells {
    /// Quadrangles of the file.
    pub quadrangles: usize,
    /// Those of them with a corner beyond 180°, which became two triangles each.
    pub cut: usize,
    /// Triangles of the file.
    pub triangles: usize,
    /// Quadrangles made of two triangles each.
    pub joined: usize,
}

impl fmt::Display for Cells {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { quadrangles, cut, triangles, joined } = *self;
        if quadrangles > 0 || triangles == 0 {
            f.write_str(&counted(quadrangles, "quadrangle"))?;
        }
        if cut > 0 {
            write!(f, ", {cut} of them with a corner beyond 180° and cut into two triangles each")?;
        }
        if triangles == 0 {
            return Ok(());
        }
        let comma = if quadrangles > 0 { ", " } else { "" };
        let (triangles, pairs) = (counted(triangles, "triangle"), counted(joined, "quadrangle"));
        write!(f, "{comma}{triangles} joined into {pairs}")?;
        match self.triangles - 2 * joined {
            0 => Ok(()),
            left => write!(f, " and {} left over", counted(left, "triangle")),
        }
    }
}

impl Surface {
    /// Checks what a reader found and makes it sound.
    fn new(mut raw: Raw, format: Option<Format>, may_hang: bool) -> Result<Self, MeshError> {
        if raw.positions.len() > MOST_NODES {
            let what = format!("{} nodes; at most {MOST_NODES} are allowed", raw.positions.len());
            return Err(MeshError::whole(what, "use a coarser mesh"));
        }
        if raw.faces.is_empty() && raw.areas.is_empty() {
            let what = format!("no triangles or quadrangles among {}", counted(raw.positions.len(), "node"));
            return Err(MeshError::whole(what, "mesh the surface before it is written"));
        }
        check_faces(&raw)?;
        if raw.areas.is_empty() {
            drop_unused(&mut raw);
            if along_the_surface(&mut raw) {
                raw.notes
                    .push("nodes numbered along the surface; messages keep the numbers of the file".into());
            }
        }
        let pairs = junctions::pairs(&raw)?;
        let Turned { pieces, faces: turned, seams, hanging } = orient(&mut raw, &pairs, may_hang)?;
        let (junctions, joined) = junctions::cut(&mut raw, &pairs)?;
        refuse_pinched(&raw)?;
        let faces: Vec<Cell> = raw.faces.iter().map(|face| face.cell).collect();
        let edges = free_edges(&faces, &joined);
        if seams > 0 {
            let note =
                format!("coincident nodes on the boundary: {seams}; the surface is open there, as at a slit");
            raw.notes.push(note);
        }
        let normals = given_normals(&mut raw, &faces)?;
        let mut surface = Self {
            file: String::new(),
            format,
            checksum: 0,
            loops: loops(&raw.positions, &edges, &joined),
            joined,
            hanging,
            junctions,
            positions: raw.positions,
            faces,
            sets: BTreeMap::new(),
            face_sets: raw.face_sets,
            sections: raw.sections,
            materials: raw.materials,
            normals,
            areas: raw.areas,
            thicknesses: raw.thicknesses,
            pieces,
            turned,
            notes: raw.notes,
            labels: raw.labels,
            origins: raw.faces.iter().map(|face| (face.label, face.line)).collect(),
        };
        surface.name_sets(raw.sets)?;
        for faces in surface.face_sets.values_mut() {
            faces.sort_unstable();
            faces.dedup();
        }
        Ok(surface)
    }

    /// Sorts the groups of the file; `all` and the boundary loops have names of their own.
    fn name_sets(&mut self, sets: BTreeMap<String, Vec<u32>>) -> Result<(), MeshError> {
        for (name, mut nodes) in sets {
            nodes.sort_unstable();
            nodes.dedup();
            let whole = nodes.len() == self.positions.len();
            if nodes.is_empty() {
                self.notes.push(format!("group {name} left out: no face uses its nodes"));
            } else if name == "all" && whole {
                // The scene has this set already.
            } else if name == "all" || self.boundary(&name).is_some() {
                let what = format!("a group is called {name}, which names another set in every scene");
                return Err(MeshError::whole(what, "rename the group"));
            } else {
                self.sets.insert(name, nodes);
            }
        }
        Ok(())
    }

    /// The boundary loop that is called `boundary0`, `boundary1`, ….
    pub fn boundary(&self, name: &str) -> Option<&Loop> {
        let number: usize = name.strip_prefix("boundary")?.parse().ok()?;
        self.loops.get(number).filter(|_| name == format!("boundary{number}"))
    }

    /// Nodes of a set of the file or of a boundary loop.
    pub fn set(&self, name: &str) -> Option<&[u32]> {
        let own = self.sets.get(name).map(Vec::as_slice);
        own.or_else(|| self.boundary(name).map(|found| found.nodes.as_slice()))
    }

    /// How messages call a node.
    pub fn name(&self, node: u32) -> String {
        node_name(&self.positions, &self.labels, node)
    }

    /// Names of all sets.
    pub fn set_names(&self) -> Vec<String> {
        let loops = (0..self.loops.len()).map(|number| format!("boundary{number}"));
        self.sets.keys().cloned().chain(loops).collect()
    }

    /// Every length times `factor`.
    pub fn scaled(mut self, factor: f64) -> Self {
        self.positions.iter_mut().for_each(|x| *x *= factor);
        self.hanging.iter_mut().for_each(|node| node.place *= factor);
        self.areas.iter_mut().for_each(|area| *area *= factor * factor);
        self.thicknesses.iter_mut().for_each(|thickness| *thickness *= factor);
        self.loops.iter_mut().for_each(|found| found.length *= factor);
        self.sections.iter_mut().for_each(|section| section.thickness *= factor);
        self
    }

    /// Normals to the other side.
    pub fn flipped(mut self) -> Self {
        self.faces.iter_mut().for_each(|face| *face = reversed(face));
        self.normals.iter_mut().flatten().for_each(|normal| *normal = -*normal);
        // The surface stays on the left: loops run the other way.
        self.loops.iter_mut().for_each(|found| found.nodes[1..].reverse());
        self.sections.iter_mut().for_each(|section| section.offset = -section.offset);
        self
    }

    /// What is tied at junctions, in words.
    pub fn tied(&self) -> String {
        let Junctions { branches, folds } = self.junctions;
        let particles = self.joined.iter().map(Vec::len).sum();
        let kinds = [(branches, "edge", " of three faces and more"), (folds, "fold", "")];
        let kinds: Vec<String> =
            kinds.into_iter().filter(|k| k.0 > 0).map(|(n, what, more)| counted(n, what) + more).collect();
        format!(
            "{}: {} tied at {}",
            kinds.join(", "),
            counted(particles, "particle"),
            counted(self.joined.len(), "place")
        )
    }

    /// Normals of the file, or area-weighted means over the faces (any length).
    pub fn node_normals(&self) -> Vec<Vec3> {
        self.normals.clone().unwrap_or_else(|| mean_normals(&self.positions, &self.faces))
    }

    /// The cloud: particles at the nodes, triangles joined in pairs; `normals` as of [`Surface::node_normals`].
    ///
    /// # Errors
    /// [`MeshError`] for what the cloud refuses, with the nodes named as in the file.
    pub fn cloud(&self, normals: Vec<Vec3>) -> Result<(Cloud, Cells), MeshError> {
        let all_alike = vec![0; self.faces.len()];
        self.cloud_of_kinds(normals, &all_alike).map(|(cloud, cells, _)| (cloud, cells))
    }

    /// The same with triangles joined only to those of their kind, so that groups of faces stay groups of cells; with the kind
    /// of every cell. `kinds` has an entry a face.
    ///
    /// # Errors
    /// As [`Surface::cloud`].
    pub fn cloud_of_kinds(
        &self,
        normals: Vec<Vec3>,
        kinds: &[u32],
    ) -> Result<(Cloud, Cells, Vec<u32>), MeshError> {
        if self.faces.is_empty() {
            let frames = normals.into_iter().map(Frame::from_normal).collect();
            let cloud = Cloud {
                positions: self.positions.clone(),
                frames,
                areas: self.areas.clone(),
                edge_normals: vec![Vec3::zeros(); self.positions.len()],
                edge_lengths: vec![0.0; self.positions.len()],
                cells: Vec::new(),
                joined: Vec::new(),
                sides: None,
                lattice: None,
            };
            cloud.check().map_err(|error| self.refusal(&error))?;
            return Ok((cloud, Cells::default(), Vec::new()));
        }
        let (cells, counts) = self.cells(kinds);
        let (cells, kinds) = cells.into_iter().unzip();
        let cloud = Cloud::from_sheets(self.positions.clone(), Some(normals), cells, self.joined.clone());
        cloud.map(|cloud| (cloud, counts, kinds)).map_err(|error| self.refusal(&error))
    }

    /// The cells of the cloud, each with its kind: quadrangles, and triangles joined in pairs of one kind.
    fn cells(&self, kinds: &[u32]) -> (Vec<(Cell, u32)>, Cells) {
        let faces = self.faces.iter().copied().zip(kinds.iter().copied());
        let (triangles, whole): (Vec<_>, Vec<_>) = faces.partition(|(face, _)| face.count == 3);
        let quadrangles = whole.len();
        let mut cells = Vec::with_capacity(quadrangles);
        for (face, kind) in whole {
            match shape(&face, &self.positions) {
                Shape::Hollow(halves) => cells.extend(halves.map(|half| (half, kind))),
                _ => cells.push((face, kind)),
            }
        }
        let of_quadrangles = cells.len();
        let mut of_kinds: BTreeMap<u32, Vec<[u32; 3]>> = BTreeMap::new();
        for (Cell { corners: [a, b, c, _], .. }, kind) in &triangles {
            of_kinds.entry(*kind).or_default().push([*a, *b, *c]);
        }
        for (kind, corners) in of_kinds {
            cells.extend(pair_triangles(&self.positions, &corners).into_iter().map(|cell| (cell, kind)));
        }
        let joined = triangles.len() - (cells.len() - of_quadrangles);
        let cut = of_quadrangles - quadrangles;
        let counts = Cells { quadrangles, cut, triangles: triangles.len(), joined };
        // In the order of the particles: a step then sweeps both together.
        cells.sort_by_key(|(cell, _)| cell.particles().iter().copied().min());
        (cells, counts)
    }
}

/// Leaves out nodes that no face uses.
fn drop_unused(raw: &mut Raw) {
    let mut new = vec![None; raw.positions.len()];
    for &node in raw.faces.iter().flat_map(|face| face.cell.particles()) {
        new[node as usize] = Some(0);
    }
    for (number, slot) in (0..).zip(new.iter_mut().flatten()) {
        *slot = number;
    }
    let unused = new.iter().filter(|slot| slot.is_none()).count();
    if unused == 0 {
        return;
    }
    renumber(raw, &new, new.len() - unused);
    raw.notes.push(format!("nodes that no face uses, left out: {unused}"));
}

/// Normals of the file if it gives all of them; refuses one that points away from the faces.
fn given_normals(raw: &mut Raw, faces: &[Cell]) -> Result<Option<Vec<Vec3>>, MeshError> {
    let nodes = 0..raw.positions.len() as u32;
    let given: Vec<Vec3> = nodes.filter_map(|node| raw.normals.get(&node).copied()).collect();
    if given.len() < raw.positions.len() {
        if !given.is_empty() {
            let note = format!(
                "normals of the file left out: only {} of {} nodes have one",
                given.len(),
                raw.positions.len()
            );
            raw.notes.push(note);
        }
        return Ok(None);
    }
    let means = mean_normals(&raw.positions, faces);
    for (node, (normal, mean)) in (0..).zip(given.iter().zip(&means)) {
        // Units first: the squares of small or large components leave the range of numbers.
        let along = normal.try_normalize(0.0).map(|unit| unit.dot(mean));
        if !along.is_some_and(|along| along > 0.0 || faces.is_empty()) {
            let what = format!("the normal of {} does not point along those of its faces", raw.name(node));
            let repair = "turn it round, or leave the normals out of the file";
            return Err(MeshError::at(raw.line_at(node), what, repair));
        }
    }
    Ok(Some(given))
}

/// Sums of the area vectors of the faces at each node `[L²]`.
fn mean_normals(positions: &[Vec3], faces: &[Cell]) -> Vec<Vec3> {
    let mut normals = vec![Vec3::zeros(); positions.len()];
    for face in faces {
        let geometry = face.geometry(positions);
        for &node in face.particles() {
            normals[node as usize] += geometry.area * geometry.normal;
        }
    }
    normals
}
