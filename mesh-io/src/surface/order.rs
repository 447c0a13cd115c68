//! Numbers nodes along the surface: neighbours with near numbers lie near in memory, and steps run faster.

use sph_core::{Cell, Vec3};

use super::raw::Raw;

/// Nodes are numbered anew where that shrinks the mean reach of a face to less than this part.
const WORTH: f64 = 0.5;

/// Below this number of nodes everything stays in the cache, whatever the order.
const FEW: usize = 1000;

/// Gives node `a` the number `new[a]`, and leaves it out where there is none; the others count from 0 to `count`.
pub(super) fn renumber(raw: &mut Raw, new: &[Option<u32>], count: usize) {
    let at = |node: u32| new.get(node as usize).copied().flatten();
    let mut positions = vec![Vec3::zeros(); count];
    let mut labels = vec![0; if raw.labels.is_empty() { 0 } else { count }];
    for (old, position) in (0..).zip(&raw.positions) {
        let Some(new) = at(old) else { continue };
        positions[new as usize] = *position;
        if let (Some(to), Some(label)) = (labels.get_mut(new as usize), raw.labels.get(old as usize)) {
            *to = *label;
        }
    }
    (raw.positions, raw.labels) = (positions, labels);
    for cell in raw.faces.iter_mut().map(|face| &mut face.cell) {
        cell.corners = cell.corners.map(|node| at(node).unwrap_or(node));
    }
    for nodes in raw.sets.values_mut() {
        *nodes = nodes.iter().filter_map(|&node| at(node)).collect();
    }
    raw.normals = raw.normals.iter().filter_map(|(&node, &normal)| Some((at(node)?, normal))).collect();
}

/// Numbers nodes and faces along the surface if their own order is much worse; says whether it did.
///
/// The order is that of Cuthill and McKee \[cuthill1969\], from a node far out: by distance in faces from it, the
/// neighbours of lower nodes first.
pub(super) fn along_the_surface(raw: &mut Raw) -> bool {
    if raw.positions.len() < FEW {
        return false;
    }
    let cells: Vec<Cell> = raw.faces.iter().map(|face| face.cell).collect();
    let mut place = vec![0; raw.positions.len()];
    for (number, node) in (0..).zip(cuthill_mckee(&cells, raw.positions.len())) {
        place[node as usize] = number;
    }
    let own = mean_reach(&cells, |node| node);
    if mean_reach(&cells, |node| place[node as usize]) > WORTH * own {
        return false;
    }
    let new: Vec<Option<u32>> = place.into_iter().map(Some).collect();
    renumber(raw, &new, new.len());
    true
}

/// Mean difference between the greatest and the least number in a face.
fn mean_reach(cells: &[Cell], place: impl Fn(u32) -> u32) -> f64 {
    let reach = |cell: &Cell| {
        let places = cell.corners.map(&place);
        let bounds = places.iter().fold((u32::MAX, 0), |(low, high), &p| (low.min(p), high.max(p)));
        f64::from(bounds.1 - bounds.0)
    };
    cells.iter().map(reach).sum::<f64>() / cells.len() as f64
}

/// Nodes in order; every node is in a face.
fn cuthill_mckee(cells: &[Cell], count: usize) -> Vec<u32> {
    let neighbours = Neighbours::new(cells, count);
    let mut order = Vec::new();
    let mut seen = vec![false; count];
    let mut queue = Vec::new();
    for start in 0..count as u32 {
        if seen[start as usize] {
            continue;
        }
        // The last node reached lies far out; so does the last one reached from there, on the other side.
        let mut far = start;
        for _ in 0..2 {
            neighbours.flood(far, &mut seen, &mut queue);
            far = queue.last().copied().unwrap_or(start);
            queue.iter().for_each(|&node| seen[node as usize] = false);
        }
        neighbours.flood(far, &mut seen, &mut queue);
        order.extend_from_slice(&queue);
    }
    order
}

/// Nodes that share a face with each node.
struct Neighbours {
    starts: Vec<u32>,
    nodes: Vec<u32>,
}

impl Neighbours {
    fn new(cells: &[Cell], count: usize) -> Self {
        let pairs = |cell: &Cell| {
            let corners = cell.corners;
            corners
                .into_iter()
                .flat_map(move |a| corners.into_iter().map(move |b| (a, b)))
                .filter(|(a, b)| a != b)
        };
        let mut pairs: Vec<(u32, u32)> = cells.iter().flat_map(pairs).collect();
        pairs.sort_unstable();
        pairs.dedup();
        let mut starts = vec![0; count + 1];
        for &(a, _) in &pairs {
            starts[a as usize + 1] += 1;
        }
        for a in 0..count {
            starts[a + 1] += starts[a];
        }
        Self { starts, nodes: pairs.into_iter().map(|(_, b)| b).collect() }
    }

    fn of(&self, node: u32) -> &[u32] {
        &self.nodes[self.starts[node as usize] as usize..self.starts[node as usize + 1] as usize]
    }

    /// All nodes that can be reached from `start`, nearest first, those with few neighbours first among equals.
    fn flood(&self, start: u32, seen: &mut [bool], queue: &mut Vec<u32>) {
        queue.clear();
        queue.push(start);
        seen[start as usize] = true;
        let mut next = 0;
        while let Some(&node) = queue.get(next) {
            next += 1;
            let first = queue.len();
            for &other in self.of(node) {
                if !std::mem::replace(&mut seen[other as usize], true) {
                    queue.push(other);
                }
            }
            queue[first..].sort_by_key(|&node| (self.of(node).len(), node));
        }
    }
}
