//! Blocks of nodes: solids in a plane or in space.

mod cut_out;
mod enclosed;
mod hexahedra;
mod lattice;

pub use cut_out::CutOut;
pub use enclosed::{
    Carried, ClosedSurface, Facet, Filled, FilledCells, Spread, SurfaceFault, by_node, spread,
};
pub use hexahedra::{FacePoint, Hexahedra, HexahedraError, VolumePoint};
pub use lattice::{BlockLattice, NodePlaces};

use crate::Vec3;
use crate::surface::cell::Cell;

/// The nodes of a solid, each with a part of its volume.
#[derive(Clone, Debug, Default)]
pub struct Block {
    /// Dimensions, two (in the plane z = const) or three.
    pub dimensions: usize,
    /// Positions \[L\].
    pub positions: Vec<Vec3>,
    /// Volumes \[L³\]; in a plane area times thickness.
    pub volumes: Vec<f64>,
    /// Greatest spacing of nodes along each axis \[L\]; in a plane the last is the thickness.
    pub spacing: [f64; 3],
    /// Quadrangles between nodes of a plane lattice, for pictures; none in space.
    pub cells: Vec<Cell>,
    /// Nodes with their share \[L²\] of each face of the box round it: x0, x1, y0, y1, z0, z1. On a face of a lattice of
    /// cell centres lies the outermost row. Where it is plane all nodes lie on z0 and z1.
    pub faces: [Vec<(u32, f64)>; 6],
}

impl Block {
    /// Number of nodes.
    pub fn len(&self) -> usize {
        self.positions.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.positions.is_empty()
    }

    /// The greatest spacing in the directions that it extends in \[L\].
    pub fn greatest_spacing(&self) -> f64 {
        self.spacing[..self.dimensions].iter().fold(0.0, |most, &spacing| most.max(spacing))
    }
}
