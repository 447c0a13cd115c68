//! The surface of a body of tetrahedra: the faces that one of them has alone.

use std::collections::HashMap;

use super::MeshError;
use super::raw::{Face, Raw};
use sph_core::Cell;

/// A tetrahedron as the file has it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tetrahedron {
    /// Nodes, by index.
    pub corners: [u32; 4],
    /// Number in the file.
    pub label: u64,
    /// Line of the file.
    pub line: usize,
}

/// Puts the faces that bound the tetrahedra, outward, in place of those of the file; returns what became of each of these: where it is
/// now, if it bounds them.
///
/// # Errors
/// [`MeshError`] for a tetrahedron without volume, and for a face of more than two.
pub(super) fn bounded(raw: &mut Raw, solids: &[Tetrahedron]) -> Result<Vec<Option<u32>>, MeshError> {
    let mut faces: HashMap<[u32; 3], (u32, [u32; 3], Tetrahedron)> = HashMap::new();
    for solid in solids {
        let [a, mut b, mut c, d] = solid.corners;
        let at = |node: u32| raw.positions[node as usize] - raw.positions[a as usize];
        let six_volumes = at(b).cross(&at(c)).dot(&at(d));
        if six_volumes < 0.0 {
            (b, c) = (c, b);
        } else if six_volumes == 0.0 || six_volumes.is_nan() {
            let what = format!("tetrahedron {} has no volume", solid.label);
            return Err(MeshError::at(solid.line, what, "move its nodes apart, or mesh the body anew"));
        }
        for face in [[a, c, b], [a, b, d], [b, c, d], [a, d, c]] {
            let (count, ..) =
                faces.entry(sorted(face)).and_modify(|found| found.0 += 1).or_insert((1, face, *solid));
            if *count > 2 {
                let what = format!("a face of tetrahedron {} belongs to more than two", solid.label);
                return Err(MeshError::at(solid.line, what, "remove those that lie on each other"));
            }
        }
    }
    let mut outer: Vec<(u64, [u32; 3], Tetrahedron)> = faces
        .into_values()
        .filter(|(count, ..)| *count == 1)
        .map(|(_, face, solid)| (solid.label, face, solid))
        .collect();
    outer.sort_unstable_by_key(|(label, face, _)| (*label, *face));
    // A file may have a face once for each group that it belongs to.
    let mut given: HashMap<[u32; 3], Vec<usize>> = HashMap::new();
    for (number, face) in raw.faces.iter().enumerate().filter(|(_, face)| face.cell.count == 3) {
        let [a, b, c, _] = face.cell.corners;
        given.entry(sorted([a, b, c])).or_default().push(number);
    }
    let mut numbers = vec![None; raw.faces.len()];
    let mut all = Vec::with_capacity(outer.len());
    for (number, (_, corners, solid)) in (0..).zip(outer) {
        let named = given.get(&sorted(corners)).map_or(&[][..], Vec::as_slice);
        named.iter().for_each(|&known| numbers[known] = Some(number));
        let (label, line) = match named.first() {
            Some(&known) => (raw.faces[known].label, raw.faces[known].line),
            None => (solid.label, solid.line),
        };
        all.push(Face { cell: Cell::triangle(corners), label, line });
    }
    let within = numbers.iter().filter(|number| number.is_none()).count();
    if within > 0 {
        raw.notes.push(format!("faces that do not bound the tetrahedra, left out: {within}"));
    }
    raw.notes.push(format!("{} tetrahedra are bounded by {} triangles", solids.len(), all.len()));
    raw.faces = all;
    Ok(numbers)
}

fn sorted(mut corners: [u32; 3]) -> [u32; 3] {
    corners.sort_unstable();
    corners
}
