//! Nodes at the corners of cells that are half full at least, the outermost on the surface.
//!
//! A corner that not all cells round it are nodes of goes to the nearest place of the surface; where several are as near, to their mean; beside a sharp edge
//! or a corner of the surface there (features.rs). In a plane of
//! the box round the body in which the surface is flat, which may be a plane of symmetry, it stays in that plane. Of nodes that come nearer to
//! each other than [`APART`] one is left: shape functions need no cells, and two nodes on one place determine nothing.

use std::collections::{BTreeSet, HashMap};

use super::clip::Cut;
use super::features::Features;
use super::nearest::{on_edge, on_triangle};
use super::{ClosedSurface, IN_PLANE, Laid};
use crate::Vec3;

/// Least distance of two nodes, in spacings: a third of those that there are on the surface, which the diagonal of a cell crosses.
const APART: f64 = 0.4;
/// Distance from a triangle within which a node lies on it, in spacings.
const ON_SURFACE: f64 = 1e-6;
/// The same of the triangles whose nearest places it is the mean of: of a smooth surface it lies off them by its curvature, of the faces of a right edge by a
/// quarter and more, and belongs to neither.
const CURVED: f64 = 0.1;
/// Difference of distances that is rounding, in spacings.
const AS_NEAR: f64 = 1e-9;
/// Cells round a corner, along each axis to either side, whose triangles it may go to.
const REACH: usize = 2;

/// The corners that became nodes.
pub(super) struct Snapped {
    /// Places of the nodes \[L\].
    pub places: Vec<Vec3>,
    /// The node of each corner of the lattice, the last axis running fastest; `u32::MAX` of those that are none.
    pub of_corner: Vec<u32>,
    /// Nodes with each triangle that they lie on, ascending.
    pub touching: Vec<(u32, u32)>,
}

/// A corner, where it is going to be.
struct Moved {
    corner: usize,
    place: Vec3,
    /// Which stays where two are one: corners of the surface before sharp edges, these before its faces, and nodes inside last.
    rank: u8,
    /// How far it went, in millionths of a spacing.
    far: u64,
    triangles: Vec<u32>,
}

pub(super) fn snap(
    surface: &ClosedSurface,
    (laid, spacing): (&Laid, f64),
    cut: &Cut,
    (is_node, triangles): (&[bool], &[Vec<u32>]),
) -> Snapped {
    let corners = laid.counts.map(|count| count + 1);
    let features = Features::new(surface, laid, spacing);
    let net = Net { surface, laid, spacing, cut, is_node, triangles, features };
    let mut moved = Vec::new();
    let mut at = 0;
    for i in 0..corners[0] {
        for j in 0..corners[1] {
            for k in 0..corners[2] {
                moved.extend(net.moved(at, [i, j, k]));
                at += 1;
            }
        }
    }
    moved.sort_by_key(|own| (own.rank, own.far, own.corner));
    // Boxes as wide as nodes are apart at least: two in one box are one.
    let apart = APART * spacing;
    let box_of = |x: &Vec3| [0, 1, 2].map(|axis| ((x[axis] - laid.origin[axis]) / apart).floor() as i64);
    let mut boxes: HashMap<[i64; 3], Vec<usize>> = HashMap::new();
    let mut same: Vec<usize> = Vec::with_capacity(moved.len());
    for (number, own) in moved.iter().enumerate() {
        let [i, j, k] = box_of(&own.place);
        let mut nearest = (apart * apart, number);
        for (di, dj, dk) in (0..27).map(|n| (n / 9 - 1, n / 3 % 3 - 1, n % 3 - 1)) {
            for &other in boxes.get(&[i + di, j + dj, k + dk]).into_iter().flatten() {
                let square = (moved[other].place - own.place).norm_squared();
                if square < nearest.0 {
                    nearest = (square, other);
                }
            }
        }
        if nearest.1 == number {
            boxes.entry([i, j, k]).or_default().push(number);
        }
        same.push(nearest.1);
    }
    numbered(&moved, &same, at)
}

/// Numbers the nodes by their corners.
fn numbered(moved: &[Moved], same: &[usize], corners: usize) -> Snapped {
    let mut order: Vec<usize> = (0..moved.len()).filter(|&number| same[number] == number).collect();
    order.sort_by_key(|&number| moved[number].corner);
    let mut numbers = vec![u32::MAX; moved.len()];
    let mut out = Snapped { places: Vec::new(), of_corner: vec![u32::MAX; corners], touching: Vec::new() };
    for number in order {
        numbers[number] = out.places.len() as u32;
        out.touching.extend(moved[number].triangles.iter().map(|&triangle| (numbers[number], triangle)));
        out.places.push(moved[number].place);
    }
    for (own, &node) in moved.iter().zip(same) {
        out.of_corner[own.corner] = numbers[node];
    }
    out
}

/// The lattice with what is known of its cells.
struct Net<'a> {
    surface: &'a ClosedSurface,
    laid: &'a Laid,
    spacing: f64,
    cut: &'a Cut,
    is_node: &'a [bool],
    /// Triangles in each cell.
    triangles: &'a [Vec<u32>],
    features: Features,
}

impl Net<'_> {
    /// What becomes of a corner; none of one that no cell with nodes has.
    fn moved(&self, corner: usize, at: [usize; 3]) -> Option<Moved> {
        // Flat sides of the box that it lies in: what is behind them counts as what is before.
        let flat: Vec<usize> = (0..6).filter(|&side| self.lies_in(side, at)).collect();
        let (mut some, mut all) = (false, true);
        for step in 0..8 {
            let along = |axis: usize| (at[axis] + (step >> axis & 1)).checked_sub(1);
            let beyond = |axis: usize| along(axis).is_none_or(|n| n >= self.laid.counts[axis]);
            let side = |axis: usize| 2 * axis + (step >> axis & 1);
            if (0..3).any(|axis| beyond(axis) && flat.contains(&side(axis))) {
                continue;
            }
            let cell = [0, 1, 2].map(along);
            let inside = match cell {
                [Some(i), Some(j), Some(k)] if !(0..3).any(beyond) => {
                    self.is_node[self.cut.number([i, j, k])]
                }
                _ => false,
            };
            some |= inside;
            all &= inside;
        }
        if !some {
            return None;
        }
        let place = self.laid.origin + Vec3::from(at.map(|n| n as f64)) * self.spacing;
        if all && flat.is_empty() {
            return Some(Moved { corner, place, rank: 3, far: 0, triangles: Vec::new() });
        }
        let near = self.near(at);
        let kept = if all { &[][..] } else { &flat };
        let found = self.nearest(&place, &near, kept).or_else(|| self.nearest(&place, &near, &[]));
        let (mut to, nearest) = found.unwrap_or((place, Vec::new()));
        let mut rank = 2;
        let beside = self.features.beside(self.surface, (&to, self.spacing), &near);
        if let Some((sharp, corner)) = beside.filter(|_| flat.is_empty()) {
            (to, rank) = (sharp, if corner { 0 } else { 1 });
        }
        let lies_on = |number: &u32| {
            let within = if nearest.contains(number) { CURVED } else { ON_SURFACE };
            (on_triangle(&to, self.corners(*number)) - to).norm() <= within * self.spacing
        };
        let triangles = near.iter().copied().filter(lies_on).collect();
        let far = (1e6 * (to - place).norm() / self.spacing).round() as u64;
        Some(Moved { corner, place: to, rank, far, triangles })
    }

    /// Whether a corner lies in a side of the box in which the surface is flat.
    fn lies_in(&self, side: usize, at: [usize; 3]) -> bool {
        let (axis, upper) = (side / 2, side % 2 == 1);
        let end = if upper { self.laid.counts[axis] } else { 0 };
        at[axis] == end && self.laid.flat[side].contains(&true) && self.laid.in_lattice(side, self.spacing)
    }

    fn corners(&self, triangle: u32) -> [Vec3; 3] {
        self.surface.places(&self.surface.triangles[triangle as usize])
    }

    /// Triangles of the cells round a corner.
    fn near(&self, at: [usize; 3]) -> BTreeSet<u32> {
        let range =
            |axis: usize| at[axis].saturating_sub(REACH)..(at[axis] + REACH).min(self.laid.counts[axis]);
        let mut out = BTreeSet::new();
        for i in range(0) {
            for j in range(1) {
                range(2).for_each(|k| out.extend(&self.triangles[self.cut.number([i, j, k])]));
            }
        }
        out
    }

    /// The place of the surface that is nearest to x, of its edges and corners in flat sides where x is to stay in them, with its triangles.
    fn nearest(&self, x: &Vec3, near: &BTreeSet<u32>, stays: &[usize]) -> Option<(Vec3, Vec<u32>)> {
        let lies =
            |p: &Vec3, side: &usize| (p[side / 2] - self.laid.plane(*side)).abs() <= IN_PLANE * self.spacing;
        let mut found: Vec<(f64, Vec3, u32)> = Vec::new();
        for &triangle in near {
            let corners = self.corners(triangle);
            let mut add = |place: Vec3| found.push(((place - x).norm(), place, triangle));
            if stays.is_empty() {
                add(on_triangle(x, corners));
                continue;
            }
            if stays.iter().any(|side| self.laid.flat[*side][triangle as usize]) {
                continue;
            }
            let inside: Vec<Vec3> =
                corners.into_iter().filter(|p| stays.iter().all(|side| lies(p, side))).collect();
            match inside[..] {
                [a] if stays.len() > 1 => add(a),
                [a, b] => add(on_edge(x, [a, b])),
                _ => {}
            }
        }
        let least = found.iter().map(|own| own.0).reduce(f64::min)?;
        let slack = AS_NEAR * self.spacing;
        found.retain(|own| own.0 <= least + slack);
        let mut places: Vec<Vec3> = Vec::new();
        for (_, place, _) in &found {
            if places.iter().all(|other| (other - place).norm() > slack) {
                places.push(*place);
            }
        }
        let mean = places.iter().sum::<Vec3>() / places.len() as f64;
        Some((mean, found.into_iter().map(|own| own.2).collect()))
    }
}
