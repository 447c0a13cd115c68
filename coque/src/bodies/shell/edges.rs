//! Edges of a shell that no support holds: a fluid flows round them.

use std::collections::BTreeSet;

use mesh_io::surface::boundary_edges;
use sph_core::Cloud;
use sph_shell::Supported;

/// Particles of the edges of cells on the boundary whose ends no one support holds both: where a support does, the shell goes
/// on behind a symmetry plane, or stands in a wall.
pub(super) fn free_edges(cloud: &Cloud, supports: &[Supported]) -> Vec<u32> {
    let held: Vec<BTreeSet<u32>> =
        supports.iter().map(|support| support.particles.iter().copied().collect()).collect();
    let free = |from: u32, to: u32| !held.iter().any(|set| set.contains(&from) && set.contains(&to));
    let edges = boundary_edges(&cloud.cells).into_iter().filter(|&(from, to)| free(from, to));
    let particles: BTreeSet<u32> = edges.flat_map(|(from, to)| [from, to]).collect();
    particles.into_iter().collect()
}
