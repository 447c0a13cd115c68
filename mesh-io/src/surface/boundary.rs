//! The boundary of a sheet: loops, chains of it, nodes that lie on a foreign edge, open seams.

use std::collections::{HashMap, HashSet};

use sph_core::{Cell, CellList, Vec3};

use super::MeshError;

/// Distance below which a node lies on an edge, and two nodes on one place, in units of the edge.
const TOUCHING: f64 = 1e-6;

/// Nodes on one place beyond which they are taken for a file whose nodes were never joined.
const CROWD: usize = 1000;

/// A line of boundary nodes, closed but where more sheets than two meet.
#[derive(Clone, Debug, PartialEq)]
pub struct Loop {
    /// Nodes in order, with the surface to the left seen against the normal; the lowest comes first.
    pub nodes: Vec<u32>,
    /// Length `[L]`.
    pub length: f64,
}

/// Edges of one face only, in its direction, by their first node.
///
/// The faces fit together: each boundary node begins one such edge.
pub fn boundary_edges(faces: &[Cell]) -> HashMap<u32, u32> {
    let all: HashSet<(u32, u32)> = faces.iter().flat_map(Cell::edges).collect();
    faces.iter().flat_map(Cell::edges).filter(|&(a, b)| !all.contains(&(b, a))).collect()
}

/// The same without the edges along which sheets meet: both ends of such an edge stand where other sheets do, and it is an edge of
/// one of them too.
pub(super) fn free_edges(faces: &[Cell], joined: &[Vec<u32>]) -> HashMap<u32, u32> {
    let mut edges = boundary_edges(faces);
    if joined.is_empty() {
        return edges;
    }
    let mut place = HashMap::new();
    for group in joined {
        place.extend(group.iter().map(|&node| (node, group[0])));
    }
    let at = |node: u32| place.get(&node).copied().unwrap_or(node);
    let mut faces_at = HashMap::new();
    for (a, b) in faces.iter().flat_map(Cell::edges) {
        let (a, b) = (at(a), at(b));
        *faces_at.entry((a.min(b), a.max(b))).or_insert(0) += 1;
    }
    edges.retain(|&a, b| {
        let (a, b) = (at(a), at(*b));
        faces_at.get(&(a.min(b), a.max(b))) == Some(&1)
    });
    edges
}

/// All loops, the longest first. Over a junction a loop goes on along the sheet next to it if there are two of them; if there are
/// more, or one goes straight on, the line ends there.
pub(super) fn loops(positions: &[Vec3], edges: &HashMap<u32, u32>, joined: &[Vec<u32>]) -> Vec<Loop> {
    let arrived: HashSet<u32> = edges.values().copied().collect();
    let mut next = edges.clone();
    for group in joined {
        let mut ends = group.iter().filter(|&node| arrived.contains(node) && !edges.contains_key(node));
        let mut begins = group.iter().filter(|&node| edges.contains_key(node) && !arrived.contains(node));
        if let ((Some(&end), None), (Some(&begin), None)) =
            ((ends.next(), ends.next()), (begins.next(), begins.next()))
        {
            next.insert(end, begin);
        }
    }
    let reached: HashSet<u32> = next.values().copied().collect();
    let mut starts: Vec<u32> = next.keys().copied().collect();
    // Lines that end begin where nothing arrives; what is left then is closed.
    starts.sort_unstable_by_key(|&node| (reached.contains(&node), node));
    let mut seen = HashSet::new();
    let mut loops = Vec::new();
    for start in starts {
        let mut nodes = Vec::new();
        let mut node = Some(start);
        while let Some(at) = node.filter(|&at| seen.insert(at)) {
            nodes.push(at);
            node = next.get(&at).copied();
        }
        if nodes.is_empty() {
            continue;
        }
        let closed = next.get(&nodes[nodes.len() - 1]) == Some(&start);
        let ends = nodes.iter().zip(nodes.iter().cycle().skip(1)).take(nodes.len() - usize::from(!closed));
        let length = ends.map(|(&a, &b)| (positions[b as usize] - positions[a as usize]).norm()).sum();
        loops.push(Loop { nodes, length });
    }
    loops.sort_by(|a, b| b.length.total_cmp(&a.length).then(a.nodes.cmp(&b.nodes)));
    loops
}

/// Cuts a set of nodes into lines along the boundary, each node with its tributary length `[L]`.
///
/// None unless every node is the end of a boundary edge whose other end is in the set too. A closed line
/// has its first node at both ends, with half its length at each.
pub fn chains(set: &[u32], positions: &[Vec3], edges: &HashMap<u32, u32>) -> Option<Vec<Vec<(u32, f64)>>> {
    let inside: HashSet<u32> = set.iter().copied().collect();
    let next = |node: u32| edges.get(&node).copied().filter(|end| inside.contains(end));
    let reached: HashSet<u32> = set.iter().filter_map(|&node| next(node)).collect();
    let mut sorted = set.to_vec();
    sorted.sort_unstable();
    // Open lines begin where no edge of the set arrives; what is left then is closed.
    let (open, closed): (Vec<u32>, Vec<u32>) = sorted.into_iter().partition(|node| !reached.contains(node));
    let mut seen = HashSet::new();
    let mut chains = Vec::new();
    for start in open.into_iter().chain(closed) {
        if !seen.insert(start) {
            continue;
        }
        let mut line = vec![(start, 0.0)];
        while let Some((&(node, _), end)) = line.last().and_then(|last| Some((last, next(last.0)?))) {
            let half = 0.5 * (positions[end as usize] - positions[node as usize]).norm();
            if let Some(last) = line.last_mut() {
                last.1 += half;
            }
            line.push((end, half));
            if !seen.insert(end) {
                break;
            }
        }
        if line.len() < 2 {
            return None;
        }
        chains.push(line);
    }
    Some(chains)
}

/// Nodes of a list close to an edge, which is looked at in pieces of about `step` `[L]`.
fn near_edge(list: &CellList, start: &Vec3, along: &Vec3, step: f64, near: &mut Vec<u32>) {
    let size = along.norm();
    // As a whole number the quotient saturates; the bound is far beyond the steps that the extent allows.
    let pieces = ((size / step).ceil() as u32).clamp(1, 100_000);
    let radius = (0.5 / f64::from(pieces) + TOUCHING) * size;
    let mut found = Vec::new();
    near.clear();
    for piece in 0..pieces {
        let middle = (f64::from(piece) + 0.5) / f64::from(pieces);
        list.within(&(start + middle * along), radius, &mut found);
        near.extend_from_slice(&found);
    }
    near.sort_unstable();
    near.dedup();
}

/// A boundary node in the middle of a boundary edge that it does not belong to.
#[derive(Clone, Debug, PartialEq)]
pub struct HangingNode {
    /// Where it stands `[L]`.
    pub place: Vec3,
    /// What is said of it where it is not wanted.
    pub refusal: MeshError,
}

/// Boundary nodes in the middle of a boundary edge they do not belong to, and how many coincide with others. Messages call a node
/// by its name, and point to the line of a face that uses it.
pub(super) fn hanging(
    positions: &[Vec3],
    edges: &[(u32, u32)],
    name: &dyn Fn(u32) -> String,
    line: &dyn Fn(u32) -> usize,
) -> Result<(Vec<HangingNode>, usize), MeshError> {
    let mut nodes: Vec<u32> = edges.iter().flat_map(|&(a, b)| [a, b]).collect();
    nodes.sort_unstable();
    nodes.dedup();
    let places: Vec<Vec3> = nodes.iter().map(|&node| positions[node as usize]).collect();
    let along = |(a, b): (u32, u32)| positions[b as usize] - positions[a as usize];
    let mean = edges.iter().map(|&edge| along(edge).norm()).sum::<f64>() / edges.len().max(1) as f64;
    let low = places.iter().copied().reduce(|a, b| a.inf(&b)).unwrap_or_default();
    let high = places.iter().copied().reduce(|a, b| a.sup(&b)).unwrap_or_default();
    // Boxes no longer than those of one node each on a sheet: needles do not see each other whole.
    let step = mean.min((high - low).norm() / (nodes.len() as f64).sqrt().max(1.0));
    let list = CellList::new(&places, step);
    let (mut near, mut seams, mut hanging) = (Vec::new(), HashSet::new(), Vec::new());
    for &(a, b) in edges {
        let (start, along) = (positions[a as usize], along((a, b)));
        let size = along.norm();
        near_edge(&list, &start, &along, step, &mut near);
        if near.len() > CROWD && near.iter().filter(|&&i| places[i as usize] == start).count() > CROWD {
            let what = format!("more than {CROWD} nodes stand on the place of {}", name(a));
            return Err(MeshError::at(line(a), what, "merge nodes that coincide"));
        }
        for node in near.iter().map(|&i| nodes[i as usize]).filter(|&node| node != a && node != b) {
            let arm = positions[node as usize] - start;
            let part = arm.dot(&along) / (size * size);
            if (arm - along * part).norm() > TOUCHING * size {
                continue;
            }
            if part > TOUCHING && part < 1.0 - TOUCHING {
                let what = format!(
                    "{} lies on the edge between {} and {} without being joined to it",
                    name(node),
                    name(a),
                    name(b)
                );
                let repair = "mesh the surfaces with common nodes along their common line, or tie the edge to the other surface";
                let refusal = MeshError::at(line(node), what, repair);
                hanging.push(HangingNode { place: positions[node as usize], refusal });
                continue;
            }
            seams.insert(node);
        }
    }
    Ok((hanging, seams.len()))
}
