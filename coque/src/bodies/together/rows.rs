//! How many rows of nodes a contact of a solid spans, from the rim of what touches to its middle.
//!
//! A node that touches is on the rim if a neighbour along the face does not; the next ones inward are the second row. So planes of symmetry and
//! the direction along a drum in plane strain have no rim, and a face that touches all over has none at all.

use std::collections::{BTreeMap, VecDeque};

use sph_core::{Cell, CellList, Vec3};

use crate::bodies::contact_now::Spanned;

/// Cosine of the angle to the normal of a contact below which a neighbour lies along the face.
const ALONG: f64 = 0.5;
/// Distance of neighbours on a lattice over its spacing: less than that along a diagonal.
const NEXT: f64 = 1.3;

/// Neighbours along the surface of a solid, and what its contacts want.
#[derive(Clone, Debug)]
pub(in crate::bodies) struct Rows {
    next: BTreeMap<u32, Vec<u32>>,
    method: Method,
}

/// What resolves the contact.
#[derive(Clone, Copy, Debug)]
enum Method {
    /// Bonds of a horizon, in spacings.
    Bonds(f64),
    /// Shape functions of a radius, in spacings.
    Galerkin(f64),
}

impl Rows {
    /// Those of a lattice of bonds of a horizon in spacings; inside of it nothing touches.
    pub fn of_lattice(nodes: &[Vec3], spacing: [f64; 3], horizon: f64) -> Self {
        let scaled: Vec<Vec3> = nodes.iter().map(|x| x.component_div(&Vec3::from(spacing))).collect();
        let boxes = CellList::new(&scaled, NEXT);
        let (mut next, mut near) = (BTreeMap::new(), Vec::new());
        for (a, place) in (0..).zip(&scaled) {
            boxes.within(place, NEXT, &mut near);
            near.retain(|&b| b != a);
            if near.len() < 6 {
                next.insert(a, near.clone());
            }
        }
        Self { next, method: Method::Bonds(horizon) }
    }

    /// Those of the outer faces of cells; shape functions have a radius in spacings.
    pub fn of_faces(faces: &[Cell], radius: f64) -> Self {
        let mut next: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
        for face in faces {
            let count = usize::from(face.count);
            for i in 0..count {
                let [a, b] = [face.corners[i], face.corners[(i + 1) % count]];
                next.entry(a).or_default().push(b);
                next.entry(b).or_default().push(a);
            }
        }
        for near in next.values_mut() {
            near.sort_unstable();
            near.dedup();
        }
        Self { next, method: Method::Galerkin(radius) }
    }

    /// The rows of what touches, nodes with the normals of their contacts, where a node is at a place \[L\]; none if nothing touches. Of several
    /// patches the widest counts.
    pub fn spanned(&self, touching: &BTreeMap<u32, Vec3>, at: impl Fn(u32) -> Vec3) -> Option<Spanned> {
        let wanted = self.method.wanted();
        let known = || touching.keys().filter_map(|a| Some((*a, self.next.get(a)?)));
        known().next()?;
        let on_rim = |a: u32, near: &[u32]| {
            let (here, normal) = (at(a), touching[&a]);
            near.iter().any(|b| {
                let way = at(*b) - here;
                !touching.contains_key(b) && way.dot(&normal).abs() < ALONG * way.norm() * normal.norm()
            })
        };
        let mut row: BTreeMap<u32, u32> =
            known().filter(|&(a, near)| on_rim(a, near)).map(|(a, _)| (a, 1)).collect();
        let mut queue: VecDeque<u32> = row.keys().copied().collect();
        while let Some(a) = queue.pop_front() {
            let inward = row[&a] + 1;
            for &b in &self.next[&a] {
                if self.next.contains_key(&b) && touching.contains_key(&b) && !row.contains_key(&b) {
                    row.insert(b, inward);
                    queue.push_back(b);
                }
            }
        }
        // What no rim leads to touches all over.
        let rows = known().map(|(a, _)| row.get(&a).copied().unwrap_or(wanted)).fold(0, u32::max);
        Some(self.method.said(rows.min(wanted)))
    }
}

impl Method {
    /// Rows from which on greatest pressures under drums and balls are right to 3 %: of bonds one and a half horizons, of shape functions the more the
    /// narrower they are.
    fn wanted(self) -> u32 {
        let rows = match self {
            Self::Bonds(horizon) => 1.5 * horizon.floor(),
            Self::Galerkin(radius) => 6.0 / radius,
        };
        libm::ceil(rows).clamp(3.0, 100.0) as u32
    }

    /// So many rows with the errors of greatest pressures that were measured at them, rounded up.
    fn said(self, rows: u32) -> Spanned {
        let off = match (self, rows) {
            (Self::Bonds(horizon), _) => (11.0 * (horizon / f64::from(rows)).powi(2)).min(35.0),
            (_, 1) => 32.0,
            (_, 2) => 22.0,
            (_, 3) => 8.0,
            _ => 4.0,
        };
        Spanned { rows, wanted: self.wanted(), off }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A lattice of 9 × 9 × 3 of unit spacing, horizon of three: five rows are wanted.
    fn lattice() -> (Vec<Vec3>, Rows) {
        let place = |i: u32| Vec3::new(f64::from(i % 9), f64::from(i / 9 % 9), f64::from(i / 81));
        let nodes: Vec<Vec3> = (0..243).map(place).collect();
        let rows = Rows::of_lattice(&nodes, [1.0; 3], 3.015);
        (nodes, rows)
    }

    fn found(touches: impl Fn(&Vec3) -> bool) -> Option<u32> {
        let (nodes, rows) = lattice();
        let touching = (0..).zip(&nodes).filter(|(_, x)| touches(x)).map(|(a, _)| (a, Vec3::z())).collect();
        rows.spanned(&touching, |a| nodes[a as usize]).map(|own| own.rows)
    }

    #[test]
    fn rows_are_counted_from_the_rim_inward() {
        let top = |x: &Vec3| x.z == 2.0;
        assert_eq!(found(|_| false), None);
        // A strip across the lattice of one, three and four rows, and one at a side, as on a plane of symmetry.
        assert_eq!(found(|x| top(x) && x.x == 4.0), Some(1));
        assert_eq!(found(|x| top(x) && (x.x - 4.0).abs() < 1.5), Some(2));
        assert_eq!(found(|x| top(x) && x.x > 2.5 && x.x < 6.5), Some(2));
        assert_eq!(found(|x| top(x) && x.x < 3.5), Some(4));
        // A disc of a radius of 2.1 about the middle, and about a corner.
        assert_eq!(found(|x| top(x) && libm::hypot(x.x - 4.0, x.y - 4.0) < 2.1), Some(3));
        assert_eq!(found(|x| top(x) && libm::hypot(x.x, x.y) < 2.1), Some(3));
        // A face that touches all over has no rim: neighbours below it lie across.
        assert_eq!(found(top), Some(5));
    }

    #[test]
    fn narrow_shape_functions_want_more_rows() {
        let wanted = |radius| Method::Galerkin(radius).wanted();
        assert_eq!([1.2, 1.5, 2.0, 2.6].map(wanted), [5, 4, 3, 3]);
        let wanted = |horizon| Method::Bonds(horizon).wanted();
        assert_eq!([2.015, 3.015, 4.015].map(wanted), [3, 5, 6]);
    }
}
