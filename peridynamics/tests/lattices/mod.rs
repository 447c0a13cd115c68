//! Lattices of nodes, and bodies on them, for the tests of this crate.
#![allow(dead_code)] // each test is a crate of its own and uses a part of this

use peridynamics::{
    Correction, Elastic, Formulation, Idealisation, Influence, Law, Parts, Solid, Space, Volumes,
};
use sph_core::{Block, Vec3};

/// A lattice of cell centres: `counts` of nodes along each axis, one across a plane, the corner of the first cell at zero.
pub fn lattice(dimensions: usize, counts: [usize; 3], spacing: [f64; 3]) -> Block {
    let mut block = Block { dimensions, spacing, ..Block::default() };
    for i in 0..counts[0] {
        for j in 0..counts[1] {
            for k in 0..counts[2] {
                let centre = |n: usize, dx: f64| (n as f64 + 0.5) * dx;
                let z = if dimensions == 3 { centre(k, spacing[2]) } else { 0.0 };
                block.positions.push(Vec3::new(centre(i, spacing[0]), centre(j, spacing[1]), z));
                block.volumes.push(spacing.iter().product());
            }
        }
    }
    block
}

/// A plane lattice of unit thickness.
pub fn plane(counts: [usize; 2], spacing: f64) -> Block {
    lattice(2, [counts[0], counts[1], 1], [spacing, spacing, 1.0])
}

/// A formulation of horizon 3.015 with corrected weights.
pub fn formulation(space: Space, law: Law) -> Formulation {
    Formulation {
        space,
        law,
        horizon: 3.015,
        volumes: Volumes::Partial,
        influence: Influence::Inverse,
        correction: Correction::Even,
    }
}

/// A body without supports and loads.
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

/// Poisson's ratio of a law in a space: that of pairwise forces, and another where the law allows it.
pub fn poisson(space: Space, law: Law) -> f64 {
    if law == Law::BondBased { space.pairwise_poisson() } else { 0.3 }
}

/// Displaces all nodes by a field of their places at rest.
pub fn displace(body: &mut Solid, mut field: impl FnMut(Vec3) -> Vec3) {
    for node in 0..body.len() {
        let x = body.block().positions[node];
        body.put(node, x + field(x));
    }
}

/// All pairs of law and space.
pub const ALL: [(Space, Law); 6] = [
    (Space::Solid, Law::BondBased),
    (Space::Solid, Law::StateBased),
    (Space::PlaneStress, Law::BondBased),
    (Space::PlaneStress, Law::StateBased),
    (Space::PlaneStrain, Law::BondBased),
    (Space::PlaneStrain, Law::StateBased),
];

/// Numbers of (−1, 1) that are the same on every machine (SplitMix64 of \[steele2014\]).
pub struct Random(pub u64);

impl Random {
    /// The next number.
    pub fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^= z >> 31;
        (z >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    /// A vector in a space of two or three dimensions.
    pub fn vector(&mut self, dimensions: usize) -> Vec3 {
        let [x, y, z] = [self.next(), self.next(), self.next()];
        Vec3::new(x, y, if dimensions == 3 { z } else { 0.0 })
    }
}
