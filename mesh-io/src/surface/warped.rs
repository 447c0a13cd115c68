//! Quadrangles that are warped so far that one point in their middle does not stand for them: two triangles each.

use std::f64::consts::{FRAC_PI_2, PI};

use libm::atan2;
use sph_core::{Cell, Vec3};

/// Fold across a diagonal \[rad\] beyond which a quadrangle is cut. A twist that a mesh resolves turns by less from cell to cell.
pub(super) const WARPED: f64 = 0.5;
/// Sharpest corner \[rad\] that a half may have: clouds refuse 5°.
const SHARPEST: f64 = 6.0 * PI / 180.0;

/// Angles between the two triangles on either side of each diagonal of a quadrangle \[rad\]: from the first corner, from the second.
/// A flat one with a corner of more than 180° has π across the diagonal that runs outside it.
pub(super) fn folds(positions: &[Vec3], corners: [u32; 4]) -> [f64; 2] {
    let x = corners.map(|node| positions[node as usize]);
    [0, 1].map(|from| {
        let [a, b, c, d] = [0, 1, 2, 3].map(|i| x[(i + from) % 4]);
        let (one, other) = ((b - a).cross(&(c - a)), (c - a).cross(&(d - a)));
        atan2(one.cross(&other).norm(), one.dot(&other))
    })
}

/// The two triangles of a quadrangle that folds by more than [`WARPED`] across one of its diagonals, cut along the one across which it
/// folds less; none of other faces, of those that cross themselves, and where a half would be a sliver.
pub(super) fn halves(positions: &[Vec3], face: &Cell) -> Option<[Cell; 2]> {
    if face.count != 4 {
        return None;
    }
    let folds = folds(positions, face.corners);
    let from = usize::from(folds[1] < folds[0]);
    if folds[0].max(folds[1]) <= WARPED || folds[from] >= FRAC_PI_2 {
        return None;
    }
    let [a, b, c, d] = [0, 1, 2, 3].map(|i| face.corners[(i + from) % 4]);
    let halves = [[a, b, c], [a, c, d]];
    let sound = halves.iter().all(|half| sharpest(positions, *half) > SHARPEST);
    sound.then(|| halves.map(Cell::triangle))
}

/// Sharpest corner of a triangle \[rad\].
fn sharpest(positions: &[Vec3], corners: [u32; 3]) -> f64 {
    let x = corners.map(|node| positions[node as usize]);
    let angle = |i: usize| (x[(i + 1) % 3] - x[i]).angle(&(x[(i + 2) % 3] - x[i]));
    [0, 1, 2].map(angle).into_iter().fold(PI, f64::min)
}
