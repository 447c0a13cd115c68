//! Whether triangles of a surface pass through each other.

use crate::Vec3;

/// Part of the size of two triangles below which a corner lies in the plane of the other.
const TOUCHING: f64 = 1e-9;

/// A place where an edge of one triangle passes through another one; where they only touch they do not cross.
///
/// Boxes round the triangles are swept along the longest axis.
pub(super) fn crossing(triangles: impl Iterator<Item = [Vec3; 3]>, extent: Vec3) -> Option<Vec3> {
    let axis = extent.imax();
    let mut boxes: Vec<(Vec3, Vec3, [Vec3; 3])> =
        triangles.map(|[a, b, c]| (a.inf(&b).inf(&c), a.sup(&b).sup(&c), [a, b, c])).collect();
    boxes.sort_by(|one, other| one.0[axis].total_cmp(&other.0[axis]));
    for (number, (low, high, one)) in boxes.iter().enumerate() {
        for (other_low, other_high, other) in &boxes[number + 1..] {
            if other_low[axis] > high[axis] {
                break;
            }
            if (0..3).any(|k| other_low[k] > high[k] || other_high[k] < low[k]) {
                continue;
            }
            if let Some(place) = through(one, other).or_else(|| through(other, one)) {
                return Some(place);
            }
        }
    }
    None
}

/// Where an edge of the first triangle passes through the second one.
fn through(one: &[Vec3; 3], other: &[Vec3; 3]) -> Option<Vec3> {
    let [a, b, c] = *other;
    let normal = (b - a).cross(&(c - a)).normalize();
    let heights = one.map(|x| normal.dot(&(x - a)));
    [(0, 1), (1, 2), (2, 0)].into_iter().find_map(|(from, to)| {
        let (p, q) = (one[from], one[to]);
        let near = TOUCHING * (q - p).norm().max((b - a).norm());
        let [start, end] = [heights[from], heights[to]];
        if start.abs() <= near || end.abs() <= near || (start > 0.0) == (end > 0.0) {
            return None;
        }
        let place = p + (q - p) * (start / (start - end));
        // Distances from the edges of the second triangle, in its plane.
        let inside = [(a, b), (b, c), (c, a)].into_iter().all(|(from, to)| {
            let along = (to - from).normalize();
            normal.cross(&along).dot(&(place - from)) > near
        });
        inside.then_some(place)
    })
}
