//! From quadrature points to nodes: stress, strain and angle by a plane through the values round a node.

use nalgebra::{Matrix3, Matrix4, Vector4};
use sph_core::Vec3;
use sr_galerkin::PointResult;

/// Numbers at a node: stress, strain, angle.
pub(super) const RECOVERED: usize = 13;
/// Fewest points through which a plane is laid; of fewer the mean is taken.
const FEWEST: usize = 8;

/// Stress, strain and angle of a point.
pub(super) fn all_of(point: &PointResult) -> [f64; RECOVERED] {
    std::array::from_fn(|i| match i {
        0..6 => point.stress[i],
        6..12 => point.strain[i - 6],
        _ => point.angle,
    })
}

/// Stress `xx, yy, zz, xy, yz, zx` in space \[F/L²\], of one in axes.
pub(super) fn in_space([a, b, c, ab, bc, ca]: [f64; 6], axes: &Matrix3<f64>) -> [f64; 6] {
    let own = Matrix3::new(a, ab, ca, ab, b, bc, ca, bc, c);
    let s = axes * own * axes.transpose();
    [s[(0, 0)], s[(1, 1)], s[(2, 2)], s[(0, 1)], s[(1, 2)], s[(2, 0)]]
}

/// Values at nodes: of the points of the cells round a node `a + b·(x − X)` by least squares, taken at the node.
pub(super) fn recovered<const N: usize>(
    hexahedra: &[[u32; 8]],
    rest: &[Vec3],
    results: &[PointResult],
    values: impl Fn(&PointResult) -> [f64; N] + Copy,
) -> Vec<[f64; N]> {
    let points = results.len() / hexahedra.len().max(1);
    let mut round: Vec<Vec<usize>> = vec![Vec::new(); rest.len()];
    for (cell, corners) in hexahedra.iter().enumerate() {
        // Corners may be alike in cells that a surface cuts.
        for &node in corners {
            if round[node as usize].last() != Some(&cell) {
                round[node as usize].push(cell);
            }
        }
    }
    let at = |(node, cells): (usize, &Vec<usize>)| {
        let own = cells.iter().flat_map(|cell| &results[cell * points..][..points]);
        plane(&rest[node], own, values)
    };
    round.iter().enumerate().map(at).collect()
}

fn plane<'a, const N: usize>(
    node: &Vec3,
    points: impl Iterator<Item = &'a PointResult> + Clone,
    values: impl Fn(&PointResult) -> [f64; N],
) -> [f64; N] {
    let count = points.clone().count().max(1) as f64;
    let size = points.clone().map(|point| (point.place - node).norm()).fold(0.0, f64::max);
    let row = |point: &PointResult| {
        let x = (point.place - node) / size;
        Vector4::new(1.0, x.x, x.y, x.z)
    };
    let matrix: Matrix4<f64> = points.clone().map(|point| row(point) * row(point).transpose()).sum();
    let inverse = if count < FEWEST as f64 { None } else { matrix.try_inverse() };
    let mut out = [0.0; N];
    for point in points {
        let weight = inverse.map_or(1.0 / count, |inverse| (inverse * row(point))[0]);
        out.iter_mut().zip(values(point)).for_each(|(out, value)| *out += weight * value);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_linear_field_is_found_at_the_nodes() {
        let corners = [[0, 1, 2, 3, 4, 5, 6, 7]];
        let sides = [0.0, 2.0];
        let rest: Vec<Vec3> = sides
            .iter()
            .flat_map(|&z| [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]].map(|[x, y]| Vec3::new(x, y, z)))
            .collect();
        let value = |x: &Vec3| 1.0 + 2.0 * x.x - 3.0 * x.y + 0.5 * x.z;
        let inner = [0.4, 1.6];
        let mut results = Vec::new();
        for x in inner {
            for y in inner {
                for z in inner {
                    let place = Vec3::new(x, y, z);
                    let angle = value(&place);
                    let axes = Matrix3::identity();
                    results.push(PointResult { place, stress: [angle; 6], strain: [0.0; 6], angle, axes });
                }
            }
        }
        for (node, found) in rest.iter().zip(recovered(&corners, &rest, &results, all_of)) {
            assert!((found[0] - value(node)).abs() < 1e-12 && (found[12] - value(node)).abs() < 1e-12);
        }
    }
}
