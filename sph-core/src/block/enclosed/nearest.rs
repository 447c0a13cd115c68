//! The place of a triangle that is nearest to a point, and that of an edge.

use crate::Vec3;

/// The place of a segment that is nearest to x.
pub(super) fn on_edge(x: &Vec3, [a, b]: [Vec3; 2]) -> Vec3 {
    let edge = b - a;
    let square = edge.norm_squared();
    let part = if square > 0.0 { ((x - a).dot(&edge) / square).clamp(0.0, 1.0) } else { 0.0 };
    a + edge * part
}

/// The place of a triangle that is nearest to x.
pub(super) fn on_triangle(x: &Vec3, [a, b, c]: [Vec3; 3]) -> Vec3 {
    let normal = (b - a).cross(&(c - a));
    let within = |p: Vec3, q: Vec3| (q - p).cross(&(x - p)).dot(&normal) >= 0.0;
    if normal.norm_squared() > 0.0 && within(a, b) && within(b, c) && within(c, a) {
        return x - normal * ((x - a).dot(&normal) / normal.norm_squared());
    }
    let edges = [[a, b], [b, c], [c, a]].map(|edge| on_edge(x, edge));
    let nearer = |p: Vec3, q: Vec3| if (q - x).norm_squared() < (p - x).norm_squared() { q } else { p };
    nearer(nearer(edges[0], edges[1]), edges[2])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_over_the_face_beside_an_edge_and_beyond_a_corner() {
        let triangle = [Vec3::zeros(), Vec3::new(2.0, 0.0, 0.0), Vec3::new(0.0, 2.0, 0.0)];
        for (x, wanted) in [
            ([0.5, 0.5, 3.0], [0.5, 0.5, 0.0]),
            ([1.0, -1.0, 1.0], [1.0, 0.0, 0.0]),
            ([-1.0, -2.0, 1.0], [0.0, 0.0, 0.0]),
            ([2.0, 2.0, -1.0], [1.0, 1.0, 0.0]),
        ] {
            let found = on_triangle(&x.into(), triangle);
            assert!((found - Vec3::from(wanted)).norm() < 1e-15, "{found}");
        }
    }
}
