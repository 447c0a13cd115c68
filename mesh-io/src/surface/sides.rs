//! Edges as the faces have them, and what is joined over them.

use super::raw::Face;

/// An edge as one face has it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Side {
    pub low: u32,
    pub high: u32,
    pub face: u32,
    /// Whether the face goes from the lower to the higher node.
    pub forward: bool,
}

/// Every edge of every face, those of the same two nodes together.
pub(super) fn sides(faces: &[Face]) -> Vec<Side> {
    let mut sides: Vec<Side> = Vec::new();
    for (face, cell) in faces.iter().map(|face| face.cell).enumerate() {
        let side =
            |(a, b): (u32, u32)| Side { low: a.min(b), high: a.max(b), face: face as u32, forward: a < b };
        sides.extend(cell.edges().map(side));
    }
    sides.sort_unstable();
    sides
}

/// The representative of an entry, and of all that were joined to it.
pub(super) fn root(parent: &mut [u32], mut entry: u32) -> u32 {
    while parent[entry as usize] != entry {
        // Halving the path keeps it short.
        parent[entry as usize] = parent[parent[entry as usize] as usize];
        entry = parent[entry as usize];
    }
    entry
}
