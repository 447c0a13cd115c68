//! Edge flips: a triangulation of a parameter plane made Delaunay on the surface itself.

use crate::Vec3;

/// Sum of the two angles that face an edge above which it is flipped, beyond π: rounding and four particles on one
/// circle flip nothing.
const BEYOND_PI: f64 = 1e-9;

/// Cosine of the largest angle by which a flip may turn a triangle against the two it replaces: surfaces sampled well
/// are flatter, and a flip that folds the sheet is refused.
const TURN: f64 = 0.5;

/// Bound on flips per edge: chords of a curved surface are no plane metric, so that termination is not proved.
const MOST_FLIPS: usize = 20;

/// Flips edges until the angles that face each add up to at most π (Lawson's flips \[lawson1977\], angles in space).
///
/// Triangles keep their orientation and come back sorted, each from its lowest particle.
pub(crate) fn flip_to_delaunay(positions: &[Vec3], triangles: &mut [[u32; 3]]) {
    let mut across = neighbours(triangles);
    let mut stack: Vec<(usize, usize)> =
        (0..triangles.len()).flat_map(|t| (0..3).map(move |k| (t, k))).collect();
    let mut left = MOST_FLIPS * stack.len();
    while let Some((t, k)) = stack.pop() {
        let Some((s, l)) = across[t][k] else { continue };
        // t = (a, b, c) and s = (b, a, d) share the edge a–b.
        let (a, b, c) = (triangles[t][k], triangles[t][(k + 1) % 3], triangles[t][(k + 2) % 3]);
        let d = triangles[s][(l + 2) % 3];
        if left == 0 || !better(positions, [a, b, c, d]) {
            continue;
        }
        left -= 1;
        // Outer edges b–c, c–a of t and a–d, d–b of s find their places in (a, d, c) and (d, b, c).
        let (bc, ca) = (across[t][(k + 1) % 3], across[t][(k + 2) % 3]);
        let (ad, db) = (across[s][(l + 1) % 3], across[s][(l + 2) % 3]);
        triangles[t] = [a, d, c];
        triangles[s] = [d, b, c];
        across[t] = [ad, Some((s, 2)), ca];
        across[s] = [db, bc, Some((t, 1))];
        for (triangle, edge) in [(t, 0), (t, 2), (s, 0), (s, 1)] {
            if let Some((other, place)) = across[triangle][edge] {
                across[other][place] = Some((triangle, edge));
            }
            stack.push((triangle, edge));
        }
    }
    for corners in triangles.iter_mut() {
        let lowest = (0..3).min_by_key(|&i| corners[i]).unwrap_or(0);
        corners.rotate_left(lowest);
    }
    triangles.sort_unstable();
}

/// For each edge of each triangle (corner k to k + 1) the triangle across and its edge.
fn neighbours(triangles: &[[u32; 3]]) -> Vec<[Option<(usize, usize)>; 3]> {
    let mut edges: Vec<(u32, u32, usize, usize)> = Vec::new();
    for (t, corners) in triangles.iter().enumerate() {
        for k in 0..3 {
            let (a, b) = (corners[k], corners[(k + 1) % 3]);
            edges.push((a.min(b), a.max(b), t, k));
        }
    }
    edges.sort_unstable();
    let mut across = vec![[None; 3]; triangles.len()];
    for shared in edges.chunk_by(|e, f| (e.0, e.1) == (f.0, f.1)) {
        if let [(_, _, t, k), (_, _, s, l)] = *shared {
            across[t][k] = Some((s, l));
            across[s][l] = Some((t, k));
        }
    }
    across
}

/// Whether the diagonal c–d is better than a–b in the quadrangle a, d, b, c.
fn better(positions: &[Vec3], [a, b, c, d]: [u32; 4]) -> bool {
    let [a, b, c, d] = [a, b, c, d].map(|p| positions[p as usize]);
    let angle = |at: Vec3, p: Vec3, q: Vec3| {
        let (p, q) = (p - at, q - at);
        libm::atan2(p.cross(&q).norm(), p.dot(&q))
    };
    let vector = |p: Vec3, q: Vec3, r: Vec3| (q - p).cross(&(r - p));
    let old = (vector(a, b, c) + vector(b, a, d)).normalize();
    let along = |v: Vec3| v.dot(&old) > TURN * v.norm();
    angle(c, a, b) + angle(d, a, b) > std::f64::consts::PI + BEYOND_PI
        && along(vector(a, d, c))
        && along(vector(d, b, c))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_long_diagonal_of_a_kite_is_flipped() {
        let x = [[0.0, 0.0], [1.0, 0.2], [2.0, 0.0], [1.0, -0.2]].map(|x| Vec3::new(x[0], x[1], 0.0));
        let mut triangles = [[0, 2, 1], [0, 3, 2]];
        flip_to_delaunay(&x, &mut triangles);
        assert_eq!(triangles, [[0, 3, 1], [1, 3, 2]]);
    }

    #[test]
    fn a_rotten_fan_becomes_delaunay() {
        // Twelve particles on a circle all joined to the first, and one in the middle of a triangle: every flip order must end.
        let place = |i: usize| 0.5 * i as f64 + 0.01 * (i * i) as f64;
        let x: Vec<Vec3> = (0..12)
            .map(|i| Vec3::new(libm::cos(place(i)), (1.0 + 0.05 * i as f64) * libm::sin(place(i)), 0.0))
            .collect();
        let mut triangles: Vec<[u32; 3]> = (1..11).map(|i| [0, i, i + 1]).collect();
        let area = |list: &[[u32; 3]]| -> f64 {
            let corner = |b: u32| x[b as usize];
            list.iter()
                .map(|t| 0.5 * (corner(t[1]) - corner(t[0])).cross(&(corner(t[2]) - corner(t[0]))).z)
                .sum()
        };
        let before = area(&triangles);
        flip_to_delaunay(&x, &mut triangles);
        assert!((area(&triangles) - before).abs() < 1e-12);
        let across = neighbours(&triangles);
        for (t, corners) in triangles.iter().enumerate() {
            for k in 0..3 {
                let Some((s, l)) = across[t][k] else { continue };
                let quadrangle =
                    [corners[k], corners[(k + 1) % 3], corners[(k + 2) % 3], triangles[s][(l + 2) % 3]];
                assert!(!better(&x, quadrangle), "{quadrangle:?}");
            }
        }
    }
}
