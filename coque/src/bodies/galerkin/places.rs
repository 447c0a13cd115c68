//! Nodes and background cells of a solid, straight or bent.

use sph_core::{Block, BlockLattice, Cell, Hexahedra, Vec3};

use crate::bodies::solid::sets::NodeSets;
use crate::scene::error::SceneError;
use crate::scene::sets::OF_SOLIDS;
use crate::scene::{Scene, SolidScene};

/// Nodes and background cells; corner and node of one number stand at one place, but for the disorder of nodes.
pub(super) struct Places {
    /// The lattice, straight.
    pub lattice: BlockLattice,
    /// Nodes in space, with those on each face and the volumes of the straight lattice.
    pub block: Block,
    /// The nodes of the straight lattice \[L\].
    pub straight: Vec<Vec3>,
    /// Background cells in space.
    pub cells: Hexahedra,
}

impl Places {
    /// The nodes and cells of a checked scene.
    ///
    /// # Errors
    /// [`SceneError::Model`] for what the lattice refuses.
    pub fn new(scene: &Scene, solid: &SolidScene) -> Result<Self, SceneError> {
        let refusal = |error: &dyn std::fmt::Display| scene.body_error("geometry", &error.to_string());
        let lattice = solid.lattice();
        let mut block = lattice.block().map_err(|error| refusal(&error))?;
        let even =
            BlockLattice { disorder: 0.0, ..lattice.clone() }.block().map_err(|error| refusal(&error))?;
        let [_, ny, nz] = lattice.cells().map_err(|error| refusal(&error))?.map(|cells| cells + 1);
        let plane = |axis: usize, stride: usize, count: usize| {
            (0..count).map(|i| even.positions[i * stride][axis]).collect::<Vec<f64>>()
        };
        let nx = even.len() / (ny * nz);
        let planes = [plane(0, ny * nz, nx), plane(1, nz, ny), plane(2, 1, nz)];
        let mut cells = Hexahedra::between(&planes).map_err(|error| refusal(&error))?;
        let straight = block.positions.clone();
        if let Some(arc) = &solid.geometry.arc {
            block.positions.iter_mut().chain(&mut cells.corners).for_each(|x| *x = arc.bent(x));
        }
        Ok(Self { lattice, block, straight, cells })
    }

    /// Faces of cells on an outer face of the block, or on any of them with all corners in a set.
    pub fn faces(&self, sets: &NodeSets<'_>, path: &str, name: &str) -> Result<Vec<[u32; 4]>, SceneError> {
        if let Some(number) = OF_SOLIDS[1..].iter().position(|known| *known == name) {
            return Ok(self.cells.faces[number].clone());
        }
        let mut members = vec![false; self.block.len()];
        sets.at(path, name)?.iter().for_each(|&node| members[node as usize] = true);
        let whole = |face: &&[u32; 4]| face.iter().all(|&corner| members[corner as usize]);
        let faces: Vec<[u32; 4]> = self.cells.faces.iter().flatten().filter(whole).copied().collect();
        if !faces.is_empty() {
            return Ok(faces);
        }
        let bound = "but it holds no whole face of a cell on the outside";
        let repair = "let it hold all four nodes of at least one outer face, or use `force`";
        Err(SceneError::Set(sets.scene().source.fault(path, &format!("\"{name}\""), bound, repair)))
    }

    /// The outer faces, as quadrangles between nodes.
    pub fn outer(&self) -> Vec<Cell> {
        self.cells.faces.iter().flatten().map(|&corners| Cell::quadrangle(corners)).collect()
    }
}
