//! Rows of wall particles behind a surface of triangles.
//!
//! A row is the surface at a distance d behind the wall's face: triangles moved by d along their normals, cylinders
//! round edges and spheres round corners on which the wall turns outside, as far as no part of the face is nearer
//! than d. It is covered with points, which are thinned to particles.

use libm::{acos, ceil, cos, sin};

use super::cover::cover;
use super::offsets::{Offsets, spread};
use super::oriented::{Corner, OrientedSurface, OuterEdge};
use super::wall_rows::{check, check_count};
use crate::Vec3;
use crate::error::SpaceError;

/// Points per spacing that a row is covered with before it is thinned.
const POINTS: f64 = 5.0;
/// What lies this part of the spacing nearer than a row is not nearer. Edges that turn by less than φ = 1/5 Δx/d are
/// not rounded; their triangles' rows then cross d φ²/8, at most 0.01 Δx, within the row that is the distance d from
/// all.
const SLACK: f64 = 0.02;

/// Rows of wall particles behind a surface of triangles, the first half a spacing behind its face, row by row.
///
/// `vertices` \[L\] at the same place count as one; `triangles` name three each, in any order. The surface may be
/// closed or open and of several parts; behind each is the side of it that does not see `inside` \[L\], a point in
/// the fluid. Rows are round on outer edges and corners, trimmed on inner ones, and stop where the surface does.
/// Particles are about `spacing` \[L\] apart, no two nearer than 0.7 of it in a row, and no point of a row is farther
/// than 0.85 from one. A wall thinner than a spacing has no particle: [`leaks`](crate::leaks) counts such places.
///
/// # Errors
/// [`SpaceError::OutOfRange`] for a spacing that is not positive, rows out of \[1, 20\], more than 10⁸ points, an
/// inside point on the surface; [`SpaceError::TooFew`], [`SpaceError::BadNumber`], [`SpaceError::BadCorner`] and
/// [`SpaceError::DegenerateCell`] for what is no triangle; [`SpaceError::NonManifoldEdge`] and
/// [`SpaceError::NonOrientable`] for what has no two sides.
pub fn surface_rows(
    vertices: &[Vec3],
    triangles: &[[u32; 3]],
    inside: &Vec3,
    spacing: f64,
    rows: usize,
) -> Result<Vec<Vec3>, SpaceError> {
    check(spacing, rows)?;
    let surface = OrientedSurface::new(vertices, triangles, inside)?;
    surface.check_points(spacing, rows)?;
    let offsets = Offsets::new(&surface.triangles, spacing, (rows as f64 - 0.5) * spacing, SLACK);
    let mut particles = Vec::new();
    for row in 0..rows {
        let distance = (row as f64 + 0.5) * spacing;
        let mut points = surface.behind(distance, spacing / POINTS);
        points.retain(|x| offsets.none_nearer(x, distance));
        particles.extend(cover(&points, spacing));
    }
    Ok(particles)
}

/// Points where the first row of a surface's wall should stand: half a spacing behind its triangles, a quarter apart.
///
/// # Errors
/// As [`surface_rows`].
pub fn surface_first_row(
    vertices: &[Vec3],
    triangles: &[[u32; 3]],
    inside: &Vec3,
    spacing: f64,
) -> Result<Vec<Vec3>, SpaceError> {
    check(spacing, 1)?;
    let surface = OrientedSurface::new(vertices, triangles, inside)?;
    surface.check_points(spacing, 1)?;
    let offsets = Offsets::new(&surface.triangles, spacing, 0.5 * spacing, SLACK);
    Ok(offsets.kept(surface.behind_triangles(0.5 * spacing, 0.25 * spacing), 0.5 * spacing))
}

impl OrientedSurface {
    /// Refuses more points than a machine holds.
    fn check_points(&self, spacing: f64, rows: usize) -> Result<(), SpaceError> {
        let area: f64 = self.triangles.iter().map(|[a, b, c]| 0.5 * (b - a).cross(&(c - a)).norm()).sum();
        let points = area * (POINTS / spacing) * (POINTS / spacing) + self.triangles.len() as f64;
        check_count(points * rows as f64)
    }

    /// Points at a distance behind triangles, edges and corners, about `step` apart \[L\].
    fn behind(&self, distance: f64, step: f64) -> Vec<Vec3> {
        let triangles = self.behind_triangles(distance, step);
        let edges = self.edges.iter().flat_map(|edge| edge.behind(distance, step));
        let corners = self.corners.iter().flat_map(|corner| corner.behind(distance, step));
        triangles.chain(edges).chain(corners).collect()
    }

    fn behind_triangles(&self, distance: f64, step: f64) -> impl Iterator<Item = Vec3> {
        self.triangles
            .iter()
            .zip(&self.normals)
            .flat_map(move |(triangle, normal)| spread(triangle, step).map(move |x| x + normal * distance))
    }
}

impl OuterEdge {
    /// Points round the edge, between the planes of its triangles.
    fn behind(&self, distance: f64, step: f64) -> Vec<Vec3> {
        let [from, to] = self.ends;
        let angle = acos(self.normals[0].dot(&self.normals[1]).clamp(-1.0, 1.0));
        let (arcs, steps) = (ceil(angle * distance / step), ceil((to - from).norm() / step));
        let mut points = Vec::new();
        for arc in 1..arcs as usize {
            let at = angle * arc as f64 / arcs;
            let offset = (self.normals[0] * cos(at) + self.outward * sin(at)) * distance;
            points.extend((0..=steps as usize).map(|i| from.lerp(&to, i as f64 / steps) + offset));
        }
        points
    }
}

impl Corner {
    /// Points round the corner, in directions from which no edge is nearer than the corner.
    fn behind(&self, distance: f64, step: f64) -> Vec<Vec3> {
        let middle: Vec3 = self.normals.iter().sum();
        let flat = |a: &Vec3, b: &Vec3| (a - b).norm() * distance <= step;
        if self.normals.iter().all(|a| self.normals.iter().all(|b| flat(a, b))) {
            return Vec::new();
        }
        let steps = ceil(2.0 * distance / step);
        let part = |i: usize| 2.0 * i as f64 / steps - 1.0;
        let mut points = Vec::new();
        for axis in 0..3 {
            for sign in [-1.0, 1.0] {
                for (i, j) in (0..=steps as usize).flat_map(|i| (0..=steps as usize).map(move |j| (i, j))) {
                    let mut direction = Vec3::zeros();
                    direction[axis] = sign;
                    direction[(axis + 1) % 3] = part(i);
                    direction[(axis + 2) % 3] = part(j);
                    if direction.dot(&middle) > 0.0
                        && self.edges.iter().all(|edge| direction.dot(edge) <= 0.0)
                    {
                        points.push(self.place + direction.normalize() * distance);
                    }
                }
            }
        }
        points
    }
}
