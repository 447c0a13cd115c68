//! Disordered lattices: particles moved at random inside the surface, the same for the same seed everywhere.

use crate::Vec3;
use crate::error::SpaceError;
use crate::random::SplitMix;
use crate::surface::boundary::boundary;
use crate::surface::cloud::Cloud;
use crate::surface::frame::Frame;
use crate::surface::lattice::{check_lattice_cells, parameter, step};
use crate::surface::numbering::Lattice;
use crate::surface::patch::Patch;
use crate::surface::surface_mesh::cells_on;

/// Greatest disorder, in spacings, that leaves every cell of a square lattice convex: beyond it the diagonal through two
/// neighbours of a particle can pass on its other side.
const CONVEX: f64 = 0.25;

/// Lattice of `counts` particles on `patch` whose particles are moved by up to ± `fraction` of the parameter step.
///
/// Edge particles slide along their edge and corners stay. Positions, normals and frames (t1 along u) are those of the
/// patch at the moved parameters; areas `A_a = Σ_cells w_p/m` and edges come from the cells. Up to a `fraction` of a
/// quarter these are the cells of the lattice; beyond, where some would have inner corners, particles are triangulated
/// and paired anew. `fraction` lies in [0, 0.49]: beyond a half, neighbours could change places.
pub fn jittered_lattice(
    patch: &dyn Patch,
    counts: [usize; 2],
    fraction: f64,
    seed: u64,
) -> Result<Cloud, SpaceError> {
    if !(0.0..=0.49).contains(&fraction) {
        return Err(SpaceError::OutOfRange { what: "jitter fraction", value: fraction, bound: "[0, 0.49]" });
    }
    let lattice = Lattice { counts };
    lattice.check()?;
    let [range_u, range_v] = patch.range();
    let mut random = SplitMix { state: seed };
    let mut moved = |range: [f64; 2], n: usize, i: usize| {
        let noise = fraction * step(range, n) * (2.0 * random.next() - 1.0); // drawn for fixed ones too
        parameter(range, n, i) + if i == 0 || i == n - 1 { 0.0 } else { noise }
    };
    let (mut parameters, mut positions, mut frames) = (Vec::new(), Vec::new(), Vec::<Frame>::new());
    for i in 0..counts[0] {
        for j in 0..counts[1] {
            let (u, v) = (moved(range_u, counts[0], i), moved(range_v, counts[1], j));
            parameters.push([u, v]);
            positions.push(patch.position(u, v));
            let (n, along_u) = (patch.normal(u, v), patch.tangents(u, v).0);
            let t1 = (along_u - n * n.dot(&along_u)).normalize();
            frames.push(Frame { t1, t2: n.cross(&t1), n });
        }
    }
    let cells = if fraction <= CONVEX { lattice.cells() } else { cells_on(patch, &parameters, &positions)? };
    let normals: Vec<Vec3> = frames.iter().map(|frame| frame.n).collect();
    let edges = boundary(&positions, &normals, &cells)?;
    let mut areas = vec![0.0; positions.len()];
    for cell in &cells {
        let share = cell.geometry(&positions).area / f64::from(cell.count);
        cell.particles().iter().for_each(|&b| areas[b as usize] += share);
    }
    let cloud = Cloud {
        positions,
        frames,
        areas,
        edge_normals: edges.normals,
        edge_lengths: edges.lengths,
        cells,
        joined: Vec::new(),
        sides: Some(lattice.sides()),
        lattice: Some(lattice),
    };
    check_lattice_cells(&cloud)?;
    cloud.check()?;
    Ok(cloud)
}
