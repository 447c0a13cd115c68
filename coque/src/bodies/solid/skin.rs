//! The surface of a solid whose nodes fill it: which parts of it have names, and what nodes bear of them.

use std::collections::{BTreeMap, BTreeSet};

use mesh_io::surface::Surface;
use sph_core::{Block, Carried, ClosedSurface, Facet, Filled, FilledCells, SurfaceFault, Vec3};

use crate::bodies::Identity;
use crate::bodies::from_file::{surface, triangles};
use crate::bodies::refusal::body_error;
use crate::scene::FilledSurface;
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::error::SceneError;
use crate::scene::sets::OF_FILLED;

/// Where the surface stands in the scene.
const KEY: &str = "geometry.filled";

/// Part of a body that may lie in fins and tips without nodes of their own.
const IN_FINS: f64 = 1e-3;

/// The surface of a solid.
#[derive(Clone, Debug)]
pub(in crate::bodies) struct Skin {
    surface: ClosedSurface,
    /// What nodes bear of it.
    facets: Vec<Facet>,
    /// Nodes with each triangle that they bear a part of, of shape functions with each that they lie on.
    bearers: Vec<(u32, u32)>,
    /// Which triangles belong to each part that has a name: groups of the file, and what lies in the planes of the box round it.
    parts: BTreeMap<String, Vec<bool>>,
    /// Part of the volume that nodes farther off bear, with a place of it.
    away: Option<(f64, Vec3)>,
    /// What it is, in words.
    pub described: String,
    pub identity: Identity,
}

/// The nodes of a solid of bonds that fill the surface that its scene names.
///
/// # Errors
/// [`SceneError::Mesh`] for a file that holds no sound surface, [`SceneError::Model`] for one that encloses no body.
pub(super) fn filled(scene: &BodyInScene<'_>, wanted: &FilledSurface) -> Result<(Filled, Skin), SceneError> {
    let read = read(scene, wanted)?;
    let filled = read.closed.filled(wanted.spacing.get()).map_err(|fault| refused(scene, &fault))?;
    let bearers = filled.facets.iter().map(|facet| (facet.node, facet.triangle)).collect();
    let parts = read.parts(scene, &filled.flat)?;
    let skin = read.skin(parts, (filled.facets.clone(), bearers, filled.away), "nodes fill it exactly");
    Ok((filled, skin))
}

/// The nodes of a Galerkin solid in the surface that its scene names, and the cells that it cuts.
///
/// # Errors
/// As of a solid of bonds.
pub(in crate::bodies) fn filled_cells(
    scene: &BodyInScene<'_>,
    wanted: &FilledSurface,
    rule: usize,
) -> Result<(FilledCells, Skin), SceneError> {
    let read = read(scene, wanted)?;
    let filled = read.closed.filled_cells(wanted.spacing.get(), rule);
    let filled = filled.map_err(|fault| refused(scene, &fault))?;
    let parts = read.parts(scene, &filled.flat)?;
    let of_surface = (filled.facets.clone(), filled.touching.clone(), filled.away);
    let skin = read.skin(parts, of_surface, "it cuts the cells over which integrals are taken");
    Ok((filled, skin))
}

/// What nodes bear of a surface: its facets, nodes with triangles, and what lies away from all of them with a place of it.
type OfSurface = (Vec<Facet>, Vec<(u32, u32)>, Option<(f64, Vec3)>);

/// A surface from a file.
struct Read {
    surface: Surface,
    identity: Identity,
    closed: ClosedSurface,
    /// The face of each triangle.
    faces: Vec<u32>,
}

fn read(scene: &BodyInScene<'_>, wanted: &FilledSurface) -> Result<Read, SceneError> {
    let (surface, identity) = surface(scene, &wanted.mesh(), KEY)?;
    let (triangles, faces) = triangles(&surface);
    let closed = ClosedSurface::new(surface.positions.clone(), triangles);
    let closed = closed.map_err(|fault| refused(scene, &fault))?;
    Ok(Read { surface, identity, closed, faces })
}

impl Read {
    /// Which triangles belong to each part that has a name.
    fn parts(
        &self,
        scene: &BodyInScene<'_>,
        flat: &[Vec<bool>; 6],
    ) -> Result<BTreeMap<String, Vec<bool>>, SceneError> {
        let (surface, faces) = (&self.surface, &self.faces);
        let mut parts = BTreeMap::new();
        for (name, of_group) in &surface.face_sets {
            if OF_FILLED.contains(&name.as_str()) {
                let value = format!(
                    "{}: a group is called {name}, which names another set of every solid",
                    surface.file
                );
                let bound = "another name";
                let fault =
                    scene.body_scope().fault(&format!("{KEY}.file"), &value, bound, "rename the group");
                return Err(SceneError::Mesh(fault));
            }
            let of_group: BTreeSet<u32> = of_group.iter().copied().collect();
            parts.insert(name.clone(), faces.iter().map(|face| of_group.contains(face)).collect());
        }
        for (name, flat) in OF_FILLED[1..7].iter().zip(flat) {
            parts.insert((*name).into(), flat.clone());
        }
        parts.insert(OF_FILLED[7].into(), vec![true; faces.len()]);
        Ok(parts)
    }

    fn skin(self, parts: BTreeMap<String, Vec<bool>>, (facets, bearers, away): OfSurface, how: &str) -> Skin {
        let (volume, centroid) = self.closed.volume();
        let area: f64 = facets.iter().map(|facet| facet.area.norm()).sum();
        let described = format!(
            "{} triangles of {} enclose a volume of {volume:.6e} round ({:.4e}, {:.4e}, {:.4e}), their area is {area:.6e}; {how}",
            self.faces.len(),
            self.surface.file,
            centroid.x,
            centroid.y,
            centroid.z,
        );
        Skin { surface: self.closed, facets, bearers, parts, away, described, identity: self.identity }
    }
}

fn refused(scene: &BodyInScene<'_>, fault: &SurfaceFault) -> SceneError {
    let key = match fault {
        SurfaceFault::Thin { .. } | SurfaceFault::Cells { .. } => "spacing",
        _ => "file",
    };
    body_error(scene, &format!("{KEY}.{key}"), &fault.to_string())
}

impl Skin {
    /// Nodes that bear a part of each part that has a name, ascending.
    pub fn sets(&self) -> impl Iterator<Item = (String, Vec<u32>)> + '_ {
        self.parts.iter().map(|(name, part)| {
            let of_part = self.bearers.iter().filter(|(_, triangle)| part[*triangle as usize]);
            let nodes: BTreeSet<u32> = of_part.map(|(node, _)| *node).collect();
            (name.clone(), nodes.into_iter().collect())
        })
    }

    /// The part of the surface that has this name, as the nodes of a block carry it; none where no part has.
    pub fn carried(&self, block: &Block, name: &str) -> Option<Carried> {
        let part = self.parts.get(name)?;
        let all = self.surface.carried(block, block.greatest_spacing());
        Some(all.only(|number| part[all.part_of[number] as usize]))
    }

    /// What of the body lies in fins without nodes, where that is much.
    pub fn thin_fins(&self) -> Option<String> {
        let (part, place) = self.away.filter(|(part, _)| *part > IN_FINS)?;
        Some(format!(
            "{:.2} % of the volume lies in fins or tips thinner than half a spacing, as at ({:.3e}, {:.3e}, {:.3e}), and goes to nodes up to three spacings \
             off: mass and loads are kept, the stiffness of the fin is not there; use a spacing below its thickness, or leave it out",
            100.0 * part,
            place.x,
            place.y,
            place.z
        ))
    }

    /// Whether a part has this name.
    pub fn names(&self, name: &str) -> bool {
        self.parts.contains_key(name)
    }

    /// The part of the surface that has this name, else what of it the nodes of a set bear. What lies in planes of symmetry, given by their
    /// axes and where they cut them \[L\], is a cut through the whole body and bears nothing, but where a face is named.
    pub fn facets(&self, name: &str, nodes: &[u32], planes: &[(usize, f64)]) -> Vec<Facet> {
        let held: BTreeSet<u32> = match self.parts.contains_key(name) {
            true => BTreeSet::new(),
            false => nodes.iter().copied().collect(),
        };
        let within = |facet: &&Facet| match self.parts.get(name) {
            Some(part) => part[facet.triangle as usize],
            None => held.contains(&facet.node),
        };
        let is_cut = |facet: &Facet| {
            let lies = |&(axis, at): &(usize, f64)| {
                let flat = OF_FILLED[1 + 2 * axis..3 + 2 * axis].iter();
                let flat = flat.filter_map(|face| self.parts.get(*face));
                flat.into_iter().any(|part| part[facet.triangle as usize])
                    && (facet.place[axis] - at).abs() < facet.area.norm().sqrt()
            };
            !OF_FILLED[1..7].contains(&name) && planes.iter().any(lies)
        };
        self.facets.iter().filter(within).filter(|facet| !is_cut(facet)).copied().collect()
    }
}
