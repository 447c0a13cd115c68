//! Patches of a surface, a few faces with what belongs to them, and which patches of two surfaces are near each other.

use sph_core::Vec3;

use crate::mesh::{Mesh, Neighbours};

/// Faces of a patch at most: those of a quadrilateral.
const FACES: usize = 4;
/// Bits of the number of a box along an axis.
const BITS: u32 = 21;
/// More than rounding moves a place by, over the size of a box.
const ROUNDING: f64 = 1e-9;

/// Faces in a row that share their last corner; each vertex and each edge belongs to the first patch that has it.
#[derive(Clone, Debug)]
pub(crate) struct Patches {
    /// First face of each, and the end.
    faces: Vec<u32>,
    vertices: Rows,
    edges: Rows,
}

/// Numbers of each patch.
#[derive(Clone, Debug)]
struct Rows {
    firsts: Vec<u32>,
    numbers: Vec<u32>,
}

impl Rows {
    fn new(patches: usize, count: usize, of: impl Fn(usize) -> Vec<u32>) -> Self {
        let (mut rows, mut taken) = (Self { firsts: vec![0], numbers: Vec::new() }, vec![false; count]);
        for patch in 0..patches {
            for number in of(patch) {
                if !std::mem::replace(&mut taken[number as usize], true) {
                    rows.numbers.push(number);
                }
            }
            rows.firsts.push(rows.numbers.len() as u32);
        }
        rows
    }

    fn of(&self, patch: u32) -> &[u32] {
        &self.numbers[self.firsts[patch as usize] as usize..self.firsts[patch as usize + 1] as usize]
    }
}

impl Patches {
    /// The patches of a surface.
    pub fn new(mesh: &Mesh) -> Self {
        let all = mesh.faces();
        let mut faces = vec![0];
        let mut first = 0;
        for face in 1..all.len() {
            if all[face][2] != all[first][2] || face - first == FACES {
                first = face;
                faces.push(face as u32);
            }
        }
        if !all.is_empty() {
            faces.push(all.len() as u32);
        }
        let count = faces.len() - 1;
        let of = |patch: usize, parts: &[[u32; 3]]| -> Vec<u32> {
            let own = faces[patch] as usize..faces[patch + 1] as usize;
            parts.get(own).into_iter().flatten().flatten().copied().collect()
        };
        let vertices = Rows::new(count, mesh.surface().vertices().len(), |patch| of(patch, all));
        let edges = Rows::new(count, mesh.edges().len(), |patch| of(patch, mesh.sides()));
        Self { vertices, edges, faces }
    }

    /// Faces of a patch.
    pub fn faces(&self, patch: u32) -> std::ops::Range<u32> {
        self.faces[patch as usize]..self.faces[patch as usize + 1]
    }

    /// Vertices that belong to a patch.
    pub fn vertices(&self, patch: u32) -> &[u32] {
        self.vertices.of(patch)
    }

    /// Edges that belong to a patch.
    pub fn edges(&self, patch: u32) -> &[u32] {
        self.edges.of(patch)
    }

    /// Bytes that they hold.
    pub fn bytes(&self) -> usize {
        let rows = |rows: &Rows| size_of_val(&rows.firsts[..]) + size_of_val(&rows.numbers[..]);
        size_of_val(&self.faces[..]) + rows(&self.vertices) + rows(&self.edges)
    }
}

/// The lesser of two, in one instruction: what is no number is not looked after.
#[inline(always)]
fn lesser(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// The greater of two.
#[inline(always)]
fn greater(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// What lies within two corners along the axes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Span {
    low: Vec3,
    high: Vec3,
}

impl Span {
    /// The least one about some places.
    #[inline]
    pub fn about(places: impl IntoIterator<Item = Vec3>) -> Self {
        let none = Self { low: Vec3::repeat(f64::INFINITY), high: Vec3::repeat(f64::NEG_INFINITY) };
        places.into_iter().fold(none, |Self { low, high }, x| Self {
            low: Vec3::new(lesser(x.x, low.x), lesser(x.y, low.y), lesser(x.z, low.z)),
            high: Vec3::new(greater(x.x, high.x), greater(x.y, high.y), greater(x.z, high.z)),
        })
    }

    /// Whether another is no farther away than a distance \[L\], whose square is given.
    #[inline]
    pub fn is_near(&self, other: &Self, square: f64) -> bool {
        let gap = |k: usize| greater(greater(other.low[k] - self.high[k], self.low[k] - other.high[k]), 0.0);
        let [x, y, z] = [gap(0), gap(1), gap(2)];
        x * x + y * y + z * z <= square
    }

    fn middle(&self) -> Vec3 {
        (self.low + self.high) * 0.5
    }
}

/// A surface where it is now.
pub(crate) struct Spread<'a> {
    pub mesh: &'a Mesh,
    pub patches: &'a Patches,
    /// Where its vertices are \[L\].
    pub places: &'a [Vec3],
    spans: Vec<Span>,
}

impl<'a> Spread<'a> {
    /// A surface whose vertices are at some places.
    pub fn new(mesh: &'a Mesh, patches: &'a Patches, places: &'a [Vec3]) -> Self {
        let corners = |face: &[u32; 3]| face.map(|corner| places[corner as usize]);
        let faces = patches.faces.windows(2).map(|ends| &mesh.faces()[ends[0] as usize..ends[1] as usize]);
        let spans = faces.map(|faces| Span::about(faces.iter().flat_map(corners))).collect();
        Self { mesh, patches, places, spans }
    }

    /// What a patch spans.
    pub fn span(&self, patch: u32) -> &Span {
        &self.spans[patch as usize]
    }

    /// Hands each patch that has some of another surface within a reach \[L\] to `each`, with those, ascending.
    ///
    /// Patches stand in boxes as wide as what may be near, sorted by column: cursors go along nine columns at once, none goes back.
    pub fn each_near(&self, other: &Spread<'_>, reach: f64, mut each: impl FnMut(u32, &[u32])) {
        let spans = || self.spans.iter().chain(&other.spans);
        let widest = spans().fold(0.0_f64, |most, span| most.max((span.high - span.low).max()));
        let size = (reach + widest) * (1.0 + ROUNDING);
        let low = spans().fold(Vec3::repeat(f64::INFINITY), |low, span| low.inf(&span.middle()));
        let axis = |x: f64| ((x / size).floor() as i64).clamp(0, (1 << BITS) - 3) + 1;
        let boxed = |spans: &[Span]| {
            let key = |span: &Span| {
                let x = span.middle() - low;
                (axis(x.x) << (2 * BITS)) + (axis(x.y) << BITS) + axis(x.z)
            };
            let mut boxed: Vec<(i64, u32)> = spans.iter().map(key).zip(0..).collect();
            boxed.sort_unstable();
            boxed
        };
        let own = boxed(&self.spans);
        let others = if std::ptr::eq(self, other) { own.clone() } else { boxed(&other.spans) };
        let sorted: Vec<Span> = others.iter().map(|&(_, patch)| other.spans[patch as usize]).collect();
        let mut columns: [std::ops::Range<usize>; 9] = std::array::from_fn(|_| 0..0);
        let (mut near, square) = (Vec::new(), reach * reach);
        for inside in own.chunk_by(|a, b| a.0 == b.0) {
            for (column, entries) in (0..).zip(&mut columns) {
                let key = inside[0].0 + ((column / 3 - 1) << (2 * BITS)) + ((column % 3 - 1) << BITS);
                let from = |start: usize, key: i64| {
                    start + others[start..].iter().take_while(|(other, _)| *other < key).count()
                };
                let start = from(entries.start, key - 1);
                *entries = start..from(start, key + 2);
            }
            for &(_, patch) in inside {
                let span = &self.spans[patch as usize];
                near.clear();
                for entries in &columns {
                    let found = others[entries.clone()].iter().zip(&sorted[entries.clone()]);
                    let found = found.filter(|(_, other)| span.is_near(other, square));
                    near.extend(found.map(|((_, other), _)| *other));
                }
                if !near.is_empty() {
                    near.sort_unstable();
                    each(patch, &near);
                }
            }
        }
    }
}

/// Marks on the vertices that lie near some along one surface.
pub(crate) struct Marks<'a> {
    near: Option<&'a Neighbours>,
    marks: Vec<u32>,
    now: u32,
}

impl<'a> Marks<'a> {
    /// Marks on so many vertices; none of two surfaces.
    pub fn new(near: Option<&'a Neighbours>, count: usize) -> Self {
        Self { near, marks: vec![0; if near.is_some() { count } else { 0 }], now: 0 }
    }

    /// Marks what lies near some vertices, and nothing else.
    pub fn put(&mut self, vertices: &[u32]) {
        self.now += 1;
        let Some(near) = self.near else { return };
        for &vertex in vertices {
            near.of(vertex).iter().for_each(|&near| self.marks[near as usize] = self.now);
        }
    }

    /// Whether any of some vertices is marked.
    #[inline]
    pub fn any(&self, vertices: &[u32]) -> bool {
        self.near.is_some() && vertices.iter().any(|&vertex| self.marks[vertex as usize] == self.now)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::edges::of_edges;
    use crate::list::{List, Range};
    use crate::nearest::{of_segments, on_triangle};
    use sph_core::Cell;

    fn number(seed: usize) -> f64 {
        let x = libm::sin(12.9898 * seed as f64 + 4.1) * 43758.5453;
        x - libm::floor(x)
    }

    /// A rugged sheet of squares and triangles of a size, some of which are left out.
    fn sheet(seed: usize, size: f64, up: f64) -> (Mesh, Vec<Vec3>) {
        const N: u32 = 9;
        let off = |a: u32, k: usize| 0.6 * (number(seed + 3 * a as usize + k) - 0.5);
        let place = |a: u32| {
            Vec3::new(f64::from(a % N) + off(a, 0), f64::from(a / N) + off(a, 1), up + off(a, 2)) * size
        };
        let nodes: Vec<Vec3> = (0..N * N).map(place).collect();
        let cell = |a: u32| {
            let kind = number(seed + 1000 + a as usize);
            let whole = Cell { corners: [a, a + 1, a + 1 + N, a + N], count: 4 };
            let half = Cell { corners: [a, a + 1, a + N, a + N], count: 3 };
            if kind > 0.4 { Some(whole) } else { (kind > 0.2).then_some(half) }
        };
        let cells: Vec<Cell> = (0..N * (N - 1)).filter(|a| a % N < N - 1).filter_map(cell).collect();
        let mesh = Mesh::new(&cells, &nodes, |_| 0.1);
        let vertices = 0..mesh.surface().vertices().len() as u32;
        let places = vertices.map(|v| mesh.place(v, |a| nodes[a as usize])).collect();
        (mesh, places)
    }

    fn listed(list: &List) -> Vec<(u32, u32)> {
        list.pairs().collect()
    }

    /// Against all pairs, of two sheets of unlike cells and of one with itself, near and far.
    #[test]
    fn lists_by_patches_hold_what_all_pairs_do() {
        let mut held = [0, 0];
        for seed in 0..12 {
            let (one, at_one) = sheet(7 * seed, 1.0, 0.0);
            let (other, at_other) = sheet(11 * seed + 5, [0.4, 1.0, 2.3][seed % 3], 0.3);
            let range = Range { distance: 0.2, skin: [0.1, 0.4, 1.5][seed / 4] };
            let reach = range.distance + range.skin;
            let patches = [&one, &other].map(Patches::new);
            let spreads =
                [Spread::new(&one, &patches[0], &at_one), Spread::new(&other, &patches[1], &at_other)];
            let along = one.neighbours(&at_one, 0.5);
            for (a, b) in [(0, 1), (1, 0), (0, 0)] {
                let (own, against) = (&spreads[a], &spreads[b]);
                let near = (a == b).then_some(&along);
                let mut marks = Marks::new(near, against.places.len());
                let (mut faces, mut edges) = (List::default(), List::default());
                own.each_near(against, reach, |patch, near| {
                    faces.add_faces((own, patch), (against, near), range, &mut marks);
                    edges.add_edges((own, patch), (against, near), range, &mut marks);
                });
                faces.sort();
                edges.sort();
                let apart = |v: u32, corners: &[u32]| near.is_none_or(|near| !near.any(v, corners));
                let mut expected = Vec::new();
                for (v, point) in (0..).zip(own.places) {
                    for (face, corners) in (0..).zip(against.mesh.faces()) {
                        let (_, square) = on_triangle(point, corners.map(|v| against.places[v as usize]));
                        if square < reach * reach && apart(v, corners) {
                            expected.push((v, face));
                        }
                    }
                }
                assert_eq!(listed(&faces), expected, "{seed} {a} {b}");
                held[0] += expected.len();
                expected.clear();
                let ends = |of: &Spread<'_>, ends: [u32; 2]| ends.map(|end| of.places[end as usize]);
                for (edge, own_ends) in (0..).zip(own.mesh.edges()) {
                    for (partner, others) in (0..).zip(against.mesh.edges()) {
                        let rims = own.mesh.is_rim(edge as usize) && against.mesh.is_rim(partner as usize);
                        let reach = of_edges(range.distance, rims) + range.skin;
                        let (_, square) = of_segments(ends(own, *own_ends), ends(against, *others));
                        let kept = square < reach * reach && (a != b || partner > edge);
                        if kept && own_ends.iter().all(|&end| apart(end, others)) {
                            expected.push((edge, partner));
                        }
                    }
                }
                assert_eq!(listed(&edges), expected, "{seed} {a} {b}");
                held[1] += expected.len();
            }
        }
        assert!(held.iter().all(|held| *held > 1000), "{held:?}");
    }
}
