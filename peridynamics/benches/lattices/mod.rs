//! Blocks of nodes in slow motion, for the benches of this crate.
#![allow(dead_code)] // each bench is a crate of its own and uses a part of this

use peridynamics::{
    Correction, Elastic, Formulation, Idealisation, Influence, Law, Parts, Plastic, Solid, Space, Volumes,
};
use sph_core::{Block, Vec3};

/// Spacing of nodes.
pub const SPACING: f64 = 0.01;

/// A block of nodes, one layer of them a plane; z is the slowest to count, as in other codes.
pub fn block(counts: [usize; 3]) -> Block {
    let dimensions = if counts[2] == 1 { 2 } else { 3 };
    let mut out = Block { dimensions, spacing: [SPACING; 3], ..Block::default() };
    for k in 0..counts[2] {
        for j in 0..counts[1] {
            for i in 0..counts[0] {
                out.positions.push(Vec3::new(i as f64, j as f64, k as f64) * SPACING);
                out.volumes.push(SPACING.powi(3));
            }
        }
    }
    out
}

/// A free block of horizon 3.015 without partial volumes, slowly turning and stretching.
pub fn body(counts: [usize; 3], law: Law, threads: usize) -> Solid {
    yielding(counts, (law, Correction::None, None), threads)
}

/// The same with other weights, of bonds that may yield.
pub fn yielding(counts: [usize; 3], of: (Law, Correction, Option<Plastic>), threads: usize) -> Solid {
    moving(parts(counts, of, threads))
}

/// What it is made of.
pub fn parts(
    counts: [usize; 3],
    (law, correction, plastic): (Law, Correction, Option<Plastic>),
    threads: usize,
) -> Parts {
    let space = if counts[2] == 1 { Space::PlaneStress } else { Space::Solid };
    let poisson = if law == Law::BondBased { space.pairwise_poisson() } else { 0.3 };
    Parts {
        block: block(counts),
        material: Elastic { young: 1e6, poisson, density: 1.0 },
        formulation: Idealisation::Bonds(Formulation {
            space,
            law,
            horizon: 3.015,
            volumes: Volumes::Whole,
            influence: Influence::Constant,
            correction,
        }),
        plastic,
        fracture: None,
        cracks: Vec::new(),
        contact: None,
        supports: Vec::new(),
        loads: Vec::new(),
        threads,
    }
}

/// A body in motion.
pub fn moving(parts: Parts) -> Solid {
    let mut out = Solid::new(parts).expect("a sound body");
    let plane = out.block().dimensions == 2;
    for node in 0..out.len() {
        let x = out.position(node);
        let across = if plane { 0.0 } else { x.x * x.z };
        out.set_velocity(node, Vec3::new(x.y + x.x, -x.x, across));
    }
    out
}

/// A law's name in tables.
pub fn name(law: Law) -> &'static str {
    if law == Law::BondBased { "pmb" } else { "lps" }
}
