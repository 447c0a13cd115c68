//! Nodes and background cells of a solid, straight or bent, or in a surface from a file.

use sph_core::{Block, BlockLattice, Cell, FilledCells, Hexahedra, Vec3};

use crate::bodies::refusal::body_error;
use crate::bodies::solid::skin::{Skin, filled_cells};
use crate::scene::SolidScene;
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::error::SceneError;

/// Nodes and background cells; corner and node of one number stand at one place, but for the disorder of nodes and the cells that a surface
/// cuts.
pub(super) struct Places {
    /// The lattice, straight; round a surface the box with the spacing of the nodes.
    pub lattice: BlockLattice,
    /// Nodes in space, with those on each face and the volumes of the straight lattice.
    pub block: Block,
    /// The nodes of the straight lattice \[L\].
    pub straight: Vec<Vec3>,
    /// Background cells in space.
    pub cells: Hexahedra,
    /// Their corners in the straight lattice \[L\].
    pub even: Vec<Vec3>,
    /// The surface that nodes fill, with its cells.
    pub filled: Option<(FilledCells, Skin)>,
}

impl Places {
    /// The nodes and cells of a checked scene.
    ///
    /// # Errors
    /// [`SceneError::Model`] for what the lattice refuses.
    pub fn new(scene: &BodyInScene<'_>, solid: &SolidScene, rule: usize) -> Result<Self, SceneError> {
        if let Some(surface) = &solid.geometry.filled {
            let (filled, skin) = filled_cells(scene, surface, rule)?;
            let block = filled.block.clone();
            let straight = block.positions.clone();
            let (corners, cells) = (straight.clone(), filled.cells.clone());
            let cells = Hexahedra { corners, cells, ..Hexahedra::default() };
            let (lattice, filled) = (filled.bounds.clone(), Some((filled, skin)));
            return Ok(Self { lattice, block, straight, cells, even: Vec::new(), filled });
        }
        let refusal = |error: &dyn std::fmt::Display| body_error(scene, "geometry", &error.to_string());
        let lattice = solid.lattice();
        let mut block = lattice.block().map_err(|error| refusal(&error))?;
        let lattice_nodes =
            BlockLattice { disorder: 0.0, ..lattice.clone() }.block().map_err(|error| refusal(&error))?;
        let [_, ny, nz] = lattice.cells().map_err(|error| refusal(&error))?.map(|cells| cells + 1);
        let plane = |axis: usize, stride: usize, count: usize| {
            (0..count).map(|i| lattice_nodes.positions[i * stride][axis]).collect::<Vec<f64>>()
        };
        let nx = lattice_nodes.len() / (ny * nz);
        let planes = [plane(0, ny * nz, nx), plane(1, nz, ny), plane(2, 1, nz)];
        let mut cells = Hexahedra::between(&planes).map_err(|error| refusal(&error))?;
        let (straight, even) = (block.positions.clone(), cells.corners.clone());
        if let Some(arc) = &solid.geometry.arc {
            block.positions.iter_mut().chain(&mut cells.corners).for_each(|x| *x = arc.bent(x));
        }
        Ok(Self { lattice, block, straight, cells, even, filled: None })
    }

    /// The outer faces, as quadrangles between nodes.
    pub fn outer(&self) -> Vec<Cell> {
        if let Some((filled, _)) = &self.filled {
            return filled.outer.clone();
        }
        self.cells.faces.iter().flatten().map(|&corners| Cell::quadrangle(corners)).collect()
    }

    /// Cells that are shown, the first of all: those half empty have no corners of their own.
    pub fn shown(&self) -> usize {
        self.filled.as_ref().map_or(self.cells.cells.len(), |(filled, _)| filled.half_full)
    }

    /// The surface that nodes fill.
    pub fn skin(&self) -> Option<&Skin> {
        self.filled.as_ref().map(|(_, skin)| skin)
    }
}
