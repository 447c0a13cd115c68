//! How stiff a member of few layers of nodes is in bending: bonds feel strains in their middle, an average over the horizon.
//!
//! A piece of the member, four horizons long and as many layers high, is put into the pure bending of a bar,
//!
//! ```text
//! u = −κxz      w = ½κ(x² + νz² − νy²)      v = νκyz
//! ```
//!
//! x along it, z across. What the nodes of its middle section hold, over `½ E I κ²`, is the stiffness over that of a bar: for
//! any formulation, horizon and correction, at the price of some thousand nodes.

use peridynamics::{Formulation, Idealisation, Parts, Solid, Space};
use sph_core::{BlockLattice, NodePlaces, Vec3};

use super::parts::{carrier, material};
use crate::scene::SolidScene;

/// Layers beyond which bending is not looked at: a horizon of three spacings takes 2 % there.
const MANY: usize = 24;
/// κ times the length of the piece: small, so that bonds do not feel that it turns.
const TURN: f64 = 1e-4;

/// Stiffness in bending across an axis over that of a bar; nothing for many layers, and where there are no bonds between nodes.
pub(super) fn stiffness(
    body: &SolidScene,
    lattice: &BlockLattice,
    [along, across]: [usize; 2],
) -> Option<f64> {
    let Idealisation::Bonds(bonds) = carrier(body, lattice) else { return None };
    let counts = lattice.cells().ok()?;
    if counts[across] > MANY {
        return None;
    }
    let piece = piece(lattice, &bonds, counts, [along, across]);
    let block = piece.block().ok()?;
    let material = material(body);
    // In plane strain the plane is that of a stiffer material.
    let (young, poisson) = match bonds.space {
        Space::PlaneStrain => {
            let nu = material.poisson;
            (material.young / (1.0 - nu * nu), nu / (1.0 - nu))
        }
        _ => (material.young, material.poisson),
    };
    let parts = Parts {
        block,
        material,
        formulation: Idealisation::Bonds(bonds),
        plastic: None,
        fracture: None,
        cracks: Vec::new(),
        contact: None,
        supports: Vec::new(),
        loads: Vec::new(),
        threads: 1,
    };
    let mut solid = Solid::new(parts).ok()?;
    let middle = Vec3::from_fn(|a, _| if a < piece.dimensions { 0.5 * piece.lengths[a] } else { 0.0 });
    let (beside, kappa) = (3 - along - across, TURN / piece.lengths[along]);
    let from_middle = |solid: &Solid, node: usize| solid.block().positions[node] - piece.origin - middle;
    for node in 0..solid.len() {
        let place = from_middle(&solid, node);
        let (x, y, z) = (place[along], place[beside], place[across]);
        let mut to = solid.block().positions[node];
        to[along] -= kappa * x * z;
        to[across] += 0.5 * kappa * (x * x + poisson * (z * z - y * y));
        to[beside] += poisson * kappa * y * z;
        solid.put(node, to);
    }
    solid.evaluate_internal(true);
    let dx = solid.block().spacing[along];
    let of_section = |&node: &usize| from_middle(&solid, node)[along].abs() < 0.25 * dx;
    let held = |node: usize| solid.strain_energy(node) * solid.block().volumes[node];
    let energy: f64 = (0..solid.len()).filter(of_section).map(held).sum::<f64>() / dx;
    let inertia = piece.lengths[beside] * piece.lengths[across].powi(3) / 12.0;
    Some(energy / (0.5 * young * inertia * kappa * kappa))
}

/// A piece with a middle section whose families, and those of their nodes, are whole along it; no wider than its families.
fn piece(
    lattice: &BlockLattice,
    bonds: &Formulation,
    counts: [usize; 3],
    [along, across]: [usize; 2],
) -> BlockLattice {
    let reach = libm::ceil(bonds.horizon + 0.5) as usize;
    let beside = 3 - along - across;
    let mut lengths = lattice.lengths;
    let mut spacing = lattice.spacing;
    for axis in 0..lattice.dimensions {
        spacing[axis] = lattice.lengths[axis] / counts[axis] as f64;
    }
    lengths[along] = spacing[along] * (4 * reach + usize::from(lattice.nodes == NodePlaces::Centres)) as f64;
    if beside < lattice.dimensions {
        lengths[beside] = spacing[beside] * counts[beside].min(2 * reach + 1) as f64;
    }
    BlockLattice {
        lengths,
        spacing,
        grading: [1.0; 3],
        disorder: 0.0,
        origin: Vec3::zeros(),
        ..lattice.clone()
    }
}
