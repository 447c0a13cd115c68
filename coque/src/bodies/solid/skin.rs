//! The surface of a solid whose nodes fill it: which parts of it have names, and what nodes bear of them.

use std::collections::{BTreeMap, BTreeSet};

use sph_core::{ClosedSurface, Facet, Filled, SurfaceFault, Vec3, by_node};

use crate::bodies::Identity;
use crate::bodies::from_file::{surface, triangles};
use crate::bodies::refusal::body_error;
use crate::scene::FilledSurface;
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::error::SceneError;
use crate::scene::sets::OF_FILLED;

/// Where the surface stands in the scene.
const KEY: &str = "geometry.filled";

/// The surface of a solid.
#[derive(Clone, Debug)]
pub(in crate::bodies) struct Skin {
    /// What nodes bear of it.
    facets: Vec<Facet>,
    /// Which triangles belong to each part that has a name: groups of the file, and what lies in the planes of the box round it.
    parts: BTreeMap<String, Vec<bool>>,
    /// Part of the volume that nodes farther off bear, with a place of it.
    pub away: Option<(f64, Vec3)>,
    /// What it is, in words.
    pub described: String,
    pub identity: Identity,
}

/// The nodes of a solid that fill the surface that its scene names.
///
/// # Errors
/// [`SceneError::Mesh`] for a file that holds no sound surface, [`SceneError::Model`] for one that encloses no body.
pub(super) fn filled(scene: &BodyInScene<'_>, wanted: &FilledSurface) -> Result<(Filled, Skin), SceneError> {
    let (surface, identity) = surface(scene, &wanted.mesh(), KEY)?;
    let (triangles, faces) = triangles(&surface);
    let closed = ClosedSurface::new(surface.positions.clone(), triangles);
    let closed = closed.map_err(|fault| refused(scene, &fault))?;
    let filled = closed.filled(wanted.spacing.get()).map_err(|fault| refused(scene, &fault))?;
    let (volume, centroid) = closed.volume();
    let area: f64 = filled.facets.iter().map(|facet| facet.area.norm()).sum();
    let described = format!(
        "{} triangles of {} enclose a volume of {volume:.6e} round ({:.4e}, {:.4e}, {:.4e}), their area is {area:.6e}; nodes fill it exactly",
        faces.len(),
        surface.file,
        centroid.x,
        centroid.y,
        centroid.z,
    );
    let mut parts = BTreeMap::new();
    for (name, of_group) in &surface.face_sets {
        if OF_FILLED.contains(&name.as_str()) {
            let value =
                format!("{}: a group is called {name}, which names another set of every solid", surface.file);
            let bound = "another name";
            let fault = scene.body_scope().fault(&format!("{KEY}.file"), &value, bound, "rename the group");
            return Err(SceneError::Mesh(fault));
        }
        let of_group: BTreeSet<u32> = of_group.iter().copied().collect();
        parts.insert(name.clone(), faces.iter().map(|face| of_group.contains(face)).collect());
    }
    for (name, flat) in OF_FILLED[1..7].iter().zip(&filled.flat) {
        parts.insert((*name).into(), flat.clone());
    }
    parts.insert(OF_FILLED[7].into(), vec![true; faces.len()]);
    let skin = Skin { facets: filled.facets.clone(), parts, away: filled.away, described, identity };
    Ok((filled, skin))
}

fn refused(scene: &BodyInScene<'_>, fault: &SurfaceFault) -> SceneError {
    let key = match fault {
        SurfaceFault::Thin { .. } | SurfaceFault::Cells { .. } => "spacing",
        _ => "file",
    };
    body_error(scene, &format!("{KEY}.{key}"), &fault.to_string())
}

impl Skin {
    /// Nodes that bear a part of each part that has a name.
    pub fn sets(&self) -> impl Iterator<Item = (String, Vec<u32>)> + '_ {
        self.parts.iter().map(|(name, part)| {
            let nodes = by_node(self.facets.iter().filter(|facet| part[facet.triangle as usize]));
            (name.clone(), nodes.into_iter().map(|(node, ..)| node).collect())
        })
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
