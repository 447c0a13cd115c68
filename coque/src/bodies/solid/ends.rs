//! How far a loaded face moves beyond the strain of what lies behind it: bonds are missing there.
//!
//! A strip four horizons long and as wide as two, of the bonds of the body in a plane, is pulled at one end by the tractions of a uniform
//! stress; a plane of symmetry is its other end. What the end moves beyond the strain of an elastic strip, in spacings of that
//! strain, is found at the price of some hundred nodes. In space it is about the same: 2.1 for 2.0 at a horizon of three spacings.

use explicit_dynamics::Amplitude;
use implicit_statics::{Equilibrium, linear_response};
use peridynamics::{
    AppliedLoad, Elastic, Formulation, Idealisation, Mirror, Parts, Solid, Space, StaticSolid, Support,
    Supported,
};
use sph_core::{BlockLattice, Vec3};

use super::parts::{carrier, material};
use crate::scene::SolidScene;

/// Strain of the strip: so small that its answer is linear.
const SMALL: f64 = 1e-8;

/// What a loaded face moves too far, in spacings times the strain behind it; nothing without bonds between nodes.
pub(super) fn excess(body: &SolidScene, lattice: &BlockLattice) -> Option<f64> {
    let Idealisation::Bonds(bonds) = carrier(body, lattice) else { return None };
    let space = if bonds.space == Space::PlaneStrain { Space::PlaneStrain } else { Space::PlaneStress };
    let poisson = bonds.law.poisson(space, material(body).poisson);
    let young = if space == Space::PlaneStrain { 1.0 - poisson * poisson } else { 1.0 };
    let reach = libm::ceil(bonds.horizon + 0.5);
    let lattice = BlockLattice {
        dimensions: 2,
        lengths: [4.0 * reach, 2.0 * reach, 1.0],
        spacing: [1.0; 3],
        origin: Vec3::zeros(),
        grading: [1.0; 3],
        disorder: 0.0,
        ..lattice.clone()
    };
    let block = lattice.block().ok()?;
    let end = block.faces[1].clone();
    let load = |&(node, area): &(u32, f64)| (node, Vec3::x() * (area * SMALL));
    let still = Support::Held { displacement: vec![Vec3::y()], director: Vec::new() };
    let parts = Parts {
        block,
        material: Elastic { young, poisson, density: 1.0 },
        formulation: Idealisation::Bonds(Formulation { space, ..bonds }),
        plastic: None,
        fracture: None,
        cracks: Vec::new(),
        contact: None,
        supports: vec![Supported { nodes: vec![0], support: still }],
        loads: vec![AppliedLoad { forces: end.iter().map(load).collect(), amplitude: Amplitude::Constant }],
        threads: 1,
    };
    let solid = Solid::mirrored(parts, &[Mirror { axis: 0, at: 0.0 }]).ok()?;
    let mut system = StaticSolid::new(solid);
    let answer = linear_response(&mut system, 0.0).ok()?;
    system.update(&answer);
    let solid = system.solid();
    let beyond = |&(node, _): &(u32, f64)| {
        let node = node as usize;
        solid.displacement(node).x / SMALL - solid.block().positions[node].x
    };
    Some(end.iter().map(beyond).sum::<f64>() / end.len() as f64)
}
