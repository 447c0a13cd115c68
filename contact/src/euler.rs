//! Which features of a surface a point touches, and how often each counts, so that every nearest place counts once.
//!
//! Energies of all near faces would count a place on an edge twice and one on a corner six times. Faces count +1, edges and vertices what is left of one:
//!
//! ```text
//! c_e = 1 − n_f(e),    c_u = 1 − n_f(u) − Σ_{e∋u} c_e
//! ```
//!
//! n_f the faces at them that may touch at all: in a surface −1 for an edge inside it, 0 at a rim, 1 for a vertex inside. Distances to the closed triangle, segment
//! and point are smooth, and so is the sum \[li2023\]. Over a plane all but the face below cancels; in a valley two faces are left and −1 of its edge,
//! on a ridge the edge alone.

use sph_core::Vec3;

use crate::mesh::Mesh;
use crate::nearest::{Part, on_segment, on_triangle};

/// Near faces whose parts are counted by looking through them: more are put in order first.
const FEW: usize = 8;

/// A part of a surface, by its number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Feature {
    /// A place inside a face.
    Face(u32),
    /// A place on an edge off its ends.
    Edge(u32),
    /// A vertex.
    Vertex(u32),
}

/// The features that a point touches with their coefficients; buffers that are kept from point to point.
#[derive(Clone, Debug, Default)]
pub(crate) struct Touched {
    /// Features nearer than the distance, each once and in their order, with coefficients that are not zero.
    pub terms: Vec<(Feature, i32)>,
    near: Vec<u32>,
    /// Edges and vertices of the near faces, with the number of those faces.
    edges: Vec<(u32, i32)>,
    corners: Vec<(u32, i32)>,
}

impl Touched {
    /// Finds what a point touches within a distance \[L\] among faces that may touch it; places of vertices are `at`.
    pub fn find(
        &mut self,
        mesh: &Mesh,
        point: &Vec3,
        distance: f64,
        faces: impl Iterator<Item = u32>,
        at: impl Fn(u32) -> Vec3,
    ) {
        let reach = distance * distance;
        self.terms.clear();
        self.near.clear();
        for face in faces {
            let corners = mesh.faces()[face as usize];
            let (part, square) = on_triangle(point, corners.map(&at));
            if square < reach {
                self.near.push(face);
                self.put(Self::of_face(mesh, face, part), 1);
            }
        }
        // Edges and corners of one face count nothing beside it; particles without faces share none.
        if self.near.len() < 2 || mesh.is_of_points() {
            return;
        }
        match self.near[..] {
            // Of two faces only what they share counts other than once.
            [one, other] => self.share(mesh, [one, other], point, reach, &at),
            _ => self.share_all(mesh, point, reach, &at),
        }
        if self.near.len() > FEW {
            self.terms.sort_unstable();
            self.terms.dedup_by(|next, kept| {
                let same = next.0 == kept.0;
                if same {
                    kept.1 += next.1;
                }
                same
            });
        }
        self.terms.retain(|(_, coefficient)| *coefficient != 0);
        if self.terms.len() > 1 {
            self.terms.sort_unstable();
        }
    }

    /// Adds a feature of a near face, or what else counts of it; among few faces to what it has already.
    #[inline]
    fn put(&mut self, feature: Feature, coefficient: i32) {
        let few = self.near.len() <= FEW;
        match self.terms.iter_mut().find(|(own, _)| few && *own == feature) {
            Some((_, count)) => *count += coefficient,
            None => self.terms.push((feature, coefficient)),
        }
    }

    /// Adds what counts of an edge or a corner that two faces share, if it is near.
    fn share(
        &mut self,
        mesh: &Mesh,
        [one, other]: [u32; 2],
        point: &Vec3,
        reach: f64,
        at: &impl Fn(u32) -> Vec3,
    ) {
        let others = mesh.sides()[other as usize];
        let mut sides = mesh.sides()[one as usize].into_iter().filter(|edge| others.contains(edge));
        match (sides.next(), sides.next()) {
            (Some(edge), None) => return self.add_edge(mesh, edge, -1, point, reach, at),
            // Both sides of one triangle.
            (Some(_), Some(_)) => return self.share_all(mesh, point, reach, at),
            _ => {}
        }
        let others = mesh.faces()[other as usize];
        let shared = mesh.faces()[one as usize].into_iter().find(|corner| others.contains(corner));
        if let Some(vertex) = shared.filter(|&vertex| (point - at(vertex)).norm_squared() < reach) {
            self.put(Feature::Vertex(vertex), -1);
        }
    }

    /// Adds an edge with a coefficient, if it is near.
    fn add_edge(
        &mut self,
        mesh: &Mesh,
        edge: u32,
        coefficient: i32,
        point: &Vec3,
        reach: f64,
        at: &impl Fn(u32) -> Vec3,
    ) {
        let ends = mesh.edges()[edge as usize];
        let (part, square) = on_segment(point, ends.map(at));
        if square < reach {
            let feature = match part {
                Part::Corner(i) => Feature::Vertex(ends[i]),
                _ => Feature::Edge(edge),
            };
            self.put(feature, coefficient);
        }
    }

    /// Adds what counts of all edges and corners of near faces.
    fn share_all(&mut self, mesh: &Mesh, point: &Vec3, reach: f64, at: &impl Fn(u32) -> Vec3) {
        self.count(mesh);
        let edges = std::mem::take(&mut self.edges);
        for &(edge, faces) in edges.iter().filter(|(_, faces)| *faces != 1) {
            self.add_edge(mesh, edge, 1 - faces, point, reach, at);
        }
        let corners = std::mem::take(&mut self.corners);
        for &(vertex, faces) in &corners {
            let own = edges.iter().filter(|(edge, _)| mesh.edges()[*edge as usize].contains(&vertex));
            let coefficient = 1 - faces - own.map(|(_, faces)| 1 - faces).sum::<i32>();
            if coefficient != 0 && (point - at(vertex)).norm_squared() < reach {
                self.put(Feature::Vertex(vertex), coefficient);
            }
        }
        (self.edges, self.corners) = (edges, corners);
    }

    fn of_face(mesh: &Mesh, face: u32, part: Part) -> Feature {
        match part {
            Part::Inside => Feature::Face(face),
            Part::Side(i) => Feature::Edge(mesh.sides()[face as usize][i]),
            Part::Corner(i) => Feature::Vertex(mesh.faces()[face as usize][i]),
        }
    }

    /// Edges and corners of the near faces. Whatever of them is itself near has all of its faces among these.
    fn count(&mut self, mesh: &Mesh) {
        let Self { near, edges, corners, .. } = self;
        edges.clear();
        corners.clear();
        if near.len() <= FEW {
            for &face in near.iter() {
                mesh.sides()[face as usize].iter().for_each(|&edge| tally(edges, edge));
                mesh.faces()[face as usize].iter().for_each(|&corner| tally(corners, corner));
            }
            return;
        }
        for &face in near.iter() {
            edges.extend(mesh.sides()[face as usize].map(|edge| (edge, 1)));
            corners.extend(mesh.faces()[face as usize].map(|corner| (corner, 1)));
        }
        for list in [edges, corners] {
            list.sort_unstable();
            list.dedup_by(|next, kept| {
                let same = next.0 == kept.0;
                if same {
                    kept.1 += next.1;
                }
                same
            });
        }
    }
}

/// Counts a part once more.
fn tally(list: &mut Vec<(u32, i32)>, part: u32) {
    match list.iter_mut().find(|(own, _)| *own == part) {
        Some((_, count)) => *count += 1,
        None => list.push((part, 1)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pair::Pair;
    use sph_core::Cell;

    fn number(seed: usize) -> f64 {
        let x = libm::sin(12.9898 * seed as f64 + 4.1) * 43758.5453;
        x - libm::floor(x)
    }

    /// Squares of a plane of which some are left out, and some are triangles: rims, notches, pieces that meet in a corner.
    fn patchwork(seed: usize) -> (Mesh, Vec<Vec3>, Vec<u32>) {
        const N: u32 = 5;
        let rest: Vec<Vec3> =
            (0..N * N).map(|a| Vec3::new(f64::from(a % N), f64::from(a / N), 0.0)).collect();
        let mut cells = Vec::new();
        for i in 0..N - 1 {
            for j in 0..N - 1 {
                let a = i + N * j;
                let kind = number(seed + 100 * (a as usize));
                if kind > 0.5 {
                    cells.push(Cell { corners: [a, a + 1, a + 1 + N, a + N], count: 4 });
                } else if kind > 0.25 {
                    cells.push(Cell { corners: [a, a + 1, a + N, a + N], count: 3 });
                }
            }
        }
        let mesh = Mesh::new(&cells, &rest, |_| 0.05);
        // Faces that may not touch, beside those that are not there.
        let allowed = (0..mesh.faces().len()).filter(|f| number(seed + 7 * f + 3) > 0.3).map(|f| f as u32);
        let allowed = allowed.collect();
        (mesh, rest, allowed)
    }

    /// Pieces into which the near faces fall that share no near edge or vertex.
    fn pieces(mesh: &Mesh, near: &[u32], is_near: impl Fn(&[u32]) -> bool) -> i32 {
        let mut piece: Vec<usize> = (0..near.len()).collect();
        for _ in 0..near.len() {
            for i in 0..near.len() {
                for j in 0..i {
                    let [a, b] = [near[i], near[j]].map(|face| mesh.faces()[face as usize]);
                    let shared: Vec<u32> = a.into_iter().filter(|v| b.contains(v)).collect();
                    let joined =
                        shared.len() == 2 && is_near(&shared) || shared.iter().any(|v| is_near(&[*v]));
                    if joined {
                        let least = piece[i].min(piece[j]);
                        (piece[i], piece[j]) = (least, least);
                    }
                }
            }
        }
        piece.iter().enumerate().filter(|(i, piece)| i == *piece).count() as i32
    }

    /// The coefficients of all that touches a point sum to one for every piece of the surface within reach, none of which has a hole:
    /// a reach of a tenth of a cell over ten thousand places.
    #[test]
    fn every_nearest_place_counts_once_at_faces_rims_notches_and_corners() {
        let mut touched = Touched::default();
        let (mut met, mut many) = (0, 0);
        for seed in 0..400 {
            let (mesh, rest, allowed) = patchwork(seed);
            let at = |v: u32| mesh.place(v, |a| rest[a as usize]);
            for k in 0..25 {
                let n = seed * 25 + k;
                // A place on a face, an edge or a vertex, a little off it.
                let (face, by) = (allowed.get(n % allowed.len().max(1)), |i: usize| number(5 * n + i));
                let Some(&face) = face else { continue };
                let [a, b, c] = mesh.faces()[face as usize].map(at);
                let foot = match n % 3 {
                    0 => a + ((b - a) * by(0) + (c - b) * (by(0) * by(1))),
                    1 => a + (b - a) * by(0),
                    _ => a,
                };
                let off = Vec3::new(by(2) - 0.5, by(3) - 0.5, by(4) - 0.5) * 0.06;
                touched.find(&mesh, &(foot + off), 0.1, allowed.iter().copied(), at);
                let point = foot + off;
                let is_near = |part: &[u32]| match *part {
                    [a, b] => on_segment(&point, [at(a), at(b)]).1 < 0.01,
                    _ => part.iter().all(|&v| (point - at(v)).norm_squared() < 0.01),
                };
                let sum: i32 = touched.terms.iter().map(|(_, c)| c).sum();
                assert_eq!(sum, pieces(&mesh, &touched.near, is_near), "{seed} {k}: {:?}", touched.terms);
                met += 1;
                many += i32::from(touched.terms.len() > 1);
            }
        }
        assert!(met > 9000 && many > 10, "{met} {many}");
    }

    /// A point at a fixed height over a plane of squares, with many cells within reach or less than one: energy and force stay to
    /// rounding, 2e-14 measured.
    #[test]
    fn what_slides_over_a_plane_feels_no_ripple() {
        const N: u32 = 7;
        let rest: Vec<Vec3> =
            (0..N * N).map(|a| Vec3::new(f64::from(a % N), f64::from(a / N), 0.0)).collect();
        let cell = |a: u32| Cell { corners: [a, a + 1, a + 1 + N, a + N], count: 4 };
        let cells: Vec<Cell> = (0..N * (N - 1)).filter(|a| a % N < N - 1).map(cell).collect();
        let mesh = Mesh::new(&cells, &rest, |_| 0.05);
        let at = |v: u32| mesh.place(v, |a| rest[a as usize]);
        let mut touched = Touched::default();
        for distance in [0.2, 1.3] {
            let (height, mut many) = (0.7 * distance, 0);
            for i in 0..2000 {
                let point = Vec3::new(2.1 + 9e-4 * f64::from(i), 2.3 + 7e-4 * f64::from(i), height);
                touched.find(&mesh, &point, distance, 0..mesh.faces().len() as u32, at);
                many = many.max(touched.near.len());
                let (mut energy, mut force) = (0.0, Vec3::zeros());
                for &(feature, coefficient) in &touched.terms {
                    let (corners, count) = match feature {
                        Feature::Face(face) => (mesh.faces()[face as usize], 3),
                        Feature::Edge(edge) => ([0, 1, 1].map(|i| mesh.edges()[edge as usize][i]), 2),
                        Feature::Vertex(vertex) => ([vertex; 3], 1),
                    };
                    let [a, b, c] = corners.map(at);
                    let pair = match count {
                        3 => Pair::face([point, a, b, c]),
                        2 => Pair::segment([point, a, b]),
                        _ => Pair::points([point, a]),
                    };
                    let (depth, count) = (distance - pair.distance, f64::from(coefficient));
                    energy += count * depth * depth;
                    force += pair.normal * (count * 2.0 * depth);
                }
                let depth = distance - height;
                assert!((energy / (depth * depth) - 1.0).abs() < 1e-12, "{i}: {energy}");
                assert!((force / (2.0 * depth) - Vec3::z()).norm() < 1e-12, "{i}: {force}");
            }
            assert!(many > 3);
        }
    }

    #[test]
    fn a_valley_is_two_faces_less_its_edge_and_a_ridge_its_edge() {
        let rest = [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.5, 0.5], [1.0, 0.5, 0.5]].map(Vec3::from);
        let cells = [[0, 1, 2, 2], [1, 0, 3, 3]].map(|corners| Cell { corners, count: 3 });
        let mesh = Mesh::new(&cells, &rest, |_| 0.05);
        let mut touched = Touched::default();
        let mut find = |z: f64| {
            let point = Vec3::new(0.0, 0.5, z);
            touched.find(&mesh, &point, 0.15, 0..2, |v| rest[v as usize]);
            touched.terms.clone()
        };
        assert!(matches!(
            find(0.1)[..],
            [(Feature::Face(0), 1), (Feature::Face(1), 1), (Feature::Edge(_), -1)]
        ));
        assert!(matches!(find(-0.1)[..], [(Feature::Edge(_), 1)]));
        assert_eq!(find(-0.2), []);
    }
}
