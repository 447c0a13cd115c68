//! Blocks and formulations that the cases share.

use explicit_dynamics::Amplitude;
use peridynamics::{
    AppliedLoad, Correction, Elastic, Formulation, Idealisation, Influence, Law, Parts, Space, Support,
    Supported, Volumes,
};
use sph_core::{Block, BlockLattice, NodePlaces, Vec3};

/// A formulation with the horizon of 3.015 spacings, partial volumes and the influence 1/r.
pub fn formulation(space: Space, law: Law, correction: Correction) -> Formulation {
    let (volumes, influence) = (Volumes::Partial, Influence::Inverse);
    Formulation { space, law, horizon: 3.015, volumes, influence, correction }
}

/// A box of nodes at the centres of equal cells; of two dimensions where `lengths[2]` is a thickness.
pub fn lattice(dimensions: usize, origin: Vec3, lengths: [f64; 3], spacing: f64) -> BlockLattice {
    BlockLattice {
        dimensions,
        lengths,
        spacing: [spacing; 3],
        origin,
        nodes: NodePlaces::Centres,
        grading: [1.0; 3],
        disorder: 0.0,
        seed: 1,
    }
}

/// Numbers of the nodes at places of a kind.
pub fn nodes(block: &Block, here: impl Fn(&Vec3) -> bool) -> Vec<u32> {
    (0..block.len()).filter(|&a| here(&block.positions[a])).map(|a| a as u32).collect()
}

/// No displacement along directions.
pub fn held(nodes: Vec<u32>, displacement: &[Vec3]) -> Supported {
    Supported { nodes, support: Support::Held { displacement: displacement.to_vec(), director: Vec::new() } }
}

/// A displacement at level one.
pub fn moved(nodes: Vec<u32>, direction: Vec3, by: f64) -> Supported {
    Supported { nodes, support: Support::Moved { direction, by, amplitude: Amplitude::Constant } }
}

/// A force at level one, equal on all nodes of a set.
pub fn pulled(nodes: &[u32], total: Vec3) -> AppliedLoad {
    let share = total / nodes.len() as f64;
    AppliedLoad { forces: nodes.iter().map(|&a| (a, share)).collect(), amplitude: Amplitude::Constant }
}

/// A body without cracks or limits.
pub fn parts(block: Block, material: Elastic, formulation: Formulation) -> Parts {
    Parts {
        block,
        material,
        formulation: Idealisation::Bonds(formulation),
        plastic: None,
        fracture: None,
        cracks: Vec::new(),
        contact: None,
        supports: Vec::new(),
        loads: Vec::new(),
        threads: 1,
    }
}
