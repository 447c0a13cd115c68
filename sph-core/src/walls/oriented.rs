//! A surface of triangles with a wall on one side: edges and corners found, normals turned to the wall.

use std::collections::BTreeMap;

use super::offsets::closest;
use crate::Vec3;
use crate::error::SpaceError;

/// Triangles whose height is below this part of their longest edge are none.
const FLATTEST: f64 = 1e-7;
/// Distances below this part of the extent of the surface are none.
const ON_SURFACE: f64 = 1e-9;

/// Triangles and what joins them.
pub(super) struct OrientedSurface {
    pub triangles: Vec<[Vec3; 3]>,
    /// Unit normals into the wall.
    pub normals: Vec<Vec3>,
    /// Edges between two triangles on which the wall turns outside.
    pub edges: Vec<OuterEdge>,
    /// Vertices off the border of the surface.
    pub corners: Vec<Corner>,
}

/// An edge between two triangles on which the wall turns outside.
pub(super) struct OuterEdge {
    pub ends: [Vec3; 2],
    /// Normals of the triangles into the wall.
    pub normals: [Vec3; 2],
    /// Unit vector out of the first triangle, in its plane, across the edge.
    pub outward: Vec3,
}

/// A vertex off the border.
#[derive(Default)]
pub(super) struct Corner {
    pub place: Vec3,
    /// Edges that begin there.
    pub edges: Vec<Vec3>,
    /// Normals of its triangles into the wall.
    pub normals: Vec<Vec3>,
}

/// The triangles at each edge, lower vertex first, and whether they run that way along it.
type Edges = BTreeMap<(u32, u32), Vec<(usize, bool)>>;

impl OrientedSurface {
    /// Of triangles between vertices \[L\], the wall on the side away from `inside` \[L\].
    pub(super) fn new(vertices: &[Vec3], triangles: &[[u32; 3]], inside: &Vec3) -> Result<Self, SpaceError> {
        let cells = checked(vertices, triangles, inside)?;
        let corners = |cell: &[u32; 3]| cell.map(|vertex| vertices[vertex as usize]);
        let mut surface = Self {
            triangles: cells.iter().map(corners).collect(),
            normals: Vec::new(),
            edges: Vec::new(),
            corners: Vec::new(),
        };
        let edges = edges(&cells)?;
        let mut parts = parts(&cells, &edges)?;
        surface.normals =
            surface.triangles.iter().map(|[a, b, c]| (b - a).cross(&(c - a)).normalize()).collect();
        for part in &mut parts {
            surface.turn(part, inside)?;
        }
        surface.join(vertices, &cells, &edges);
        Ok(surface)
    }

    /// Turns the normals of a part away from a point: its triangles, and whether they run against the first.
    fn turn(&mut self, part: &[(usize, bool)], inside: &Vec3) -> Result<(), SpaceError> {
        let signed = |normal: Vec3, against: bool| if against { -normal } else { normal };
        // Where the nearest point is on an edge, the triangle that the point is seen from most steeply says the side.
        let (mut nearest, mut height, mut extent) = (f64::INFINITY, 0.0_f64, 0.0_f64);
        for &(triangle, against) in part {
            let [a, b, c] = &self.triangles[triangle];
            let away = inside - closest(&self.triangles[triangle], inside);
            let (distance, own) = (away.norm(), away.dot(&signed(self.normals[triangle], against)));
            extent = extent.max((b - a).norm()).max((c - a).norm());
            let same = (distance - nearest).abs() <= ON_SURFACE * extent;
            if (same && own.abs() > height.abs()) || (!same && distance < nearest) {
                height = own;
            }
            nearest = nearest.min(distance);
        }
        if height.abs() <= ON_SURFACE * extent {
            let (what, bound) =
                ("height of the inside point above the nearest part of the surface", "(0, ∞)");
            return Err(SpaceError::OutOfRange { what, value: height.abs(), bound });
        }
        for &(triangle, against) in part {
            self.normals[triangle] = signed(self.normals[triangle], against != (height > 0.0));
        }
        Ok(())
    }

    /// Finds outer edges and corners.
    fn join(&mut self, vertices: &[Vec3], cells: &[[u32; 3]], edges: &Edges) {
        let mut corners: BTreeMap<u32, Option<Corner>> = BTreeMap::new();
        for (&(low, high), users) in edges {
            let ends = [vertices[low as usize], vertices[high as usize]];
            let &[(first, _), (second, _)] = users.as_slice() else {
                corners.insert(low, None);
                corners.insert(high, None);
                continue;
            };
            for (vertex, edge) in [(low, ends[1] - ends[0]), (high, ends[0] - ends[1])] {
                if let Some(corner) = corners.entry(vertex).or_insert_with(|| Some(Corner::default())) {
                    corner.edges.push(edge);
                }
            }
            let along = (ends[1] - ends[0]).normalize();
            let centre = self.triangles[first].iter().sum::<Vec3>() / 3.0 - ends[0];
            let outward = -(centre - along * along.dot(&centre)).normalize();
            let normals = [self.normals[first], self.normals[second]];
            if normals[1].dot(&outward) > 0.0 || normals[0].dot(&normals[1]) < ON_SURFACE - 1.0 {
                self.edges.push(OuterEdge { ends, normals, outward });
            }
        }
        for (triangle, cell) in cells.iter().enumerate() {
            for vertex in cell {
                if let Some(Some(corner)) = corners.get_mut(vertex) {
                    corner.place = vertices[*vertex as usize];
                    corner.normals.push(self.normals[triangle]);
                }
            }
        }
        self.corners = corners.into_values().flatten().collect();
    }
}

/// The triangles with vertices at the same place made one.
fn checked(vertices: &[Vec3], triangles: &[[u32; 3]], inside: &Vec3) -> Result<Vec<[u32; 3]>, SpaceError> {
    if triangles.is_empty() {
        return Err(SpaceError::TooFew { what: "triangles of a wall", found: 0, needed: 1 });
    }
    if let Some(&value) = inside.iter().find(|value| !value.is_finite()) {
        let what = "a coordinate of the inside point";
        return Err(SpaceError::OutOfRange { what, value, bound: "the finite numbers" });
    }
    let mut places: BTreeMap<[u64; 3], u32> = BTreeMap::new();
    let mut first = Vec::new();
    for (particle, x) in vertices.iter().enumerate() {
        if let Some(&value) = x.iter().find(|value| !value.is_finite()) {
            let (what, bound) = ("a coordinate of a vertex", "a finite number");
            return Err(SpaceError::BadNumber { particle, what, value, bound });
        }
        // Zero of either sign is one place.
        let key = [x.x, x.y, x.z].map(|value| (value + 0.0).to_bits());
        first.push(*places.entry(key).or_insert(particle as u32));
    }
    let mut cells = Vec::new();
    for (cell, corners) in triangles.iter().enumerate() {
        let bad = corners.iter().find(|&&corner| corner as usize >= vertices.len());
        if let Some(&corner) = bad {
            let (corner, particles) = (corner as usize, vertices.len());
            return Err(SpaceError::BadCorner { cell, corner, particles });
        }
        let [a, b, c] = corners.map(|corner| vertices[corner as usize]);
        let longest = (b - a).norm().max((c - b).norm()).max((a - c).norm());
        let area = 0.5 * (b - a).cross(&(c - a)).norm();
        let bound = 0.5 * FLATTEST * longest * longest;
        if area <= bound {
            return Err(SpaceError::DegenerateCell { cell, area, bound });
        }
        cells.push(corners.map(|corner| first[corner as usize]));
    }
    Ok(cells)
}

/// The triangles at each edge.
fn edges(cells: &[[u32; 3]]) -> Result<Edges, SpaceError> {
    let mut edges = Edges::new();
    for (cell, [a, b, c]) in cells.iter().enumerate() {
        for (from, to) in [(a, b), (b, c), (c, a)] {
            edges.entry((*from.min(to), *from.max(to))).or_default().push((cell, from < to));
        }
    }
    match edges.iter().find(|(_, users)| users.len() > 2) {
        None => Ok(edges),
        Some((&(low, high), users)) => {
            let (first, second, cells) = (low as usize, high as usize, users.len());
            Err(SpaceError::NonManifoldEdge { first, second, cells })
        }
    }
}

/// The parts that hang together: their triangles, and whether they run against the first of the part.
fn parts(cells: &[[u32; 3]], edges: &Edges) -> Result<Vec<Vec<(usize, bool)>>, SpaceError> {
    let mut against: Vec<Option<bool>> = vec![None; cells.len()];
    let mut parts = Vec::new();
    for start in 0..cells.len() {
        if against[start].is_some() {
            continue;
        }
        against[start] = Some(false);
        let mut part = vec![(start, false)];
        let mut done = 0;
        while let Some(&(cell, turned)) = part.get(done) {
            done += 1;
            let [a, b, c] = cells[cell];
            for (low, high) in [(a, b), (b, c), (c, a)].map(|(a, b)| (a.min(b), a.max(b))) {
                let Some(&[one, two]) = edges.get(&(low, high)).map(Vec::as_slice) else { continue };
                let other = if one.0 == cell { two.0 } else { one.0 };
                let needed = turned != (one.1 == two.1);
                match against[other] {
                    None => {
                        against[other] = Some(needed);
                        part.push((other, needed));
                    }
                    Some(found) if found != needed => {
                        let (first, second) = (low as usize, high as usize);
                        return Err(SpaceError::NonOrientable { cell, other, first, second });
                    }
                    Some(_) => {}
                }
            }
        }
        parts.push(part);
    }
    Ok(parts)
}
