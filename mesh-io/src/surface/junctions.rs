//! Where sheets meet: edges of three faces and more, and folds; nodes are cut there, so that each sheet has its own.

use std::f64::consts::PI;

use libm::atan2;
use sph_core::Vec3;

use super::MeshError;
use super::raw::Raw;
use super::sides::{Side, root, sides};

/// Turn of an edge of two faces beyond which it may be a fold \[rad\], and within which two faces at an edge of more are one
/// sheet: 30°. A fold of 30° with one normal costs a frame .2 % of its answer, one of 90° 4 %; a smooth surface taken for facets is
/// wrong by factors.
pub(super) const FOLD: f64 = PI / 6.0;

/// Turn beyond which an edge is a fold whatever is beside it \[rad\]: 60°, six facets to a circle.
pub(super) const SHARP: f64 = PI / 3.0;

/// What the turn at an edge must be to the one across the next edges: half as much beside it is the facet of a curve.
pub(super) const FACET: f64 = 0.5;

/// Sheets that may meet at one place: more are nodes that were merged by mistake.
const MOST_SHEETS: usize = 64;

/// What to do where more meet.
const MERGED: &str = "give the faces nodes of their own there, or leave out those that lie on each other";

/// Rounding of angles \[rad\].
const ROUND_OFF: f64 = 1e-6;

/// Edges at which sheets meet.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Junctions {
    /// Edges of three faces and more.
    pub branches: usize,
    /// Edges of two faces that fold.
    pub folds: usize,
}

/// How two faces at an edge belong together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Bond {
    /// One sheet, which has nodes of its own.
    Sheet,
    /// Two sheets whose faces are turned the same way.
    Fold,
    /// Sheets that have nothing to do with each other but their place.
    Place,
}

/// Two faces at an edge.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pair {
    pub faces: [u32; 2],
    /// The nodes of the edge.
    pub edge: (u32, u32),
    /// Whether the faces run opposite ways along it, as neighbours turned the same way do.
    pub agree: bool,
    pub bond: Bond,
}

/// Pairs of faces at all edges, in the order of the edges; with one normal a node from the file, edges of two faces are no folds.
///
/// # Errors
/// [`MeshError`] for an edge of more faces than can be sheets.
pub(super) fn pairs(raw: &Raw) -> Result<Vec<Pair>, MeshError> {
    let sides = sides(&raw.faces);
    let normals: Vec<Vec3> = raw.faces.iter().map(|face| face.cell.geometry(&raw.positions).normal).collect();
    let folds = raw.normals.len() < raw.positions.len();
    let shared = || sides.chunk_by(|a, b| (a.low, a.high) == (b.low, b.high));
    // Turns across the edges of two faces, by face and corner.
    let mut turns = vec![[None; 4]; raw.faces.len()];
    for shared in shared() {
        let [one, other] = shared else { continue };
        let turn = turn(&normals, one, other);
        for side in [one, other] {
            turns[side.face as usize][place(raw, side)] = Some(turn);
        }
    }
    let across: Vec<[u32; 4]> = across(raw, shared());
    let mut pairs = Vec::new();
    for shared in shared() {
        match shared {
            [] | [_] => {}
            [one, other] => {
                let turn = turn(&normals, one, other);
                let beside = [one, other].map(|side| beside(raw, &turns, &across, side));
                let sharp = turn > SHARP + ROUND_OFF;
                // Where the surface ends on one side, the other one tells.
                let least = beside.into_iter().flatten().reduce(f64::min);
                let lone = least.is_none_or(|least| least < FACET * turn);
                let fold = folds && turn > FOLD + ROUND_OFF && (sharp || lone);
                pairs.push(pair(one, other, if fold { Bond::Fold } else { Bond::Sheet }));
            }
            [first, ..] if shared.len() > MOST_SHEETS => {
                let ends = format!("the edge between {} and {}", raw.name(first.low), raw.name(first.high));
                let what =
                    format!("{ends} belongs to {} faces; at most {MOST_SHEETS} can meet there", shared.len());
                let line = shared.iter().map(|side| raw.faces[side.face as usize].line).max();
                return Err(MeshError::at(line.unwrap_or(0), what, MERGED));
            }
            several => pairs.extend(branch(&normals, several)),
        }
    }
    Ok(pairs)
}

/// Pairs at an edge of three faces and more: the two that turn least are one sheet, then the next two, within the bound.
fn branch(normals: &[Vec3], several: &[Side]) -> Vec<Pair> {
    let mut turns = Vec::new();
    for (i, one) in several.iter().enumerate() {
        for (j, other) in several.iter().enumerate().skip(i + 1) {
            turns.push((turn(normals, one, other), i, j));
        }
    }
    turns.sort_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
    let mut taken = vec![false; several.len()];
    let mut pairs = Vec::new();
    for (turn, i, j) in turns {
        let together = turn <= FOLD + ROUND_OFF && !taken[i] && !taken[j];
        if together {
            (taken[i], taken[j]) = (true, true);
        }
        // Each face follows the first, so that all of them are known to be connected.
        if together || i == 0 {
            let bond = if together { Bond::Sheet } else { Bond::Place };
            pairs.push(pair(&several[i], &several[j], bond));
        }
    }
    pairs
}

fn pair(one: &Side, other: &Side, bond: Bond) -> Pair {
    let agree = one.forward != other.forward;
    Pair { faces: [one.face, other.face], edge: (one.low, one.high), agree, bond }
}

/// Angle between two faces at an edge \[rad\], zero in a plane, whichever way they are turned.
fn turn(normals: &[Vec3], one: &Side, other: &Side) -> f64 {
    let [m, mut n] = [one, other].map(|side| normals[side.face as usize]);
    if one.forward == other.forward {
        n = -n;
    }
    atan2(m.cross(&n).norm(), m.dot(&n))
}

/// Which edge of its face a side is.
fn place(raw: &Raw, side: &Side) -> usize {
    let ends = |(a, b): (u32, u32)| (a.min(b), a.max(b)) == (side.low, side.high);
    raw.faces[side.face as usize].cell.edges().position(ends).unwrap_or(0)
}

/// The face across each edge of two faces; `u32::MAX` across others.
fn across<'a>(raw: &Raw, shared: impl Iterator<Item = &'a [Side]>) -> Vec<[u32; 4]> {
    let mut across = vec![[u32::MAX; 4]; raw.faces.len()];
    for shared in shared {
        let [one, other] = shared else { continue };
        across[one.face as usize][place(raw, one)] = other.face;
        across[other.face as usize][place(raw, other)] = one.face;
    }
    across
}

/// The turn at the edge of a face opposite a side; none where the surface ends or branches there. A triangle goes with the one
/// across the longer of its other edges, as the halves of a quadrangle do.
fn beside(raw: &Raw, turns: &[[Option<f64>; 4]], across: &[[u32; 4]], side: &Side) -> Option<f64> {
    let (face, own) = (side.face as usize, place(raw, side));
    let cell = &raw.faces[face].cell;
    if cell.count == 4 {
        return turns[face][(own + 2) % 4];
    }
    let length = |i: usize| {
        let corners = cell.particles();
        (raw.positions[corners[(i + 1) % 3] as usize] - raw.positions[corners[i] as usize]).norm()
    };
    let next = [(own + 1) % 3, (own + 2) % 3];
    let longer = if length(next[0]) >= length(next[1]) { next[0] } else { next[1] };
    let other = across[face][longer] as usize;
    let beyond = turns.get(other)?;
    let apart = |(a, b): (u32, u32)| ![a, b].iter().any(|&node| node == side.low || node == side.high);
    raw.faces[other].cell.edges().position(apart).and_then(|opposite| beyond[opposite])
}

/// What [`cut`] found: the edges, and the nodes of different sheets on one place.
type Found = (Junctions, Vec<Vec<u32>>);

/// Gives each sheet its own nodes at junctions, one behind the other in the place of the one they shared.
///
/// # Errors
/// [`MeshError`] for a node at which more sheets meet than can.
pub(super) fn cut(raw: &mut Raw, pairs: &[Pair]) -> Result<Found, MeshError> {
    let found = count(pairs);
    if found == Junctions::default() {
        return Ok((found, Vec::new()));
    }
    let mut open = vec![false; raw.positions.len()];
    let meeting = pairs.iter().filter(|pair| pair.bond != Bond::Sheet);
    meeting.for_each(|pair| [pair.edge.0, pair.edge.1].iter().for_each(|&node| open[node as usize] = true));
    let corners = sheets_at_corners(raw, pairs, &open);
    // Nodes in order, each as many times as sheets meet there.
    let mut all: Vec<(u32, u32)> = corners.iter().flatten().copied().collect();
    all.sort_unstable();
    all.dedup();
    let crowd = all.chunk_by(|a, b| a.0 == b.0).find(|sheets| sheets.len() > MOST_SHEETS);
    if let Some(at_node) = crowd {
        let (node, count) = (at_node[0].0, at_node.len());
        let what = format!("{count} sheets meet at {}; at most {MOST_SHEETS} can", raw.name(node));
        return Err(MeshError::at(raw.line_at(node), what, MERGED));
    }
    for (face, corners) in raw.faces.iter_mut().zip(&corners) {
        let new = |place: usize| all.binary_search(&corners[place]).unwrap_or_default() as u32;
        // A triangle repeats its last corner.
        face.cell.corners = [0, 1, 2, 3].map(|place| new(place.min(corners.len() - 1)));
    }
    let mut first = vec![0; raw.positions.len() + 1];
    all.iter().for_each(|&(node, _)| first[node as usize + 1] += 1);
    (0..raw.positions.len()).for_each(|node| first[node + 1] += first[node]);
    let copies = |node: u32| first[node as usize]..first[node as usize + 1];
    raw.positions = all.iter().map(|&(node, _)| raw.positions[node as usize]).collect();
    if !raw.labels.is_empty() {
        raw.labels = all.iter().map(|&(node, _)| raw.labels[node as usize]).collect();
    }
    for nodes in raw.sets.values_mut() {
        *nodes = nodes.iter().flat_map(|&node| copies(node)).collect();
    }
    let nodes = 0..first.len() as u32 - 1;
    let joined = nodes.map(|node| copies(node).collect::<Vec<u32>>()).filter(|at| at.len() > 1).collect();
    give_normals(raw, &copies);
    Ok((found, joined))
}

/// For each corner of each face its node, and which of the sheets there it belongs to: corners round a node that pairs of one sheet
/// connect have one number.
fn sheets_at_corners(raw: &Raw, pairs: &[Pair], open: &[bool]) -> Vec<Vec<(u32, u32)>> {
    let corner = |face: u32, node: u32| {
        let corners = raw.faces[face as usize].cell.corners;
        4 * face + corners.iter().position(|&c| c == node).unwrap_or(0) as u32
    };
    let mut parent: Vec<u32> = (0..4 * raw.faces.len() as u32).collect();
    for pair in pairs.iter().filter(|pair| pair.bond == Bond::Sheet) {
        for node in [pair.edge.0, pair.edge.1] {
            let [a, b] = pair.faces.map(|face| root(&mut parent, corner(face, node)));
            parent[a.max(b) as usize] = a.min(b);
        }
    }
    let of_face = |face: usize| {
        let nodes = raw.faces[face].cell.particles().iter();
        let sheet =
            |&node: &u32| if open[node as usize] { root(&mut parent, corner(face as u32, node)) } else { 0 };
        let sheets: Vec<u32> = nodes.clone().map(sheet).collect();
        nodes.copied().zip(sheets).collect()
    };
    (0..raw.faces.len()).map(of_face).collect()
}

/// Normals of the file stay where a node is one; where it was cut each sheet has the mean over its own faces.
fn give_normals(raw: &mut Raw, copies: &impl Fn(u32) -> std::ops::Range<u32>) {
    if raw.normals.is_empty() {
        return;
    }
    let given = std::mem::take(&mut raw.normals);
    let faces: Vec<_> = raw.faces.iter().map(|face| face.cell).collect();
    let means = super::mean_normals(&raw.positions, &faces);
    for (node, normal) in given {
        let own = copies(node);
        let cut = own.len() > 1;
        raw.normals.extend(own.map(|copy| (copy, if cut { means[copy as usize] } else { normal })));
    }
}

/// Edges at which sheets meet.
fn count(pairs: &[Pair]) -> Junctions {
    let mut found = Junctions::default();
    for at_edge in pairs.chunk_by(|a, b| a.edge == b.edge) {
        match at_edge {
            [one] => found.folds += usize::from(one.bond == Bond::Fold),
            _ => found.branches += 1,
        }
    }
    found
}
