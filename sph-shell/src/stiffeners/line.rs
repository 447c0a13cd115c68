//! The line of a stiffener: edges of cells between particles of a set.

use std::collections::{BTreeMap, BTreeSet};

use sph_core::Cloud;

use crate::error::StiffenerError;

/// Edges of cells both of whose ends are among some particles, each once, the lesser end first.
///
/// # Errors
/// [`StiffenerError`] for a particle without an edge, a cell all of whose corners are among them, and edges of two sheets on one place.
pub(super) fn edges(
    cloud: &Cloud,
    particles: &[u32],
    number: usize,
) -> Result<BTreeSet<[u32; 2]>, StiffenerError> {
    let set: BTreeSet<u32> = particles.iter().copied().collect();
    let mut edges = BTreeSet::new();
    for (c, cell) in cloud.cells.iter().enumerate() {
        if cell.particles().iter().all(|b| set.contains(b)) {
            return Err(StiffenerError::CoversCell { number, cell: c });
        }
        let within = cell.edges().filter(|(a, b)| set.contains(a) && set.contains(b));
        edges.extend(within.map(|(a, b)| [a.min(b), a.max(b)]));
    }
    let met: BTreeSet<u32> = edges.iter().flatten().copied().collect();
    if let Some(&particle) = set.difference(&met).next() {
        return Err(StiffenerError::Alone { number, particle });
    }
    let firsts: BTreeMap<u32, u32> =
        cloud.joined.iter().flat_map(|group| group.iter().map(|&a| (a, group[0]))).collect();
    let place = |a: u32| firsts.get(&a).copied().unwrap_or(a);
    let mut places = BTreeSet::new();
    for &ends in &edges {
        let [a, b] = ends.map(place);
        if !places.insert([a.min(b), a.max(b)]) {
            return Err(StiffenerError::Twice { number, ends });
        }
    }
    Ok(edges)
}
