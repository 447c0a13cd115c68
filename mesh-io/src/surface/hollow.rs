//! Quadrangles with a corner beyond 180°: cut in two where one of their diagonals lies inside, refused where they cross themselves.
//!
//! One point in the middle stands for a convex cell. A hollow one has a diagonal inside, from the corner beyond 180° to the one across, and
//! triangles stand for its halves. Where neither diagonal leaves two triangles that face the same way, the edges cross: no cell has
//! such a boundary.

use sph_core::{Cell, Vec3};

/// How a face becomes cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Shape {
    /// A triangle, or a quadrangle without a corner beyond 180°.
    Convex,
    /// A quadrangle with one, and its halves.
    Hollow([Cell; 2]),
    /// A quadrangle whose edges cross, or that is folded onto itself.
    Crossed,
}

/// The shape of a face, seen along its mean normal.
pub(super) fn shape(face: &Cell, positions: &[Vec3]) -> Shape {
    let &[a, b, c, d] = face.particles() else { return Shape::Convex };
    let normal = face.geometry(positions).normal;
    // Twice the area of a triangle, seen along the normal.
    let seen = |[a, b, c]: [u32; 3]| {
        let [a, b, c] = [a, b, c].map(|node| positions[node as usize]);
        (b - a).cross(&(c - a)).dot(&normal)
    };
    let by_diagonals = [[[a, b, c], [a, c, d]], [[a, b, d], [b, c, d]]];
    let sound = by_diagonals.map(|halves| halves.into_iter().all(|half| seen(half) > 0.0));
    match sound {
        [true, true] => Shape::Convex,
        [false, false] => Shape::Crossed,
        [first, _] => Shape::Hollow(by_diagonals[usize::from(!first)].map(Cell::triangle)),
    }
}
