//! Blocks of steel that yields, held in uniform strains or free, for the tests of yielding bonds.

use explicit_dynamics::{Dynamics, Instant, Step};
use nalgebra::Matrix3;
use peridynamics::{Correction, Elastic, Formulation, Influence, Law, Parts, Plastic, Solid, Space, Volumes};
use sph_core::{Block, Vec3};

use crate::lattices::{displace, lattice, parts};

pub const YOUNG: f64 = 200e9;
pub const POISSON: f64 = 0.3;
pub const STEEL: Elastic = Elastic { young: YOUNG, poisson: POISSON, density: 7850.0 };
pub const SHEAR: f64 = YOUNG / (2.0 * (1.0 + POISSON));
/// Spacing of nodes.
pub const DX: f64 = 1e-3;

const AT: Instant = Instant { time: 0.0, level: 1.0 };
/// A step that hardly kicks and does not drift.
const STILL: Step = Step { from: AT, to: AT, kick: 1e-30, damping: 0.0 };

/// A formulation of bonds in space.
pub fn bonds(correction: Correction, influence: Influence, horizon: f64) -> Formulation {
    let law = Law::StateBased;
    Formulation { space: Space::Solid, law, horizon, volumes: Volumes::Partial, influence, correction }
}

/// The usual one.
pub fn usual() -> Formulation {
    bonds(Correction::Even, Influence::Inverse, 2.015)
}

/// A cell of nodes on the edges of a block: what balanced weights are for.
pub fn on_edges(counts: [usize; 3]) -> Block {
    let mut block = lattice(3, counts, [DX; 3]);
    let end = |k: usize, n: usize| if k == 0 || k + 1 == n { 0.5 } else { 1.0 };
    block.faces = std::array::from_fn(|_| Vec::new());
    let mut node = 0;
    for i in 0..counts[0] {
        for j in 0..counts[1] {
            for k in 0..counts[2] {
                let at = [i, j, k];
                let part: [f64; 3] = std::array::from_fn(|a| end(at[a], counts[a]));
                block.volumes[node] = DX.powi(3) * part.iter().product::<f64>();
                for a in 0..3 {
                    let area = DX * DX * part[(a + 1) % 3] * part[(a + 2) % 3];
                    if at[a] == 0 {
                        block.faces[2 * a].push((node as u32, area));
                    }
                    if at[a] + 1 == counts[a] {
                        block.faces[2 * a + 1].push((node as u32, area));
                    }
                }
                node += 1;
            }
        }
    }
    block
}

/// A free body that yields.
pub fn yielding(block: Block, formulation: Formulation, plastic: Plastic) -> Solid {
    Solid::new(Parts { plastic: Some(plastic), ..parts(block, STEEL, formulation) }).unwrap()
}

/// Perfect plasticity.
pub fn perfect(yield_stress: f64) -> Plastic {
    Plastic { yield_stress, hardening: 0.0 }
}

/// The node nearest to the middle.
pub fn middle(body: &Solid) -> usize {
    let mean = body.block().positions.iter().sum::<Vec3>() / body.len() as f64;
    let distance = |node: &usize| (body.block().positions[*node] - mean).norm_squared();
    (0..body.len()).min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap()
}

/// Puts all nodes where a uniform strain has them, and keeps what flows on the way; returns the plastic work.
pub fn strain(body: &mut Solid, strain: &Matrix3<f64>) -> f64 {
    displace(body, |x| strain * x);
    body.evaluate(AT);
    body.kick(&STILL).dissipated
}

/// Von Mises' stress.
pub fn mises(stress: &Matrix3<f64>) -> f64 {
    let deviator = stress - Matrix3::identity() * (stress.trace() / 3.0);
    (1.5 * deviator.norm_squared()).sqrt()
}

/// Unit shear in a plane: directions at right angles.
pub fn shear(n: Vec3, m: Vec3) -> Matrix3<f64> {
    let (n, m) = (n.normalize(), m.normalize());
    (n * m.transpose() + m * n.transpose()) * 0.5
}
