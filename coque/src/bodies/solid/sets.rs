//! Named sets of nodes: all of them, the faces of the block, parts of a surface that they fill, layers under faces, regions.

use std::collections::BTreeMap;

use sph_core::{Block, BlockLattice, Carried, Facet, Vec3};

use super::skin::Skin;
use crate::bodies::sets::{Declared, inside};
use crate::scene::Region;
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::error::SceneError;
use crate::scene::sets::OF_SOLIDS;
use crate::scene::source::suggest;

/// The sets of a solid, by name.
pub(in crate::bodies) struct NodeSets<'a> {
    scene: &'a BodyInScene<'a>,
    lattice: &'a BlockLattice,
    block: &'a Block,
    /// Nodes in the frame of the lattice \[L\]: an arc is that of a straight block.
    straight: &'a [Vec3],
    /// The surface that the nodes fill.
    skin: Option<&'a Skin>,
    members: BTreeMap<String, Vec<u32>>,
}

impl<'a> NodeSets<'a> {
    /// Finds every set that the scene declares, and those that every solid has.
    ///
    /// # Errors
    /// [`SceneError::Set`] for a declared set without nodes.
    pub fn find(
        scene: &'a BodyInScene<'a>,
        lattice: &'a BlockLattice,
        block: &'a Block,
        straight: &'a [Vec3],
        skin: Option<&'a Skin>,
    ) -> Result<Self, SceneError> {
        let mut out = Self { scene, lattice, block, straight, skin, members: BTreeMap::new() };
        out.members.insert(OF_SOLIDS[0].into(), (0..block.len() as u32).collect());
        for (name, face) in OF_SOLIDS[1..].iter().zip(&block.faces) {
            out.members.insert((*name).into(), face.iter().map(|&(node, _)| node).collect());
        }
        out.members.extend(skin.into_iter().flat_map(Skin::sets));
        let own = |path: &str, name: &str| out.at(path, name).map(<[u32]>::to_vec);
        let pick = |region: &Region| match &region.layer {
            Some(layer) => out.layer(&layer.face, layer.depth.get()),
            None => inside(region, &block.positions, block.greatest_spacing()),
        };
        let declared = Declared { scene, positions: &block.positions, own: &own, pick: &pick }.all()?;
        if let Some(name) = declared.keys().find(|name| skin.is_some_and(|skin| skin.names(name))) {
            let bound = "another name: the file has a group that is called so";
            let repair = "rename the set, or leave it out and use the group";
            return Err(SceneError::Set(scene.source.fault(&format!("sets.{name}"), name, bound, repair)));
        }
        out.members.extend(declared);
        Ok(out)
    }

    /// All sets by name.
    pub fn into_members(self) -> BTreeMap<String, Vec<u32>> {
        self.members
    }

    /// The scene that names them.
    pub fn scene(&self) -> &'a BodyInScene<'a> {
        self.scene
    }

    /// Nodes of the set that the scene names at `path`.
    ///
    /// # Errors
    /// [`SceneError::Set`] for a face all of whose nodes are cut out, and for a name that neither the scene nor the file of the surface has.
    pub fn at(&self, path: &str, name: &str) -> Result<&[u32], SceneError> {
        // The checks let no other name through, but where a file has names of its own.
        let nodes = self.members.get(name).map_or(&[][..], Vec::as_slice);
        if !nodes.is_empty() {
            return Ok(nodes);
        }
        let (bound, repair) = match (self.skin, self.members.contains_key(name)) {
            (None, _) => (
                "but all nodes of this face are cut out",
                "cut less out of the block, or use another set".into(),
            ),
            (Some(_), true) => (
                "but nothing of the surface lies in this plane of the box round it",
                "use `surface`, a group of the file or a region".into(),
            ),
            (Some(_), false) => {
                let known: Vec<&str> = self
                    .members
                    .iter()
                    .filter(|(_, nodes)| !nodes.is_empty())
                    .map(|(name, _)| name.as_str())
                    .collect();
                ("which is no set of this surface", suggest(name, &known))
            }
        };
        Err(SceneError::Set(self.scene.source.fault(path, &format!("\"{name}\""), bound, &repair)))
    }

    /// The nodes on a face with their shares of its area \[L²\].
    pub fn face(&self, name: &str) -> &[(u32, f64)] {
        let number = OF_SOLIDS[1..].iter().position(|known| *known == name);
        number.map_or(&[], |number| &self.block.faces[number])
    }

    /// The nodes on all faces with their shares of the area \[L²\].
    pub fn outside(&self) -> impl Iterator<Item = (u32, f64)> {
        self.block.faces[..2 * self.block.dimensions].iter().flatten().copied()
    }

    /// The part of the surface that the nodes fill, by the name of a set; none of a block.
    pub fn facets(&self, name: &str, nodes: &[u32], planes: &[(usize, f64)]) -> Option<Vec<Facet>> {
        self.skin.map(|skin| skin.facets(name, nodes, planes))
    }

    /// The same as the nodes carry it.
    pub fn carried(&self, name: &str) -> Option<Carried> {
        self.skin.and_then(|skin| skin.carried(self.block, name))
    }

    /// Whether a part of the surface has this name; true of a solid without a surface.
    pub fn names(&self, name: &str) -> bool {
        self.skin.is_none_or(|skin| skin.names(name))
    }

    /// The nodes within a depth of a face of the block.
    pub fn layer(&self, face: &str, depth: f64) -> Vec<u32> {
        let number = OF_SOLIDS[1..].iter().position(|known| *known == face).unwrap_or_default();
        let axis = number / 2;
        let low = self.lattice.origin[axis];
        let high = low + self.lattice.lengths[axis];
        // A node at the depth belongs to the layer, whatever rounding did to it.
        let reach = depth + 1e-9 * self.block.spacing[axis];
        let near = |x: f64| if number % 2 == 0 { x - low <= reach } else { high - x <= reach };
        let positions = self.straight.iter().enumerate();
        positions.filter(|(_, x)| near(x[axis])).map(|(node, _)| node as u32).collect()
    }
}
