//! What a closed surface cuts out of the cells of a lattice: volumes, first moments, areas.
//!
//! All is in units of cells, cell (i, j, k) between i and i + 1 along x and so on. Triangles are cut at the planes of the lattice. A piece P in
//! cell i of its column along x, with its normal's sign in x, bounds what lies between it and the cells before it, so that by the divergence
//! theorem
//!
//! ```text
//! cell i:        V += ∫ (u + ½) dP_x     ∫x += ∫ ½(u² − ¼) dP_x     ∫y += ∫ (u + ½) v dP_x     ∫z likewise
//! cells before:  V += ∫ dP_x             ∫x += 0                    ∫y += ∫ v dP_x
//! ```
//!
//! u, v, w from the centre of the cell, `dP_x = n_x dP`. Integrands are of the second degree: midpoints of edges are exact. No ray is shot and
//! nothing is counted, so a surface that lies in a plane of the lattice, or through its corners, is no special case for volumes; its area goes to
//! the cell that it bounds.

/// A point \[cells\].
pub(super) type Point = [f64; 3];

/// Distance from a plane within which a piece lies in it \[cells\].
const FLUSH: f64 = 1e-9;
/// Most corners of a piece: three, and one more for each plane that cuts it.
const MOST_CORNERS: usize = 9;

/// A convex polygon.
#[derive(Clone, Copy)]
struct Polygon {
    corners: [Point; MOST_CORNERS],
    count: usize,
}

/// What is inside, cell by cell, the last axis running fastest.
pub(super) struct Cut {
    pub counts: [usize; 3],
    /// Volume, and first moments about the centre of the cell.
    pub inside: Vec<[f64; 4]>,
    /// The surface, cut.
    pub pieces: Vec<Piece>,
}

/// A piece of a triangle in a cell.
pub(super) struct Piece {
    pub cell: usize,
    pub triangle: u32,
    pub area: f64,
    pub centroid: Point,
}

/// Cuts a closed surface, its triangles counter-clockwise seen from outside.
pub(super) fn cut(counts: [usize; 3], triangles: impl Iterator<Item = [Point; 3]>) -> Cut {
    let cells = counts.iter().product();
    let mut out = Cut { counts, inside: vec![[0.0; 4]; cells], pieces: Vec::new() };
    // Of the pieces in a cell: what they bound in the cells before it.
    let mut before = vec![[0.0; 3]; cells];
    for (number, corners) in (0..).zip(triangles) {
        let triangle = Polygon::triangle(corners);
        let normal = triangle.area();
        slabs(&triangle, 1, normal[1], counts[1], &mut |j, strip| {
            slabs(strip, 2, normal[2], counts[2], &mut |k, column| {
                slabs(column, 0, normal[0], counts[0], &mut |i, piece| {
                    let cell = out.number([i, j, k]);
                    let centre = [i, j, k].map(|n| n as f64 + 0.5);
                    let piece = piece.moved(centre);
                    piece.bounds(&mut out.inside[cell], &mut before[cell]);
                    let (area, centroid) = piece.centroid();
                    if area > 0.0 {
                        let centroid = [0, 1, 2].map(|k| centre[k] + centroid[k]);
                        out.pieces.push(Piece { cell, triangle: number, area, centroid });
                    }
                });
            });
        });
    }
    out.add_whole_cells(&before);
    out
}

impl Cut {
    /// The number of a cell.
    pub fn number(&self, [i, j, k]: [usize; 3]) -> usize {
        (i * self.counts[1] + j) * self.counts[2] + k
    }

    /// The place of a cell by its number.
    pub fn place(&self, cell: usize) -> [usize; 3] {
        let [_, rows, columns] = self.counts;
        [cell / (rows * columns), cell / columns % rows, cell % columns]
    }

    fn add_whole_cells(&mut self, before: &[[f64; 3]]) {
        let column = self.counts[1] * self.counts[2];
        for first in 0..column {
            let mut sum = [0.0; 3];
            for cell in (0..self.counts[0]).rev().map(|i| first + i * column) {
                let [volume, _, y, z] = &mut self.inside[cell];
                *volume += sum[0];
                *y += sum[1];
                *z += sum[2];
                sum.iter_mut().zip(before[cell]).for_each(|(sum, own)| *sum += own);
            }
        }
    }
}

/// Cuts a polygon at the planes across an axis and hands on each piece with the cell that it is in.
fn slabs(polygon: &Polygon, axis: usize, normal: f64, count: usize, each: &mut dyn FnMut(usize, &Polygon)) {
    let (low, high) = polygon.along(axis);
    let cell = |number: f64| number.clamp(0.0, (count - 1) as f64) as usize;
    let plane = low.round();
    if (low - plane).abs() <= FLUSH && (high - plane).abs() <= FLUSH {
        return each(cell(if normal > 0.0 { plane - 1.0 } else { plane }), polygon);
    }
    let (first, last) = (low.floor(), high.ceil() - 1.0);
    let mut rest = *polygon;
    for number in cell(first)..cell(last) {
        let (under, above) = rest.split(axis, (number + 1) as f64);
        if under.count > 2 {
            each(number, &under);
        }
        rest = above;
    }
    if rest.count > 2 {
        each(cell(last), &rest);
    }
}

impl Polygon {
    fn triangle([a, b, c]: [Point; 3]) -> Self {
        let mut out = Self { corners: [[0.0; 3]; MOST_CORNERS], count: 0 };
        [a, b, c].into_iter().for_each(|corner| out.push(corner));
        out
    }

    fn push(&mut self, corner: Point) {
        // Rounding may not make a convex polygon of more corners.
        if self.count < MOST_CORNERS {
            self.corners[self.count] = corner;
            self.count += 1;
        }
    }

    fn corners(&self) -> &[Point] {
        &self.corners[..self.count]
    }

    /// Least and greatest coordinate.
    fn along(&self, axis: usize) -> (f64, f64) {
        let bounds = (f64::INFINITY, f64::NEG_INFINITY);
        self.corners()
            .iter()
            .fold(bounds, |(low, high), corner| (low.min(corner[axis]), high.max(corner[axis])))
    }

    /// The parts before and behind a plane across an axis.
    fn split(&self, axis: usize, plane: f64) -> (Self, Self) {
        let empty = Self { corners: [[0.0; 3]; MOST_CORNERS], count: 0 };
        let (mut under, mut above) = (empty, empty);
        for (a, b) in self.corners().iter().zip(self.corners().iter().cycle().skip(1)) {
            if a[axis] <= plane {
                under.push(*a);
            }
            if a[axis] >= plane {
                above.push(*a);
            }
            // From the lower end, so that both triangles at an edge are cut in one point.
            let (p, q) = if a[axis] < b[axis] { (a, b) } else { (b, a) };
            if p[axis] < plane && plane < q[axis] {
                let part = (plane - p[axis]) / (q[axis] - p[axis]);
                let mut point = [0, 1, 2].map(|k| p[k] + part * (q[k] - p[k]));
                point[axis] = plane;
                under.push(point);
                above.push(point);
            }
        }
        (under, above)
    }

    /// The same from another origin.
    fn moved(mut self, origin: Point) -> Self {
        for corner in &mut self.corners[..self.count] {
            (0..3).for_each(|k| corner[k] -= origin[k]);
        }
        self
    }

    /// Normal times area.
    fn area(&self) -> Point {
        let mut twice = [0.0; 3];
        for [a, b] in self.fan() {
            twice.iter_mut().zip(cross(a, b)).for_each(|(sum, own)| *sum += own);
        }
        twice.map(|twice| 0.5 * twice)
    }

    /// Area, and its centroid.
    fn centroid(&self) -> (f64, Point) {
        let (first, mut whole, mut moment) = (self.corners[0], 0.0, [0.0; 3]);
        for [a, b] in self.fan() {
            let area = 0.5 * norm(cross(a, b));
            whole += area;
            (0..3).for_each(|k| moment[k] += area * (a[k] + b[k]) / 3.0);
        }
        (whole, [0, 1, 2].map(|k| first[k] + if whole > 0.0 { moment[k] / whole } else { 0.0 }))
    }

    /// Two edges, from the first corner, of each triangle of a fan.
    fn fan(&self) -> impl Iterator<Item = [Point; 2]> + '_ {
        let first = self.corners[0];
        let from_first = move |corner: &Point| [0, 1, 2].map(|k| corner[k] - first[k]);
        self.corners().windows(2).skip(1).map(move |pair| [from_first(&pair[0]), from_first(&pair[1])])
    }

    /// Adds what it bounds in its own cell, from whose centre its corners are measured, and in those before it.
    fn bounds(&self, inside: &mut [f64; 4], before: &mut [f64; 3]) {
        let first = self.corners[0];
        for [a, b] in self.fan() {
            let third = (a[1] * b[2] - a[2] * b[1]) / 6.0;
            let middles = [
                [0, 1, 2].map(|k| first[k] + 0.5 * a[k]),
                [0, 1, 2].map(|k| first[k] + 0.5 * (a[k] + b[k])),
                [0, 1, 2].map(|k| first[k] + 0.5 * b[k]),
            ];
            for [u, v, w] in middles {
                let length = u + 0.5;
                let terms = [length, 0.5 * (u * u - 0.25), length * v, length * w];
                inside.iter_mut().zip(terms).for_each(|(sum, term)| *sum += third * term);
                before.iter_mut().zip([1.0, v, w]).for_each(|(sum, term)| *sum += third * term);
            }
        }
    }
}

fn cross(a: Point, b: Point) -> Point {
    [0, 1, 2].map(|k| a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3])
}

fn norm([x, y, z]: Point) -> f64 {
    (x * x + y * y + z * z).sqrt()
}
