//! The plate, its supports, and what is read from it.

use explicit_dynamics::Amplitude;
use peridynamics::{
    Carrier, Correction, Elastic, Formulation, Influence, Law, Parts, Sheets, Solid, Space, StaticSolid,
    Support, Supported, Volumes,
};
use sph_core::{Block, BlockLattice, NodePlaces, Vec3};

/// Edges of the plate and its thickness \[mm\].
pub const LENGTHS: [f64; 3] = [300.0, 200.0, 2.0];
/// How far the ends are moved at level one \[mm\].
pub const WAY: f64 = 1.2;
/// Aluminium in millimetres, kilonewtons and milliseconds.
pub const ALUMINIUM: Elastic = Elastic { young: 69.0, poisson: 0.33, density: 2.7e-6 };

/// How the edges are held; all stay in the plane z = 0, and the ends move along x.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Edges {
    /// The sides and the breadth of the ends are free in their plane.
    Free,
    /// The ends keep their breadth.
    EndsKept,
    /// All edges keep their places across x.
    Held,
    /// The same, and the ends do not turn.
    Clamped,
}

/// Columns on the edges.
pub fn block(spacing: f64) -> Block {
    divided([spacing; 2])
}

/// The same with a spacing along each edge.
pub fn divided(spacing: [f64; 2]) -> Block {
    let lattice = BlockLattice {
        dimensions: 2,
        lengths: LENGTHS,
        spacing: [spacing[0], spacing[1], LENGTHS[2]],
        origin: Vec3::zeros(),
        nodes: NodePlaces::Edges,
        grading: [1.0; 3],
        disorder: 0.0,
        seed: 0,
    };
    lattice.block().expect("lengths and spacings are positive")
}

/// The supports of a plate whose end x = 300 moves by so much at level one.
pub fn supports(block: &Block, edges: Edges, way: f64) -> Vec<Supported> {
    let on = |face: usize| -> Vec<u32> { block.faces[face].iter().map(|&(node, _)| node).collect() };
    let held = |nodes: Vec<u32>, displacement: Vec<Vec3>, director: Vec<Vec3>| Supported {
        nodes,
        support: Support::Held { displacement, director },
    };
    let (x, y, z) = (Vec3::x(), Vec3::y(), Vec3::z());
    let ends = match edges {
        Edges::Clamped => vec![x, y, z],
        _ => vec![y],
    };
    let mut out = vec![held(on(0), vec![x, z], ends.clone()), held(on(1), vec![z], ends)];
    let sides = if matches!(edges, Edges::Held | Edges::Clamped) { vec![y, z] } else { vec![z] };
    out.extend([2, 3].map(|face| held(on(face), sides.clone(), vec![x])));
    match edges {
        Edges::Free => out.push(held(vec![0], vec![y], Vec::new())),
        _ => out.extend([0, 1].map(|face| held(on(face), vec![y], Vec::new()))),
    }
    let moved = Support::Moved { direction: x, by: way, amplitude: Amplitude::default() };
    out.push(Supported { nodes: on(1), support: moved });
    out
}

/// A plate of columns at the places of a block, whole.
pub fn parts(block: Block, supports: Vec<Supported>) -> Parts {
    let formulation = Formulation {
        space: Space::PlaneStress,
        law: Law::StateBased,
        horizon: 1.5,
        volumes: Volumes::Partial,
        influence: Influence::Inverse,
        correction: Correction::Even,
    };
    Parts {
        block,
        material: ALUMINIUM,
        formulation: Carrier::Sheets(Sheets { thickness: LENGTHS[2], formulation }),
        fracture: None,
        cracks: Vec::new(),
        contact: None,
        supports,
        loads: Vec::new(),
        threads: 2,
    }
}

/// The plate of these parts.
pub fn plate(parts: Parts) -> StaticSolid {
    StaticSolid::new(Solid::new(parts).expect("a sound plate"))
}

/// What the end x = 0 or, with 1, x = 300 bears along x \[kN\], for the forces last evaluated.
pub fn end_force(solid: &Solid, end: usize) -> f64 {
    solid.block().faces[end].iter().map(|&(node, _)| solid.reaction(node as usize).x).sum()
}

/// The node nearest to a place.
pub fn nearest(block: &Block, x: f64, y: f64) -> usize {
    let distance = |node: &usize| (block.positions[*node] - Vec3::new(x, y, 0.0)).norm();
    (0..block.len()).min_by(|a, b| distance(a).total_cmp(&distance(b))).expect("a block has nodes")
}

/// Half-waves of deflections along the middle of the plate: alternations between bumps of more than a twentieth of the largest.
pub fn half_waves(block: &Block, deflection: impl Fn(usize) -> f64) -> usize {
    let middle = block.positions[nearest(block, 0.0, 0.5 * LENGTHS[1])].y;
    let line: Vec<f64> = (0..block.len())
        .filter(|&node| (block.positions[node].y - middle).abs() < 1e-9)
        .map(deflection)
        .collect();
    let most = line.iter().fold(0.0_f64, |most, w| most.max(w.abs()));
    let bumps: Vec<bool> = line.iter().filter(|w| w.abs() > 0.05 * most).map(|&w| w > 0.0).collect();
    1 + bumps.windows(2).filter(|pair| pair[0] != pair[1]).count()
}
