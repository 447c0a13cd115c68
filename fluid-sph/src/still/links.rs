//! What each cell of still water has on its sides: another cell, the free surface, or nothing that water passes.

use sph_core::{CellList, Vec3};

use super::{Screen, StillError, StillParts};

/// Distance from where a neighbour should stand within which a particle is it, in spacings.
const ALIKE: f64 = 0.1;
/// The same of particles of other rows, which no neighbour on a lattice is.
const BESIDE: f64 = 0.75;
/// Distance from where a neighbour should stand within which a particle of a wall takes its place, in spacings: rows lie half a spacing
/// behind faces and their particles a spacing apart at most; those of a wall along the way are a spacing off.
const WALL: f64 = 0.8;
/// How far beyond half a cell a shell may begin that bounds it, in spacings: as far as a site reaches to its water.
const GAP: f64 = 0.5 + 1e-6;
/// Part of a triangle or a line by which it is wider, so that none slips through between two.
const WIDER: f64 = 1e-9;

/// What a cell has on one side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Link {
    /// A neighbour.
    To(u32),
    /// The free surface.
    Open,
    /// A wall or a shell.
    Closed,
}

/// The unit vector to a side: −x, x, −y, y, −z, z.
pub(super) fn way(side: usize) -> Vec3 {
    let mut way = Vec3::zeros();
    way[side / 2] = if side.is_multiple_of(2) { -1.0 } else { 1.0 };
    way
}

/// Looks at the sides of all cells; those of a third axis in a plane are closed.
pub(super) fn links(
    parts: &StillParts<'_>,
    list: &CellList,
    walls: &CellList,
) -> Result<Vec<[Link; 6]>, StillError> {
    let &StillParts { dimensions, spacing, positions, .. } = parts;
    let screened = screened(parts, list);
    let mut near = Vec::new();
    let mut all = vec![[Link::Closed; 6]; positions.len()];
    for (cell, own) in all.iter_mut().enumerate() {
        for (side, link) in own.iter_mut().enumerate().take(2 * dimensions) {
            let there = positions[cell] + way(side) * spacing;
            let (way, half) = screened[cell][side];
            list.within(&there, ALIKE * spacing, &mut near);
            if let Some(&other) = near.first() {
                // Either of both may see it first where a shell begins between them.
                let back = screened[other as usize][side ^ 1].0;
                if way.min(back) > spacing {
                    *link = Link::To(other);
                }
                continue;
            }
            if way <= (0.5 + GAP) * spacing + half {
                continue;
            }
            walls.within(&there, WALL * spacing, &mut near);
            if !near.is_empty() {
                continue;
            }
            list.within(&there, BESIDE * spacing, &mut near);
            if !near.is_empty() {
                return Err(StillError::Shifted { at: there.into() });
            }
            *link = Link::Open;
        }
    }
    Ok(all)
}

/// How far each cell is from the first shell on each side, and half the thickness of that \[L\]; infinite where none is near.
fn screened(parts: &StillParts<'_>, list: &CellList) -> Vec<[(f64, f64); 6]> {
    let &StillParts { dimensions, spacing, positions, screens, .. } = parts;
    let mut all = vec![[(f64::INFINITY, 0.0); 6]; positions.len()];
    let mut near = Vec::new();
    for screen in screens {
        let corners = &screen.corners[..dimensions];
        let middle = corners.iter().sum::<Vec3>() / dimensions as f64;
        let radius = corners.iter().map(|x| (x - middle).norm()).fold(0.0, f64::max);
        list.within(&middle, radius + 2.0 * spacing + screen.half, &mut near);
        for &cell in &near {
            for (side, first) in all[cell as usize].iter_mut().enumerate().take(2 * dimensions) {
                if let Some(far) = hit(&positions[cell as usize], side, screen, dimensions)
                    && far < first.0
                {
                    *first = (far, screen.half);
                }
            }
        }
    }
    all
}

/// Way from a place to a screen along an axis \[L\]; none past it, behind the place or along the screen.
fn hit(from: &Vec3, side: usize, screen: &Screen, dimensions: usize) -> Option<f64> {
    let (axis, [a, b, c]) = (side / 2, screen.corners.map(|corner| corner - from));
    let at = if dimensions == 2 {
        let other = 1 - axis;
        let across = a[other] - b[other];
        let part = a[other] / across;
        let within = across.abs() > WIDER * (a - b).norm() && (-WIDER..=1.0 + WIDER).contains(&part);
        within.then(|| a[axis] + part * (b[axis] - a[axis]))?
    } else {
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        let area = |p: &Vec3, q: &Vec3| p[u] * q[v] - p[v] * q[u];
        let parts = [area(&b, &c), area(&c, &a), area(&a, &b)];
        let whole: f64 = parts.iter().sum();
        let size = (b - a).cross(&(c - a)).norm();
        let within = whole.abs() > WIDER * size && parts.iter().all(|part| part / whole >= -WIDER);
        within.then(|| (parts[0] * a[axis] + parts[1] * b[axis] + parts[2] * c[axis]) / whole)?
    };
    let far = at * way(side)[axis];
    (far >= 0.0).then_some(far)
}
