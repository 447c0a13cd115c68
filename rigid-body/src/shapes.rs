//! Closed surfaces of simple shapes: a ball, a cuboid.

use std::collections::BTreeMap;

use sph_core::{Cell, Vec3};

use crate::mass::Outline;

/// Edge of an icosahedron over the radius of the ball round it, `4/√(10 + 2√5)`.
const EDGE: f64 = 1.051_462_224_238_267_2;

/// A ball: an icosahedron whose faces are divided evenly into edges of about the spacing \[L\], vertices on the ball.
///
/// It has the planes of symmetry of the axes.
pub fn ball(centre: [f64; 3], radius: f64, spacing: f64) -> Outline {
    let parts = (EDGE * radius / spacing).ceil().max(1.0) as u32;
    let golden = 0.5 * (1.0 + 5.0_f64.sqrt());
    let mut corners = Vec::new();
    for axis in 0..3 {
        for (one, two) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
            let mut corner = Vec3::zeros();
            (corner[(axis + 1) % 3], corner[(axis + 2) % 3]) = (one, two * golden);
            corners.push(corner);
        }
    }
    let near = |a: usize, b: usize| ((corners[a] - corners[b]).norm() - 2.0).abs() < 1e-9;
    let (mut known, mut outline) = (BTreeMap::new(), Outline { vertices: Vec::new(), cells: Vec::new() });
    for a in 0..12 {
        for b in a + 1..12 {
            for c in b + 1..12 {
                if near(a, b) && near(b, c) && near(c, a) {
                    let outwards = corners[a].dot(&corners[b].cross(&corners[c])) > 0.0;
                    let face = if outwards { [a, b, c] } else { [a, c, b] };
                    divide(&corners, face, parts, &mut known, &mut outline);
                }
            }
        }
    }
    let place = |x: &mut Vec3| *x = Vec3::from(centre) + x.normalize() * radius;
    outline.vertices.iter_mut().for_each(place);
    outline
}

/// Divides a face into triangles; vertices are known by the corners that they stand between, and how near each.
fn divide(
    corners: &[Vec3],
    [a, b, c]: [usize; 3],
    parts: u32,
    known: &mut BTreeMap<Vec<(usize, u32)>, u32>,
    outline: &mut Outline,
) {
    let Outline { vertices, cells } = outline;
    let mut vertex = |i: u32, j: u32| {
        let shares = [(a, parts - i - j), (b, i), (c, j)];
        let mut key: Vec<(usize, u32)> = shares.into_iter().filter(|(_, share)| *share > 0).collect();
        key.sort_unstable();
        *known.entry(key.clone()).or_insert_with(|| {
            vertices.push(key.iter().map(|&(corner, share)| corners[corner] * f64::from(share)).sum());
            vertices.len() as u32 - 1
        })
    };
    for i in 0..parts {
        for j in 0..parts - i {
            cells.push(Cell::triangle([vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)]));
            if i + j + 1 < parts {
                cells.push(Cell::triangle([vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)]));
            }
        }
    }
}

/// A cuboid along the axes, its faces divided evenly into edges of about the spacing \[L\].
pub fn cuboid(min: [f64; 3], max: [f64; 3], spacing: f64) -> Outline {
    let parts = [0, 1, 2].map(|k| ((max[k] - min[k]) / spacing).round().max(1.0) as u32);
    let (mut known, mut outline) = (BTreeMap::new(), Outline { vertices: Vec::new(), cells: Vec::new() });
    for axis in 0..3 {
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        for end in [0, parts[axis]] {
            for i in 0..parts[u] {
                for j in 0..parts[v] {
                    let mut corner = |di: u32, dj: u32| {
                        let mut at = [0; 3];
                        (at[axis], at[u], at[v]) = (end, i + di, j + dj);
                        *known.entry(at).or_insert_with(|| {
                            let along = |k: usize| {
                                let share = f64::from(at[k]) / f64::from(parts[k]);
                                min[k] * (1.0 - share) + max[k] * share
                            };
                            outline.vertices.push(Vec3::new(along(0), along(1), along(2)));
                            outline.vertices.len() as u32 - 1
                        })
                    };
                    let round = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
                    let [a, b, c, d] = round;
                    let outwards = if end == 0 { [a, d, c, b] } else { round };
                    outline.cells.push(Cell::quadrangle(outwards));
                }
            }
        }
    }
    outline
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shapes_have_the_vertices_and_faces_of_euler() {
        let of = |outline: &Outline| {
            let sides: usize = outline.cells.iter().map(|cell| usize::from(cell.count)).sum();
            outline.vertices.len() + outline.cells.len() - sides / 2
        };
        for outline in
            [ball([0.0; 3], 1.0, 0.3), ball([0.0; 3], 1.0, 9.0), cuboid([0.0; 3], [1.0, 2.0, 3.0], 0.5)]
        {
            assert_eq!(of(&outline), 2);
        }
        assert_eq!(ball([0.0; 3], 1.0, 9.0).vertices.len(), 12);
        assert_eq!(cuboid([0.0; 3], [1.0; 3], 1.0).vertices.len(), 8);
        let far = ball([0.0, 0.0, 1.0], 2.0, 0.5);
        assert!(far.vertices.iter().all(|x| ((x - Vec3::z()).norm() - 2.0).abs() < 1e-14));
    }
}
