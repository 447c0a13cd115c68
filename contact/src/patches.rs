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
        places.into_iter().fold(none, |own, x| Self { low: own.low.inf(&x), high: own.high.sup(&x) })
    }

    /// Whether another is no farther away than a distance \[L\], whose square is given.
    #[inline]
    pub fn is_near(&self, other: &Self, square: f64) -> bool {
        let gap = |k: usize| (other.low[k] - self.high[k]).max(self.low[k] - other.high[k]).max(0.0);
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
        let (own, others) = (boxed(&self.spans), boxed(&other.spans));
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
        for vertex in self.near.iter().flat_map(|near| vertices.iter().flat_map(|&v| near.of(v))) {
            self.marks[*vertex as usize] = self.now;
        }
    }

    /// Whether any of some vertices is marked.
    #[inline]
    pub fn any(&self, vertices: &[u32]) -> bool {
        self.near.is_some() && vertices.iter().any(|&vertex| self.marks[vertex as usize] == self.now)
    }
}
