//! The lattice of nodes that a solid asks for.

use sph_core::{BlockLattice, Vec3};

use super::SolidScene;
use super::geometry::{Arc, Block, NodePlaces};

impl SolidScene {
    /// The lattice of its nodes; of an arc that of the straight block that is bent to it, the middle surface at z = 0.
    pub(crate) fn lattice(&self) -> BlockLattice {
        match (&self.geometry.block, self.geometry.arc) {
            (Some(block), _) => self.lattice_of(block),
            // The checks leave an arc.
            (None, arc) => arc.map_or_else(empty, |arc| arc.straight()),
        }
    }

    fn lattice_of(&self, block: &Block) -> BlockLattice {
        let Block { lengths, spacing, origin, thickness, nodes, grading, disorder } = block;
        let origin = |axis: usize| origin.as_ref().and_then(|list| list.get(axis)).copied().unwrap_or(0.0);
        let grading = |axis: usize| grading.as_ref().and_then(|list| list.get(axis)).map_or(1.0, |g| g.get());
        let across = thickness.map_or(1.0, |thickness| thickness.get());
        let on_faces = self.has_directors() || self.galerkin().is_some();
        let usual = if on_faces { NodePlaces::Edges } else { NodePlaces::Centres };
        BlockLattice {
            dimensions: lengths.len(),
            lengths: [0, 1, 2].map(|axis| lengths.get(axis).map_or(across, |length| length.get())),
            spacing: [0, 1, 2].map(|axis| spacing.along(axis)),
            origin: Vec3::from([0, 1, 2].map(origin)),
            nodes: match nodes.unwrap_or(usual) {
                NodePlaces::Centres => sph_core::NodePlaces::Centres,
                NodePlaces::Edges => sph_core::NodePlaces::Edges,
            },
            grading: [0, 1, 2].map(grading),
            disorder: disorder.map_or(0.0, |disorder| disorder.fraction.get()),
            seed: disorder.map_or(0, |disorder| disorder.seed),
        }
    }
}

impl Arc {
    /// The straight block that is bent to it.
    fn straight(&self) -> BlockLattice {
        let [first, last] = self.angles.map(f64::to_radians);
        let lengths = [self.radius.get() * (last - first), self.length.get(), self.thickness.get()];
        BlockLattice {
            lengths,
            spacing: [0, 1, 2].map(|axis| lengths[axis] / self.cells[axis] as f64),
            origin: Vec3::new(self.radius.get() * first, 0.0, -0.5 * self.thickness.get()),
            nodes: sph_core::NodePlaces::Edges,
            ..empty()
        }
    }

    /// The place of a point of the straight block.
    pub(crate) fn bent(&self, x: &Vec3) -> Vec3 {
        let (angle, radius) = (x.x / self.radius.get(), self.radius.get() + x.z);
        Vec3::new(radius * libm::sin(angle), x.y, radius * libm::cos(angle))
    }
}

/// A lattice without extent.
fn empty() -> BlockLattice {
    BlockLattice {
        dimensions: 3,
        lengths: [0.0; 3],
        spacing: [0.0; 3],
        origin: Vec3::zeros(),
        nodes: sph_core::NodePlaces::Centres,
        grading: [1.0; 3],
        disorder: 0.0,
        seed: 0,
    }
}
