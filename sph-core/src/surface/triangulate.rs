//! The one place that knows the triangulation crate: Delaunay triangles of points in a plane.

use spade::{DelaunayTriangulation, Point2, Triangulation};

use crate::error::SpaceError;

/// Counter-clockwise Delaunay triangles of `points`, sorted; they cover the convex hull.
///
/// The crate decides with exact predicates: points in a straight line on the hull make no slivers.
pub(crate) fn delaunay(points: &[[f64; 2]]) -> Result<Vec<[u32; 3]>, SpaceError> {
    for (particle, x) in points.iter().enumerate() {
        if let Some(&value) = x.iter().find(|x| !x.is_finite()) {
            let bound = "a finite number";
            return Err(SpaceError::BadNumber { particle, what: "parameter", value, bound });
        }
    }
    // The crate refuses numbers so small that its predicates would underflow: zero will do.
    let clean = |x: f64| if x.abs() < spade::MIN_ALLOWED_VALUE { 0.0 } else { x };
    let list = points.iter().map(|x| Point2::new(clean(x[0]), clean(x[1]))).collect();
    let (found, expected) = (points.len(), points.len());
    let refused = |_| SpaceError::Length { what: "triangulated points", found: 0, expected };
    let mesh = DelaunayTriangulation::<Point2<f64>>::bulk_load_stable(list).map_err(refused)?;
    if mesh.num_vertices() != found {
        let what = "different points to triangulate";
        return Err(SpaceError::Length { what, found: mesh.num_vertices(), expected });
    }
    let mut triangles: Vec<[u32; 3]> = mesh
        .inner_faces()
        .map(|face| {
            let mut corners = face.vertices().map(|vertex| vertex.index() as u32);
            let lowest = (0..3).min_by_key(|&i| corners[i]).unwrap_or(0);
            corners.rotate_left(lowest);
            corners
        })
        .collect();
    triangles.sort_unstable();
    Ok(triangles)
}
