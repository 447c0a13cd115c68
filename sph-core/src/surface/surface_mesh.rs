//! Cells between particles scattered over a patch: triangulated, flipped on the surface, paired.

use crate::Vec3;
use crate::error::SpaceError;
use crate::surface::cell::Cell;
use crate::surface::flips::flip_to_delaunay;
use crate::surface::pairing::pair_triangles;
use crate::surface::patch::Patch;
use crate::surface::triangulate::delaunay;

/// Intervals of a parameter direction in rules that integrate over a patch: smooth patches to about 1e-4.
pub(crate) const INTERVALS: usize = 32;

/// Cells between particles at `parameters` on `patch` that cover its rectangle: some of them stand on its corners and
/// edges.
///
/// Delaunay in the parameter plane, scaled so that its sides are as long as the patch is on average; then Delaunay by
/// the angles in space, which follows a metric that varies; then pairs of triangles.
pub(crate) fn cells_on(
    patch: &dyn Patch,
    parameters: &[[f64; 2]],
    positions: &[Vec3],
) -> Result<Vec<Cell>, SpaceError> {
    let [[u0, u1], [v0, v1]] = patch.range();
    let [long, wide] = mean_lengths(patch);
    let size = long.max(wide);
    let plane =
        |x: &[f64; 2]| [(x[0] - u0) / (u1 - u0) * (long / size), (x[1] - v0) / (v1 - v0) * (wide / size)];
    let plane: Vec<[f64; 2]> = parameters.iter().map(plane).collect();
    let mut triangles = delaunay(&plane)?;
    flip_to_delaunay(positions, &mut triangles);
    Ok(pair_triangles(positions, &triangles))
}

/// Mean length `[L]` of the lines along u, and of those along v.
pub(crate) fn mean_lengths(patch: &dyn Patch) -> [f64; 2] {
    let [du, dv] = patch.range().map(|[first, last]| last - first);
    let along = |(u, v): (f64, f64)| {
        let (along_u, along_v) = patch.tangents(u, v);
        [along_u.norm() * du, along_v.norm() * dv]
    };
    let sum = midpoints(patch).map(along).fold([0.0; 2], |sum, x| [sum[0] + x[0], sum[1] + x[1]]);
    sum.map(|sum| sum / (INTERVALS * INTERVALS) as f64)
}

/// Area of a patch `[L²]`.
pub(crate) fn area(patch: &dyn Patch) -> f64 {
    let [du, dv] = patch.range().map(|[first, last]| (last - first) / INTERVALS as f64);
    let jacobian = |(u, v)| {
        let (along_u, along_v) = patch.tangents(u, v);
        along_u.cross(&along_v).norm()
    };
    midpoints(patch).map(jacobian).sum::<f64>() * du * dv
}

/// Parameters of the middles of [`INTERVALS`]² equal rectangles.
fn midpoints(patch: &dyn Patch) -> impl Iterator<Item = (f64, f64)> {
    let [[u0, u1], [v0, v1]] = patch.range();
    let at = |i: usize| (i as f64 + 0.5) / INTERVALS as f64;
    (0..INTERVALS)
        .flat_map(move |i| (0..INTERVALS).map(move |j| (u0 + (u1 - u0) * at(i), v0 + (v1 - v0) * at(j))))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::patch::{Cylinder, Plate};

    #[test]
    fn lengths_and_area_are_those_of_the_surface() {
        let plate = Plate { lengths: [2.0, 1.5] };
        let roof = Cylinder { radius: 3.0, angles: [-0.5, 0.4], length: 2.5 };
        for (patch, sides) in [(&plate as &dyn Patch, [2.0, 1.5]), (&roof, [3.0 * 0.9, 2.5])] {
            let mut lengths = mean_lengths(patch);
            let mut sides = sides;
            lengths.sort_by(f64::total_cmp);
            sides.sort_by(f64::total_cmp);
            for (found, exact) in lengths.iter().zip(sides) {
                assert!((found - exact).abs() < 1e-12 * exact, "{found} {exact}");
            }
            let exact = sides[0] * sides[1];
            assert!((area(patch) - exact).abs() < 1e-12 * exact);
        }
    }
}
