//! A box of nodes in rows: spacings that divide its lengths, growing or even, in disorder or not.

use libm::{pow, round};

use super::Block;
use crate::Vec3;
use crate::error::SpaceError;
use crate::random::SplitMix;
use crate::surface::cell::Cell;

/// Most nodes of a block: numbers of nodes are 32 bits wide.
const MOST_NODES: f64 = 4e9;
/// Greatest ratio of last to first spacing that is accepted, and the inverse of the least.
const GREATEST_RATIO: f64 = 1e3;

/// A box of nodes, its edges along the axes.
///
/// The box is divided into cells by planes across its axes. Nodes stand at the centres of the cells, or at their corners:
/// then each takes half a cell on either side, so that those on a face have half a volume, on an edge a quarter.
#[derive(Clone, Debug, PartialEq)]
pub struct BlockLattice {
    /// Dimensions, two (in the plane through the origin across z) or three.
    pub dimensions: usize,
    /// Edges of the box \[L\]; in a plane the last is the thickness.
    pub lengths: [f64; 3],
    /// Spacing wanted along each axis \[L\]: the nearest that divides the length is taken. In a plane the last does not count.
    pub spacing: [f64; 3],
    /// The corner of least coordinates \[L\].
    pub origin: Vec3,
    /// Where in the cells the nodes stand.
    pub nodes: NodePlaces,
    /// Last over first spacing along each axis, in geometric progression; 1 is even.
    pub grading: [f64; 3],
    /// Greatest displacement of nodes at random along each axis, over their own spacing, from 0 to 0.49. Volumes stay those
    /// of the lattice; nodes on a face slide in it.
    pub disorder: f64,
    /// Seed of the random numbers: the same seed gives the same block everywhere.
    pub seed: u64,
}

/// Where in the cells of a lattice the nodes stand.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum NodePlaces {
    /// At the centres: all volumes are those of cells, faces lie half a spacing outside the outermost row.
    #[default]
    Centres,
    /// At the corners: the outermost rows lie on the faces, with half a volume.
    Edges,
}

/// The nodes along one axis.
struct Row {
    /// Where they stand, from the least coordinate of the box \[L\].
    places: Vec<f64>,
    /// The length that each stands for \[L\].
    widths: Vec<f64>,
    /// Greatest spacing \[L\].
    spacing: f64,
    /// Whether the outermost nodes stand on the faces.
    on_faces: bool,
}

impl BlockLattice {
    /// Cells along each axis; in a plane one across.
    ///
    /// # Errors
    /// [`SpaceError::OutOfRange`] for lengths and spacings that are not positive, and for more nodes than numbers.
    pub fn cells(&self) -> Result<[usize; 3], SpaceError> {
        let mut counts = [1.0; 3];
        for axis in 0..3 {
            for (what, value) in [("length", self.lengths[axis]), ("spacing", self.spacing[axis])] {
                let counted = axis < self.dimensions || what == "length";
                if counted && !(value > 0.0 && value.is_finite()) {
                    return Err(SpaceError::OutOfRange { what, value, bound: "(0, ∞)" });
                }
            }
            if axis < self.dimensions {
                counts[axis] = round(self.lengths[axis] / self.spacing[axis]).max(1.0);
            }
        }
        let nodes: f64 = counts.iter().map(|n| n + 1.0).product();
        if nodes <= MOST_NODES {
            return Ok(counts.map(|n| n as usize));
        }
        Err(SpaceError::OutOfRange { what: "number of nodes", value: nodes, bound: "[1, 4e9]" })
    }

    /// The nodes, those of the last axis running fastest.
    ///
    /// # Errors
    /// As [`BlockLattice::cells`], and for grading and disorder out of range.
    pub fn block(&self) -> Result<Block, SpaceError> {
        let counts = self.cells()?;
        if !(0.0..=0.49).contains(&self.disorder) {
            let (what, value) = ("disorder", self.disorder);
            return Err(SpaceError::OutOfRange { what, value, bound: "[0, 0.49]" });
        }
        let mut rows = Vec::new();
        for axis in 0..3 {
            rows.push(self.row(axis, counts[axis])?);
        }
        let mut block = Block {
            dimensions: self.dimensions,
            spacing: [0, 1, 2].map(|axis| rows[axis].spacing),
            ..Block::default()
        };
        let mut random = SplitMix { state: self.seed };
        let lens = [0, 1, 2].map(|axis| rows[axis].places.len());
        for place in places(lens) {
            let node = block.positions.len() as u32;
            let width = [0, 1, 2].map(|axis| rows[axis].widths[place[axis]]);
            let mut x = self.origin;
            for axis in 0..3 {
                let row = &rows[axis];
                let outermost = place[axis] == 0 || place[axis] + 1 == lens[axis];
                let fixed = axis >= self.dimensions || (row.on_faces && outermost);
                let noise = self.disorder * width[axis] * (2.0 * random.next() - 1.0); // drawn for fixed ones too
                x[axis] += row.places[place[axis]] + if fixed { 0.0 } else { noise };
                let area = width[(axis + 1) % 3] * width[(axis + 2) % 3];
                if place[axis] == 0 {
                    block.faces[2 * axis].push((node, area));
                }
                if place[axis] + 1 == lens[axis] {
                    block.faces[2 * axis + 1].push((node, area));
                }
            }
            block.positions.push(x);
            block.volumes.push(width[0] * width[1] * width[2]);
        }
        if self.dimensions == 2 {
            block.cells = quadrangles(lens);
        }
        Ok(block)
    }

    /// The nodes along one axis, the box divided into so many cells.
    fn row(&self, axis: usize, count: usize) -> Result<Row, SpaceError> {
        let length = self.lengths[axis];
        if axis >= self.dimensions {
            return Ok(Row { places: vec![0.0], widths: vec![length], spacing: length, on_faces: false });
        }
        let planes = planes(length, count, self.grading[axis])?;
        let gaps: Vec<f64> = planes.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let spacing = gaps.iter().fold(0.0, |most: f64, &gap| most.max(gap));
        if self.nodes == NodePlaces::Centres {
            let places = planes.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).collect();
            return Ok(Row { places, widths: gaps, spacing, on_faces: false });
        }
        let half = |gap: Option<&f64>| 0.5 * gap.copied().unwrap_or(0.0);
        let width = |i: usize| half(i.checked_sub(1).and_then(|i| gaps.get(i))) + half(gaps.get(i));
        let widths = (0..planes.len()).map(width).collect();
        Ok(Row { places: planes, widths, spacing, on_faces: true })
    }
}

/// Planes that divide a length into cells whose widths grow in geometric progression.
fn planes(length: f64, count: usize, ratio: f64) -> Result<Vec<f64>, SpaceError> {
    if !(1.0 / GREATEST_RATIO..=GREATEST_RATIO).contains(&ratio) {
        return Err(SpaceError::OutOfRange { what: "grading", value: ratio, bound: "[0.001, 1000]" });
    }
    if ratio == 1.0 || count < 2 {
        return Ok((0..=count).map(|i| length * i as f64 / count as f64).collect());
    }
    let mut sums = vec![0.0];
    for i in 0..count {
        sums.push(sums[i] + pow(ratio, i as f64 / (count - 1) as f64));
    }
    let whole = sums[count];
    Ok(sums.into_iter().map(|sum| length * (sum / whole)).collect())
}

/// Places in a lattice, the last running fastest.
fn places(lens: [usize; 3]) -> impl Iterator<Item = [usize; 3]> {
    let [a, b, c] = lens;
    (0..a).flat_map(move |i| (0..b).flat_map(move |j| (0..c).map(move |k| [i, j, k])))
}

/// Cells between the nodes of a plane lattice, counter-clockwise about z.
fn quadrangles([rows, columns, _]: [usize; 3]) -> Vec<Cell> {
    let node = |i: usize, j: usize| (i * columns + j) as u32;
    let cell = |i, j| Cell::quadrangle([node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)]);
    (1..rows).flat_map(|i| (1..columns).map(move |j| cell(i - 1, j - 1))).collect()
}
