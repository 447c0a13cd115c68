//! Edges of a quadrangulation: which lie on the boundary, and whether the cells fit together.

use crate::{Cell, SpaceError, Vec3};

/// Outward normals and lengths that the boundary gives to each particle.
pub(crate) struct Boundary {
    /// Outward in-surface normal × tributary edge length `[L]`; zero inside.
    pub normals: Vec<Vec3>,
    /// Tributary boundary length `[L]`; zero inside.
    pub lengths: Vec<f64>,
}

/// Directed edges that one cell only uses, in the order of their particles.
///
/// Refuses edges with three or more cells, and neighbours that turn opposite ways.
pub(crate) fn boundary_edges(cells: &[Cell]) -> Result<Vec<(u32, u32)>, SpaceError> {
    let mut edges: Vec<(u32, u32, usize, bool)> = Vec::new();
    for (c, cell) in cells.iter().enumerate() {
        for (a, b) in cell.edges() {
            edges.push((a.min(b), a.max(b), c, a < b));
        }
    }
    edges.sort_unstable();
    let mut open = Vec::new();
    for shared in edges.chunk_by(|e, f| (e.0, e.1) == (f.0, f.1)) {
        let (a, b, cell, forward) = shared[0];
        let (first, second) = (a as usize, b as usize);
        match shared {
            [_] => open.push(if forward { (a, b) } else { (b, a) }),
            [_, other] if other.3 != forward => {}
            [_, other] => return Err(SpaceError::Orientation { cell, other: other.2, first, second }),
            _ => return Err(SpaceError::NonManifoldEdge { first, second, cells: shared.len() }),
        }
    }
    Ok(open)
}

/// Shares each boundary edge between its two ends: a particle gets half the edge, turned outward in its own tangent
/// plane, `r_a = Σ_edges ½ (X_end − X_start) × n_a`. For a closed flat outline `Σ r_a = 0`.
pub(crate) fn boundary(positions: &[Vec3], normals: &[Vec3], cells: &[Cell]) -> Result<Boundary, SpaceError> {
    let mut shared =
        Boundary { normals: vec![Vec3::zeros(); positions.len()], lengths: vec![0.0; positions.len()] };
    for (start, end) in boundary_edges(cells)? {
        let half = 0.5 * (positions[end as usize] - positions[start as usize]);
        for a in [start as usize, end as usize] {
            shared.normals[a] += half.cross(&normals[a]);
            shared.lengths[a] += half.norm();
        }
    }
    Ok(shared)
}
