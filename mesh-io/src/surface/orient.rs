//! Makes sheets of faces: neighbours turned the same way, fans whole.

use std::collections::HashMap;

use sph_core::{Cell, Vec3};

use super::MeshError;
use super::boundary::{HangingNode, hanging};
use super::hollow::{Shape, shape};
use super::junctions::{Bond, Pair};
use super::raw::Raw;
use super::sides::{root, sides};

/// Area below which a face has none, in units of its longest edge squared; the bound of the cloud.
const FLAT: f64 = 1e-6;

/// What was done to turn all faces the same way.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Turned {
    /// Connected pieces.
    pub pieces: usize,
    /// Faces turned round.
    pub faces: usize,
    /// Boundary nodes that stand on the place of another one.
    pub seams: usize,
    /// Nodes on a foreign edge.
    pub hanging: Vec<HangingNode>,
}

/// The same face seen from the other side, starting at the same corner.
pub(super) fn reversed(cell: &Cell) -> Cell {
    match (cell.count, cell.corners) {
        (3, [a, b, c, _]) => Cell::triangle([a, c, b]),
        (_, [a, b, c, d]) => Cell::quadrangle([a, d, c, b]),
    }
}

/// Refuses faces with repeated nodes, without area or whose edges cross, and faces that are there twice.
pub(super) fn check_faces(raw: &Raw) -> Result<(), MeshError> {
    let mut known = HashMap::new();
    for face in &raw.faces {
        let corners = face.cell.particles();
        let mut sorted = [u32::MAX; 4];
        sorted[..corners.len()].copy_from_slice(corners);
        sorted.sort_unstable();
        if let Some(first) = known.insert(sorted, face.label) {
            let what = format!("faces {first} and {} have the same nodes", face.label);
            return Err(MeshError::at(face.line, what, "remove one of them"));
        }
        let repeated = corners.iter().enumerate().find(|(i, node)| corners[..*i].contains(node));
        if let Some((_, &node)) = repeated {
            let what = format!("face {} has {} twice", face.label, raw.name(node));
            return Err(MeshError::at(face.line, what, "write it as a triangle, or remove it"));
        }
        let length =
            |(a, b): (u32, u32)| (raw.positions[b as usize] - raw.positions[a as usize]).norm_squared();
        let longest = face.cell.edges().map(length).fold(0.0, f64::max);
        let area = face.cell.geometry(&raw.positions).area;
        // What is no number has no area either.
        if area.is_nan() || area <= FLAT * longest {
            let at = super::error::place(&raw.positions[corners[0] as usize]);
            let what = format!("face {} at {at} has no area", face.label);
            return Err(MeshError::at(
                face.line,
                what,
                "move its nodes apart, or remove it and close the gap",
            ));
        }
        if shape(&face.cell, &raw.positions) == Shape::Crossed {
            let at = super::error::place(&raw.positions[corners[0] as usize]);
            let what = format!(
                "the edges of face {} at {at} cross each other, or it is folded onto itself",
                face.label
            );
            let repair = "write its nodes in the order in which they follow each other round it, or mesh it anew there";
            return Err(MeshError::at(face.line, what, repair));
        }
    }
    Ok(())
}

/// Turns faces so that neighbours run opposite ways along their common edge, by a flood through every piece.
///
/// The smaller part of a piece is turned; faces agree with given normals where these are known. Across folds faces are turned
/// the same way too. Refuses nodes that hang on a foreign edge unless they may, and surfaces that have one side only.
pub(super) fn orient(raw: &mut Raw, pairs: &[Pair], may_hang: bool) -> Result<Turned, MeshError> {
    let sides = sides(&raw.faces);
    let neighbours = neighbours(raw, pairs);
    let alone = sides.chunk_by(|a, b| (a.low, a.high) == (b.low, b.high)).filter(|shared| shared.len() == 1);
    let edges: Vec<(u32, u32)> = alone.map(|shared| (shared[0].low, shared[0].high)).collect();
    let (hanging, seams) =
        hanging(&raw.positions, &edges, &|node| raw.name(node), &|node| raw.line_at(node))?;
    if let Some(HangingNode { refusal, .. }) = hanging.first().filter(|_| !may_hang) {
        return Err(refusal.clone());
    }
    let mut turned = vec![None; raw.faces.len()];
    let mut result = Turned { seams, hanging, pieces: pieces(raw.faces.len(), pairs), ..Turned::default() };
    let mut piece = Vec::new();
    for start in 0..raw.faces.len() {
        if turned[start].is_some() {
            continue;
        }
        piece.clear();
        piece.push(start as u32);
        turned[start] = Some(false);
        let mut next = 0;
        while let Some(&face) = piece.get(next) {
            next += 1;
            let own = turned[face as usize].unwrap_or_default();
            for &(other, agrees, edge) in &neighbours[face as usize] {
                let needed = own == agrees;
                match turned[other as usize] {
                    None => {
                        turned[other as usize] = Some(needed);
                        piece.push(other);
                    }
                    Some(found) if found != needed => return Err(one_sided(raw, edge)),
                    Some(_) => {}
                }
            }
        }
        let count = piece.iter().filter(|&&face| turned[face as usize] == Some(true)).count();
        // With normals at hand the faces follow them, else the smaller part follows the larger.
        let against: f64 = piece.iter().map(|&face| against_normals(raw, face, turned[face as usize])).sum();
        if against > 0.0 || (against == 0.0 && 2 * count > piece.len()) {
            for &face in &piece {
                turned[face as usize] = turned[face as usize].map(|turn| !turn);
            }
        }
    }
    for (face, turn) in raw.faces.iter_mut().zip(turned) {
        if turn == Some(true) {
            face.cell = reversed(&face.cell);
            result.faces += 1;
        }
    }
    Ok(result)
}

/// Parts that hang together over edges.
fn pieces(faces: usize, pairs: &[Pair]) -> usize {
    let mut parent: Vec<u32> = (0..faces as u32).collect();
    let mut count = faces;
    for pair in pairs {
        let [a, b] = pair.faces.map(|face| root(&mut parent, face));
        parent[a.max(b) as usize] = a.min(b);
        count -= usize::from(a != b);
    }
    count
}

/// Area by which a face (turned or not) looks away from the normals at its nodes; zero without normals.
fn against_normals(raw: &Raw, face: u32, turned: Option<bool>) -> f64 {
    let cell = raw.faces[face as usize].cell;
    let given: Vec3 = cell.particles().iter().filter_map(|node| raw.normals.get(node)).sum();
    if given == Vec3::zeros() {
        return 0.0;
    }
    let geometry = cell.geometry(&raw.positions);
    let along = geometry.area.copysign(geometry.normal.dot(&given));
    if turned == Some(true) { along } else { -along }
}

/// For each face its neighbours, whether they run opposite ways along the common edge, and that edge.
type Neighbours = Vec<Vec<(u32, bool, (u32, u32))>>;

fn neighbours(raw: &Raw, pairs: &[Pair]) -> Neighbours {
    let mut neighbours: Neighbours = vec![Vec::new(); raw.faces.len()];
    for &Pair { faces: [one, other], edge, agree, .. } in pairs.iter().filter(|pair| pair.bond != Bond::Place)
    {
        neighbours[one as usize].push((other, agree, edge));
        neighbours[other as usize].push((one, agree, edge));
    }
    neighbours
}

fn one_sided(raw: &Raw, (a, b): (u32, u32)) -> MeshError {
    let what = format!(
        "the surface has one side only (a Möbius strip): the faces at the edge between {} and {} cannot be turned the same way",
        raw.name(a),
        raw.name(b)
    );
    let repair = "cut the surface along a line across it, with nodes of their own on both lips";
    MeshError::at(raw.line_at(a), what, repair)
}

/// Refuses nodes where faces meet that are joined by no edge there: two fans touching at a point.
pub(super) fn refuse_pinched(raw: &Raw) -> Result<(), MeshError> {
    let sides = sides(&raw.faces);
    // Corners of faces, joined over common edges; each node must have one group of them.
    let mut parent: Vec<u32> = (0..4 * raw.faces.len() as u32).collect();
    let corner = |face: u32, node: u32| {
        let corners = raw.faces[face as usize].cell.corners;
        4 * face + corners.iter().position(|&c| c == node).unwrap_or(0) as u32
    };
    for pair in sides.windows(2) {
        let [one, other] = pair else { continue };
        if (one.low, one.high) != (other.low, other.high) {
            continue;
        }
        for node in [one.low, one.high] {
            let (a, b) =
                (root(&mut parent, corner(one.face, node)), root(&mut parent, corner(other.face, node)));
            parent[a.max(b) as usize] = a.min(b);
        }
    }
    let mut group = vec![None; raw.positions.len()];
    for (face, cell) in (0..).zip(raw.faces.iter().map(|face| face.cell)) {
        for &node in cell.particles() {
            let own = root(&mut parent, corner(face, node));
            if *group[node as usize].get_or_insert(own) != own {
                let what = format!("two parts of the surface meet in {} alone", raw.name(node));
                let repair = "give each part a node of its own there, or join the parts along an edge";
                return Err(MeshError::at(raw.faces[face as usize].line, what, repair));
            }
        }
    }
    Ok(())
}
