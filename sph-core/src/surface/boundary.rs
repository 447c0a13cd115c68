//! Edges of a quadrangulation: which lie on the boundary, and whether the cells fit together.

use crate::Vec3;
use crate::error::SpaceError;
use crate::surface::cell::Cell;

/// Outward normals and lengths that the boundary gives to each particle.
pub(crate) struct Boundary {
    /// Outward in-surface normal × tributary edge length `[L]`; zero inside.
    pub normals: Vec<Vec3>,
    /// Tributary boundary length `[L]`; zero inside.
    pub lengths: Vec<f64>,
}

/// Directed edges that one cell only uses, in the order of their particles.
///
/// Refuses edges with three or more cells, neighbours that turn opposite ways, and sheets with one side only.
pub(crate) fn boundary_edges(cells: &[Cell]) -> Result<Vec<(u32, u32)>, SpaceError> {
    let mut edges: Vec<(u32, u32, usize, bool)> = Vec::new();
    for (c, cell) in cells.iter().enumerate() {
        for (a, b) in cell.edges() {
            edges.push((a.min(b), a.max(b), c, a < b));
        }
    }
    edges.sort_unstable();
    let (mut open, mut inner, mut clash) = (Vec::new(), Vec::new(), None);
    for shared in edges.chunk_by(|e, f| (e.0, e.1) == (f.0, f.1)) {
        let (a, b, cell, forward) = shared[0];
        let (first, second) = (a as usize, b as usize);
        match *shared {
            [_] => open.push(if forward { (a, b) } else { (b, a) }),
            [_, (_, _, other, way)] => {
                let bond = Bond { cell, other, agree: way != forward, first, second };
                if !bond.agree && clash.is_none() {
                    clash = Some(bond);
                }
                inner.push(bond);
            }
            _ => return Err(SpaceError::NonManifoldEdge { first, second, cells: shared.len() }),
        }
    }
    let Some(Bond { cell, other, first, second, .. }) = clash else { return Ok(open) };
    Err(match one_sided(cells.len(), &inner) {
        Some(Bond { cell, other, first, second, .. }) => {
            SpaceError::NonOrientable { cell, other, first, second }
        }
        None => SpaceError::Orientation { cell, other, first, second },
    })
}

/// An edge between two cells.
#[derive(Clone, Copy)]
struct Bond {
    cell: usize,
    other: usize,
    /// Whether the two run along it in opposite ways, as neighbours on one side do.
    agree: bool,
    first: usize,
    second: usize,
}

/// An edge at which two cells clash whichever cells are reversed; none if reversing can mend all.
fn one_sided(cells: usize, inner: &[Bond]) -> Option<Bond> {
    let mut at = vec![Vec::new(); cells];
    for bond in inner {
        at[bond.cell].push(bond);
        at[bond.other].push(bond);
    }
    let mut reversed: Vec<Option<bool>> = vec![None; cells];
    for start in 0..cells {
        let mut stack = vec![start];
        reversed[start].get_or_insert(false);
        while let Some(cell) = stack.pop() {
            for bond in &at[cell] {
                let next = if bond.cell == cell { bond.other } else { bond.cell };
                let needed = reversed[cell].map(|reversed| reversed == bond.agree);
                match reversed[next] {
                    None => {
                        reversed[next] = needed;
                        stack.push(next);
                    }
                    found if found != needed => return Some(**bond),
                    Some(_) => {}
                }
            }
        }
    }
    None
}

/// Shares each boundary edge between its two ends: a particle gets half the edge, rotated outward in its own tangent
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
