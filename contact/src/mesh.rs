//! A surface whose faces may touch: triangles over its vertices, their sides, and which parts lie near each other at rest.

use std::cmp::Ordering;
use std::collections::{BTreeMap, BinaryHeap};

use sph_core::{Cell, Vec3};

use crate::surface::Surface;

/// Vertices, triangles and edges of a surface.
///
/// Every quadrilateral is four triangles about its middle, which is a vertex of its own. Particles without faces are a triangle of no size each.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    surface: Surface,
    /// Corners of each face, by number of vertex.
    faces: Vec<[u32; 3]>,
    /// Edges of each face: that from a corner to the next.
    sides: Vec<[u32; 3]>,
    /// Ends of each edge, the lower first.
    edges: Vec<[u32; 2]>,
    /// Whether an edge belongs to one face only.
    rims: Vec<bool>,
}

impl Mesh {
    /// The faces of some cells over particles at rest \[L\], with the half thickness \[L\] at each particle.
    pub fn new(cells: &[Cell], rest: &[Vec3], half: impl Fn(u32) -> f64) -> Self {
        let surface = Surface::new(cells, rest, half);
        let mut of_particle = vec![u32::MAX; rest.len()];
        let mut middle = 0;
        for (number, vertex) in surface.vertices().iter().enumerate() {
            if let &[a] = vertex.nodes() {
                of_particle[a as usize] = number as u32;
                middle = number as u32 + 1;
            }
        }
        let mut faces = Vec::new();
        for cell in cells {
            let count = usize::from(cell.count);
            let corner = |i: usize| of_particle[cell.corners[i % count] as usize];
            if count < 4 {
                faces.push([corner(0), corner(1), corner(2)]);
                continue;
            }
            faces.extend((0..4).map(|i| [corner(i), corner(i + 1), middle]));
            middle += 1;
        }
        // A cell without an area has corners that are no vertices.
        faces.retain(|face| face.iter().all(|&corner| corner != u32::MAX));
        let mut numbers: BTreeMap<[u32; 2], (u32, u32)> = BTreeMap::new();
        let ends = |face: &[u32; 3], i: usize| {
            let [a, b] = [face[i], face[(i + 1) % 3]];
            [a.min(b), a.max(b)]
        };
        for face in &faces {
            (0..3).for_each(|i| numbers.entry(ends(face, i)).or_default().1 += 1);
        }
        for (number, entry) in numbers.values_mut().enumerate() {
            entry.0 = number as u32;
        }
        let side = |face: &[u32; 3]| std::array::from_fn(|i| numbers[&ends(face, i)].0);
        let sides = faces.iter().map(side).collect();
        let rims = numbers.values().map(|(_, faces)| *faces == 1).collect();
        Self { surface, faces, sides, edges: numbers.into_keys().collect(), rims }
    }

    /// Particles without faces, ascending, with the area of each \[L²\]: balls of a radius \[L\].
    pub fn points(points: &[(u32, f64)], radius: f64) -> Self {
        let faces = (0..points.len() as u32).map(|vertex| [vertex; 3]).collect();
        let surface = Surface::points(points, radius);
        Self { surface, faces, sides: Vec::new(), edges: Vec::new(), rims: Vec::new() }
    }

    /// The same where particles that are vertices stand for other areas \[L²\] than thirds of all faces at them: at the edges of a solid faces of
    /// several sides meet, of which a body presses on one.
    pub fn with_areas(mut self, area: impl Fn(u32) -> f64) -> Self {
        self.surface.put_areas(area);
        self
    }

    /// Whether it is particles without faces.
    pub(crate) fn is_of_points(&self) -> bool {
        self.edges.is_empty()
    }

    /// Its vertices.
    #[inline]
    pub fn surface(&self) -> &Surface {
        &self.surface
    }

    /// The nodes that are vertices themselves, ascending.
    pub fn nodes(&self) -> impl Iterator<Item = u32> {
        self.surface.vertices().iter().map_while(|vertex| match vertex.nodes() {
            &[a] => Some(a),
            _ => None,
        })
    }

    /// Corners of each face, by number of vertex.
    #[inline]
    pub fn faces(&self) -> &[[u32; 3]] {
        &self.faces
    }

    /// Edges of each face: that from a corner to the next.
    #[inline]
    pub(crate) fn sides(&self) -> &[[u32; 3]] {
        &self.sides
    }

    /// Ends of each edge, the lower first.
    #[inline]
    pub fn edges(&self) -> &[[u32; 2]] {
        &self.edges
    }

    /// Whether an edge belongs to one face only.
    #[inline]
    pub(crate) fn is_rim(&self, edge: usize) -> bool {
        self.rims[edge]
    }

    /// Where a vertex is.
    pub(crate) fn place(&self, vertex: u32, at: impl Fn(u32) -> Vec3) -> Vec3 {
        self.surface.vertices()[vertex as usize].place(at)
    }

    /// Mean area of a vertex \[L²\].
    pub(crate) fn mean_area(&self) -> f64 {
        let vertices = self.surface.vertices();
        vertices.iter().map(|vertex| vertex.area).sum::<f64>() / vertices.len().max(1) as f64
    }

    /// The vertices that lie near each vertex along the surface at rest: no farther than a reach \[L\] by way of edges, or of a cell
    /// that touches one of its own. Faces with such a corner never touch the vertex.
    pub(crate) fn neighbours(&self, rest: &[Vec3], reach: f64) -> Neighbours {
        let count = self.surface.vertices().len();
        let places: Vec<Vec3> = (0..count as u32).map(|v| self.place(v, |a| rest[a as usize])).collect();
        let mut beside = vec![Vec::new(); count];
        for &[a, b] in &self.edges {
            let length = (places[a as usize] - places[b as usize]).norm();
            beside[a as usize].push((b, length));
            beside[b as usize].push((a, length));
        }
        let mut out = Neighbours { firsts: vec![0], vertices: Vec::new() };
        let (mut best, mut heap, mut found) = (vec![f64::INFINITY; count], BinaryHeap::new(), Vec::new());
        for start in 0..count as u32 {
            heap.push(Reached { way: 0.0, steps: 0, vertex: start });
            best[start as usize] = 0.0;
            found.clear();
            found.push(start);
            while let Some(Reached { way, steps, vertex }) = heap.pop() {
                if way > best[vertex as usize] {
                    continue;
                }
                for &(next, length) in &beside[vertex as usize] {
                    let way = way + length;
                    if (way <= reach || steps < 1) && way < best[next as usize] {
                        if best[next as usize] == f64::INFINITY {
                            found.push(next);
                        }
                        best[next as usize] = way;
                        heap.push(Reached { way, steps: steps + 1, vertex: next });
                    }
                }
            }
            found.iter().for_each(|&v| best[v as usize] = f64::INFINITY);
            found.sort_unstable();
            out.vertices.extend(&found);
            out.firsts.push(out.vertices.len() as u32);
        }
        out
    }
}

/// Vertices near each vertex along the surface, itself among them, ascending.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Neighbours {
    firsts: Vec<u32>,
    vertices: Vec<u32>,
}

impl Neighbours {
    /// The vertices near a vertex.
    pub fn of(&self, vertex: u32) -> &[u32] {
        &self.vertices[self.firsts[vertex as usize] as usize..self.firsts[vertex as usize + 1] as usize]
    }

    /// Whether any of some vertices lies near a vertex.
    pub fn any(&self, vertex: u32, others: &[u32]) -> bool {
        let own = self.of(vertex);
        others.iter().any(|other| own.binary_search(other).is_ok())
    }

    /// Bytes that they hold.
    pub fn bytes(&self) -> usize {
        size_of::<u32>() * (self.firsts.len() + self.vertices.len())
    }
}

/// A vertex on the way, the nearest first.
#[derive(PartialEq)]
struct Reached {
    way: f64,
    steps: u32,
    vertex: u32,
}

impl Eq for Reached {}

impl Ord for Reached {
    fn cmp(&self, other: &Self) -> Ordering {
        other.way.total_cmp(&self.way).then(other.vertex.cmp(&self.vertex))
    }
}

impl PartialOrd for Reached {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A strip of three unit squares.
    fn strip() -> (Vec<Cell>, Vec<Vec3>) {
        let rest = (0..8).map(|a| Vec3::new(f64::from(a / 2), f64::from(a % 2), 0.0)).collect();
        let cell = |i: u32| Cell { corners: [2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1], count: 4 };
        ((0..3).map(cell).collect(), rest)
    }

    #[test]
    fn a_strip_of_three_squares_has_twelve_faces_and_eight_rims() {
        let (cells, rest) = strip();
        let mesh = Mesh::new(&cells, &rest, |_| 0.05);
        assert_eq!((mesh.faces().len(), mesh.edges().len()), (12, 10 + 12));
        assert_eq!((0..22).filter(|&e| mesh.is_rim(e)).count(), 8);
        for (face, sides) in mesh.faces().iter().zip(mesh.sides()) {
            for i in 0..3 {
                let ends = mesh.edges()[sides[i] as usize];
                assert!(ends.contains(&face[i]) && ends.contains(&face[(i + 1) % 3]));
            }
        }
        assert!((mesh.mean_area() - 3.0 / 11.0).abs() < 1e-15);
    }

    #[test]
    fn what_lies_near_along_the_surface_is_found_by_edges_and_at_least_a_step_away() {
        let (cells, rest) = strip();
        let mesh = Mesh::new(&cells, &rest, |_| 0.05);
        let near = mesh.neighbours(&rest, 0.2);
        // Corner 0: its cell, middle 8 among it; not the far side of the next cell.
        assert!(near.any(0, &[8]) && near.any(0, &[2]) && near.any(0, &[0]) && !near.any(0, &[4, 5, 9]));
        let near = mesh.neighbours(&rest, 2.1);
        assert!(near.any(0, &[4]) && near.any(0, &[9]) && !near.any(0, &[6]));
        assert!(near.bytes() > 0);
    }
}
