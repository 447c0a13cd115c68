//! Which nodes of a surface hold a point that is glued to it.

use std::collections::{BTreeMap, BTreeSet};

use contact::{Foot, Nearest};
use sph_core::{CellList, Vec3};

/// Distances, over the bound, that count as the same: those of cells that share the place that is nearest.
const ALIKE: f64 = 1e-6;
/// Least cosine of the angle between cells that are one smooth surface.
const SMOOTH: f64 = 0.7;

/// A surface on which the nodes nearest to points are sought.
pub(super) struct Near<'a> {
    cells: &'a [Vec<u32>],
    rest: &'a [Vec3],
    /// Cells at each node.
    at: BTreeMap<u32, Vec<usize>>,
    boxes: CellList,
    /// Distance within which cells count, and how far their middles may be for that \[L\].
    bound: f64,
    reach: f64,
    /// Whether it bends: else the corners of one cell are enough.
    bends: bool,
}

/// A point as it stands over corners of a shell, `Σ w_i (x_i + ζ d_i)`.
pub(super) struct Raised {
    /// Corners with their weights w, which sum to one, ascending.
    pub weights: Vec<(u32, f64)>,
    /// Height ζ along directors \[L\].
    pub height: f64,
}

impl Raised {
    /// The same with corners numbered from one of them on.
    pub fn numbered_from(mut self, first: u32) -> Self {
        self.weights.iter_mut().for_each(|(a, _)| *a -= first);
        self
    }
}

impl<'a> Near<'a> {
    /// Cells over nodes at rest \[L\], within a distance of points \[L\].
    pub fn new(cells: &'a [Vec<u32>], rest: &'a [Vec3], bound: f64, bends: bool) -> Self {
        let corners = |cell: &'a Vec<u32>| cell.iter().map(|&a| rest[a as usize]);
        let middle = |cell: &'a Vec<u32>| corners(cell).sum::<Vec3>() / cell.len() as f64;
        let middles: Vec<Vec3> = cells.iter().map(middle).collect();
        let size = |(cell, middle): (&'a Vec<u32>, &Vec3)| {
            corners(cell).map(|x| (x - middle).norm()).fold(0.0, f64::max)
        };
        let reach = bound + cells.iter().zip(&middles).map(size).fold(0.0, f64::max);
        let mut at: BTreeMap<u32, Vec<usize>> = BTreeMap::new();
        for (number, cell) in cells.iter().enumerate() {
            cell.iter().for_each(|&a| at.entry(a).or_default().push(number));
        }
        Self { cells, rest, at, boxes: CellList::new(&middles, reach), bound, reach, bends }
    }

    /// The nodes that hold a point, and its foot on them; none where the surface is beyond the bound.
    ///
    /// The nodes are those of the nearest cells and of the cells beside them that are one smooth surface with them, so that a mirror changes nothing.
    pub fn foot(&self, point: &Vec3) -> Option<(Vec<u32>, Foot)> {
        let mut near = Vec::new();
        self.boxes.within(point, self.reach, &mut near);
        let found =
            near.iter().filter_map(|&cell| Some((cell as usize, self.nearest(cell as usize, point)?)));
        let mut found: Vec<(usize, Nearest)> = found.filter(|(_, own)| own.distance <= self.bound).collect();
        let least = found.iter().map(|(_, own)| own.distance).fold(f64::INFINITY, f64::min);
        found.retain(|(_, own)| own.distance <= least + ALIKE * self.bound);
        let &(cell, first) = found.first()?;
        if self.bends {
            // Across an edge of the body the cells before the point, or else the first.
            found.retain(|(_, own)| own.normal.dot(&first.normal).abs() > SMOOTH);
            let along =
                |own: &Nearest| if own.normal.dot(&first.normal) < 0.0 { -own.normal } else { own.normal };
            let normal = found.iter().map(|(_, own)| along(own)).sum::<Vec3>().normalize();
            let nodes = self.about(&found, &normal);
            let places = self.places(&nodes);
            if let Some(foot) = Foot::fitted(point, &places, &first.place, &normal) {
                return Some((nodes, foot));
            }
        }
        let foot = first.on_corners(point, &self.places(&self.cells[cell]))?;
        Some((self.cells[cell].clone(), foot))
    }

    /// The corners of the nearest cell that stand with their directors for a point, with their weights and its height along these; none where the
    /// surface is beyond the bound.
    pub fn raised(&self, point: &Vec3, director: impl Fn(u32) -> Vec3) -> Option<Raised> {
        let mut near = Vec::new();
        self.boxes.within(point, self.reach, &mut near);
        let found =
            near.iter().filter_map(|&cell| Some((cell as usize, self.nearest(cell as usize, point)?)));
        let found = found.filter(|(_, own)| own.distance <= self.bound);
        let (cell, nearest) = found.min_by(|(_, a), (_, b)| a.distance.total_cmp(&b.distance))?;
        let corners = &self.cells[cell];
        let directors: Vec<Vec3> = corners.iter().map(|&a| director(a)).collect();
        let (weights, height) = nearest.by_directors(point, &self.places(corners), &directors)?;
        let weights = corners.iter().copied().zip(weights).filter(|(_, weight)| *weight != 0.0);
        let mut weights: Vec<(u32, f64)> = weights.collect();
        weights.sort_unstable_by_key(|&(a, _)| a);
        Some(Raised { weights, height })
    }

    /// Distance of the nearest cell \[L\].
    pub fn least(&self, point: &Vec3) -> f64 {
        let all = (0..self.cells.len()).filter_map(|cell| self.nearest(cell, point));
        all.map(|own| own.distance).fold(f64::INFINITY, f64::min)
    }

    /// Nodes of some cells and of those beside them, ascending.
    fn about(&self, found: &[(usize, Nearest)], normal: &Vec3) -> Vec<u32> {
        let mut nodes = BTreeSet::new();
        for (cell, _) in found {
            for beside in self.cells[*cell].iter().flat_map(|node| &self.at[node]) {
                if self.normal(*beside).is_some_and(|own| own.dot(normal).abs() > SMOOTH) {
                    nodes.extend(self.cells[*beside].iter().copied());
                }
            }
        }
        nodes.into_iter().collect()
    }

    fn normal(&self, cell: usize) -> Option<Vec3> {
        let places = self.places(&self.cells[cell]);
        let middle = places.iter().sum::<Vec3>() / places.len() as f64;
        Some(Nearest::on(&middle, &places)?.normal)
    }

    fn nearest(&self, cell: usize, point: &Vec3) -> Option<Nearest> {
        Nearest::on(point, &self.places(&self.cells[cell]))
    }

    fn places(&self, nodes: &[u32]) -> Vec<Vec3> {
        nodes.iter().map(|&a| self.rest[a as usize]).collect()
    }
}
