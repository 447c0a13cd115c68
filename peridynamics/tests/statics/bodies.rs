//! Small bodies of every kind, whole and cut, and states far from rest.

use implicit_statics::Equilibrium;
use peridynamics::{Correction, Crack, Elastic, Law, Parts, Solid, Space, StaticSolid};
use sph_core::Vec3;

use crate::blocks::{formulation, lattice, parts};

pub const SPACES: [Space; 3] = [Space::Solid, Space::PlaneStress, Space::PlaneStrain];
pub const LAWS: [Law; 2] = [Law::BondBased, Law::StateBased];

/// Poisson's ratio for a law: that of pairwise forces, or one of its own.
pub fn poisson(space: Space, law: Law) -> f64 {
    match (law, space) {
        (Law::StateBased, _) => 0.2,
        (Law::BondBased, Space::PlaneStress) => 1.0 / 3.0,
        (Law::BondBased, _) => 0.25,
    }
}

/// A block of unit spacing and unit modulus.
pub fn block_parts(space: Space, law: Law, cells: [usize; 3]) -> Parts {
    let lengths = cells.map(|n| n as f64);
    let block = lattice(space.dimensions(), Vec3::zeros(), lengths, 1.0).block().unwrap();
    let material = Elastic { young: 1.0, poisson: poisson(space, law), density: 1.0 };
    parts(block, material, formulation(space, law, Correction::Even))
}

/// Free blocks of every kind, each whole and with a crack in from one face.
pub fn free_blocks() -> Vec<(String, StaticSolid)> {
    let mut out = Vec::new();
    for space in SPACES {
        for law in LAWS {
            for cracked in [false, true] {
                let solid = space == Space::Solid;
                let cells = if solid { [5, 4, 4] } else { [9, 8, 1] };
                let mut parts = block_parts(space, law, cells);
                let tip = 0.4 * cells[0] as f64;
                let (y, top) = (0.5 * cells[1] as f64, cells[2] as f64 + 1.0);
                parts.cracks = match (cracked, solid) {
                    (false, _) => Vec::new(),
                    (true, false) => {
                        vec![Crack::Segment([Vec3::new(-1.0, y, 0.0), Vec3::new(tip, y, 0.0)])]
                    }
                    (true, true) => vec![Crack::Polygon(
                        [[-1.0, -1.0], [tip, -1.0], [tip, top], [-1.0, top]]
                            .map(|[x, z]| Vec3::new(x, y, z))
                            .to_vec(),
                    )],
                };
                let name = format!("{space:?}, {law:?}, cracked: {cracked}");
                out.push((name, StaticSolid::new(Solid::new(parts).unwrap())));
            }
        }
    }
    out
}

/// Stretches a body by some percent, shears it and shakes its nodes.
pub fn deform(system: &mut StaticSolid) {
    let noise = noise(system.unknowns(), 0.02);
    for node in 0..system.solid().len() {
        let x = system.solid().block().positions[node];
        let u = Vec3::new(0.05 * x.x + 0.03 * x.y, -0.01 * x.y, if x.z == 0.0 { 0.0 } else { 0.02 * x.x });
        system.solid_mut().put(node, x + u);
    }
    system.update(&noise);
}

/// Numbers without structure between ± size.
pub fn noise(count: usize, size: f64) -> Vec<f64> {
    let golden = 0.618_033_988_749_894_9;
    (0..count)
        .map(|i| {
            let x = (i as f64 + 1.0) * golden * 97.31;
            size * (2.0 * (x - x.floor()) - 1.0)
        })
        .collect()
}

pub fn norm(v: &[f64]) -> f64 {
    v.iter().map(|v| v * v).sum::<f64>().sqrt()
}

/// Numbers for a message.
pub fn short(v: &[f64]) -> String {
    v.iter().map(|v| format!("{v:.1e} ")).collect()
}
