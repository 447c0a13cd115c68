//! Plates of two sheets for tests: their blocks, parts and supports.
#![allow(dead_code)] // each test binary uses its own part
#![allow(clippy::unwrap_used)] // a test may stop where it stands

use peridynamics::{
    Correction, Elastic, Formulation, Idealisation, Influence, Law, Parts, Sheets, Solid, Space, Support,
    Supported, Volumes,
};
use sph_core::{Block, BlockLattice, NodePlaces, Vec3};

/// Aluminium in millimetres, newtons and milliseconds.
pub const ALUMINIUM: Elastic = Elastic { young: 69_000.0, poisson: 0.33, density: 2.7e-3 };

/// Columns on the edges, with half and quarter areas there.
pub fn lattice(lengths: [f64; 2], thickness: f64, spacing: f64) -> BlockLattice {
    BlockLattice {
        dimensions: 2,
        lengths: [lengths[0], lengths[1], thickness],
        spacing: [spacing, spacing, thickness],
        origin: Vec3::zeros(),
        nodes: NodePlaces::Edges,
        grading: [1.0; 3],
        disorder: 0.0,
        seed: 1,
    }
}

pub fn block(lengths: [f64; 2], thickness: f64, spacing: f64) -> Block {
    lattice(lengths, thickness, spacing).block().unwrap()
}

pub fn formulation(law: Law) -> Formulation {
    Formulation {
        space: Space::PlaneStress,
        law,
        horizon: 1.5,
        volumes: Volumes::Partial,
        influence: Influence::Inverse,
        correction: Correction::Even,
    }
}

pub fn parts(block: Block, material: Elastic) -> Parts {
    let thickness = block.spacing[2];
    Parts {
        block,
        material,
        formulation: Idealisation::Sheets(Sheets { thickness, formulation: formulation(Law::StateBased) }),
        plastic: None,
        fracture: None,
        cracks: Vec::new(),
        contact: None,
        supports: Vec::new(),
        loads: Vec::new(),
        threads: 1,
    }
}

/// A plate of aluminium without supports.
pub fn free(lengths: [f64; 2], thickness: f64, spacing: f64) -> Solid {
    Solid::new(parts(block(lengths, thickness, spacing), ALUMINIUM)).unwrap()
}

/// Puts every column where a map of its place at rest has it: its place and its director.
pub fn put(solid: &mut Solid, map: impl Fn(Vec3) -> (Vec3, Vec3)) {
    for node in 0..solid.len() {
        let (place, director) = map(solid.block().positions[node]);
        solid.put(node, place);
        solid.set_director(node, director);
    }
}

/// Numbers in [-1, 1], the same every time.
pub fn noise(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed;
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// All places and directors at random about rest.
pub fn shake(solid: &mut Solid, size: f64, seed: u64) {
    let mut noise = noise(seed);
    let spacing = solid.block().greatest_spacing();
    for node in 0..solid.len() {
        let u = Vec3::from_fn(|_, _| noise()) * (size * spacing);
        let d = Vec3::from_fn(|_, _| noise()) * size;
        let (place, director) = (solid.position(node) + u, solid.director(node).unwrap() + d);
        solid.put(node, place);
        solid.set_director(node, director);
    }
}

/// A hard hinge on the four edges of a plate: no deflection, no director along the edge.
pub fn hinged(block: &Block) -> Vec<Supported> {
    let on = |face: usize| block.faces[face].iter().map(|&(node, _)| node).collect::<Vec<u32>>();
    let hinge = |face: usize, along: Vec3| Supported {
        nodes: on(face),
        support: Support::Held { displacement: vec![Vec3::z()], director: vec![along] },
    };
    vec![hinge(0, Vec3::y()), hinge(1, Vec3::y()), hinge(2, Vec3::x()), hinge(3, Vec3::x())]
}
