//! Cells as wide as the reach of the kernel: every neighbour of a particle lies in its own cell or in one beside it.

use sph_core::Vec3;

/// Neighbouring cells in ranges of three: three rows in a plane, nine in space.
pub(crate) const ROWS: usize = 9;
/// Number of a cell that none has.
pub(crate) const NOWHERE: u32 = u32::MAX;
/// Cells for each particle beyond which the box is cut off, and what comes beside.
const CELLS_A_PARTICLE: usize = 8;
const CELLS_BESIDE: usize = 4096;

/// A box of cells, those along the first axis next to each other.
#[derive(Clone, Debug)]
pub(crate) struct Grid {
    dimensions: usize,
    /// Whole numbers: which cell of all space the first one is along each axis.
    first: [f64; 3],
    origin: [f64; 3],
    width: f64,
    inverse: f64,
    counts: [usize; 3],
    /// Whether particles lie beyond the box: they count for the outermost cells then.
    cut_off: bool,
}

/// Ranges of sorted particles, of which the first `count` hold some.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Ranges {
    ranges: [(u32, u32); ROWS],
    count: usize,
}

impl Ranges {
    /// Those that hold particles.
    pub fn filled(&self) -> &[(u32, u32)] {
        &self.ranges[..self.count]
    }
}

/// The least box of places \[L\]; what is no number is above nothing and below nothing.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Extent {
    pub low: [f64; 3],
    pub high: [f64; 3],
}

impl Extent {
    /// That of some places.
    pub fn of(dimensions: usize, positions: impl Iterator<Item = Vec3>) -> Self {
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for position in positions {
            let at: [f64; 3] = position.into();
            for k in 0..dimensions {
                low[k] = if at[k] < low[k] { at[k] } else { low[k] };
                high[k] = if at[k] > high[k] { at[k] } else { high[k] };
            }
        }
        Self { low, high }
    }
}

/// Cells beyond which the box of so many particles is cut off.
fn most(particles: usize) -> f64 {
    (particles * CELLS_A_PARTICLE + CELLS_BESIDE) as f64
}

impl Grid {
    /// The box around particles and one cell more on every side, of cells so wide \[L\].
    ///
    /// A few particles far away must not make it huge: beyond a number of cells it is cut off about its middle. To count
    /// for the outermost cells keeps neighbours in cells beside each other.
    pub fn around(dimensions: usize, positions: impl ExactSizeIterator<Item = Vec3>, width: f64) -> Self {
        let count = positions.len();
        Self::over(dimensions, count, Extent::of(dimensions, positions), width)
    }

    /// The same for so many particles in a box.
    pub fn over(dimensions: usize, count: usize, Extent { low, high }: Extent, width: f64) -> Self {
        let inverse = 1.0 / width;
        let mut first = [0.0; 3];
        let mut counts = [1.0; 3];
        for k in 0..dimensions {
            let (from, to) = ((low[k] * inverse).floor() - 1.0, (high[k] * inverse).floor() + 1.0);
            (first[k], counts[k]) = (from, to - from + 1.0);
        }
        // Without particles, or with one at no place, all count for one cell.
        let mut cut_off = !counts.iter().all(|count| count.is_finite());
        if cut_off {
            (first, counts) = ([0.0; 3], [1.0; 3]);
        }
        while counts.iter().product::<f64>() > most(count) {
            let widest = (0..3).fold(0, |best, k| if counts[k] > counts[best] { k } else { best });
            first[widest] += (0.25 * counts[widest]).floor();
            counts[widest] = (0.5 * counts[widest]).ceil();
            cut_off = true;
        }
        Self {
            dimensions,
            first,
            origin: first.map(|x| x * width),
            width,
            inverse,
            counts: counts.map(|count| count as usize),
            cut_off,
        }
    }

    /// Number of cells.
    pub fn len(&self) -> usize {
        self.counts.iter().product()
    }

    /// The cell of a place; [`NOWHERE`] beyond the box.
    #[inline(always)]
    pub fn cell(&self, at: &[f64; 3]) -> u32 {
        let mut cell = 0;
        for k in (0..self.dimensions).rev() {
            let count = self.counts[k];
            let place = (at[k] - self.origin[k]) * self.inverse;
            let place = if place >= 0.0 && place < count as f64 {
                place as usize
            } else if !self.cut_off && !place.is_nan() {
                return NOWHERE;
            } else if place > 0.0 {
                count - 1
            } else {
                0
            };
            cell = cell * count + place;
        }
        cell as u32
    }

    /// The cell of a place, of one beyond the box the nearest.
    pub fn nearest_cell(&self, at: &[f64; 3]) -> usize {
        let mut cell = 0;
        for k in (0..self.dimensions).rev() {
            // Conversion takes what is below zero and what is no number to zero.
            let place = ((at[k] - self.origin[k]) * self.inverse) as usize;
            cell = cell * self.counts[k] + place.min(self.counts[k] - 1);
        }
        cell
    }

    /// The cell where one of another grid of the same width lies, of one beyond the box the nearest.
    pub fn nearest_cell_to(&self, other: &Self, cell: usize) -> usize {
        let column = other.column(cell);
        let place = |k: usize| (column[k] as f64 + other.first[k] - self.first[k]) as usize;
        (0..self.dimensions).rev().fold(0, |cell, k| cell * self.counts[k] + place(k).min(self.counts[k] - 1))
    }

    /// Which cell it is along each axis.
    pub fn column(&self, cell: usize) -> [usize; 3] {
        let [nx, ny, _] = self.counts;
        [cell % nx, cell / nx % ny, cell / nx / ny]
    }

    /// Number of cells along each axis.
    pub fn counts(&self) -> [usize; 3] {
        self.counts
    }

    /// Calls for each cell so many rings about one, itself included.
    pub fn each_near(&self, cell: usize, rings: usize, mut call: impl FnMut(usize)) {
        let ([nx, ny, nz], [i, j, k]) = (self.counts, self.column(cell));
        let about = |at: usize, count: usize| at.saturating_sub(rings)..=(at + rings).min(count - 1);
        for k in about(k, nz) {
            for j in about(j, ny) {
                about(i, nx).for_each(|i| call((k * ny + j) * nx + i));
            }
        }
    }

    /// Whether the box of so many particles is cut off, or may be once each has gone as far as a cell is wide.
    pub fn may_be_cut_off(&self, particles: usize) -> bool {
        let wider = (0..self.dimensions).map(|k| (self.counts[k] + 2) as f64).product::<f64>();
        self.cut_off || wider > most(particles)
    }

    /// A place from the origin of the box on, in single precision. A place beyond cells that were cut off is no number, so that
    /// no distance to it is above any other; one that is no number is at no end of distance.
    #[inline(always)]
    pub fn single(&self, at: &[f64; 3]) -> [f32; 3] {
        std::array::from_fn(|k| {
            let place = at[k] - self.origin[k];
            let beyond = place < -self.width || place > self.width * (self.counts[k] + 1) as f64;
            if place.is_nan() {
                f32::INFINITY
            } else if self.cut_off && beyond {
                f32::NAN
            } else {
                place as f32
            }
        })
    }

    /// A reach \[L\], longer by what places and distances in single precision may be wrong: each coordinate by half of the
    /// last place of the greatest, a distance by twice that along each axis and by a few roundings of its own.
    pub fn longer(&self, reach: f64) -> f32 {
        let greatest = |k: usize| self.width * (self.counts[k] + 1) as f64;
        let single = (0..3).map(greatest).fold(0.0, f64::max) * f64::from(f32::EPSILON);
        let double = self.origin.iter().fold(0.0, |most: f64, x| most.max(x.abs())) * f64::EPSILON;
        ((reach + 4.0 * (single + double)) * (1.0 + 8.0 * f64::from(f32::EPSILON))) as f32
    }

    /// The sorted particles in a cell and beside it, when those of cell c are `starts[c]..starts[c + 1]`.
    pub fn beside(&self, cell: u32, starts: &[u32]) -> Ranges {
        let [nx, ny, nz] = self.counts;
        let [i, j, k] = self.column(cell as usize);
        let mut found = Ranges::default();
        let (from, to) = (i.saturating_sub(1), (i + 1).min(nx - 1));
        for k in k.saturating_sub(1)..=(k + 1).min(nz - 1) {
            for j in j.saturating_sub(1)..=(j + 1).min(ny - 1) {
                let row = (k * ny + j) * nx;
                let range = (starts[row + from], starts[row + to + 1]);
                if range.0 < range.1 {
                    found.ranges[found.count] = range;
                    found.count += 1;
                }
            }
        }
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn starts(grid: &Grid, cells: &[u32]) -> Vec<u32> {
        let count = |cell: usize| cells.iter().filter(|&&c| (c as usize) < cell).count() as u32;
        (0..=grid.len()).map(count).collect()
    }

    /// All pairs within a width are found in cells beside each other and by their places in single precision, also where far
    /// particles cut the box off.
    #[test]
    fn no_neighbour_is_missed() {
        for dimensions in [2, 3] {
            for far in [1.0, 1e3, 1e9] {
                let place = |i: usize| {
                    let mut state =
                        (i as f64 * 0.754_877_666, i as f64 * 0.569_840_290, i as f64 * 0.438_579);
                    if dimensions == 2 {
                        state.2 = 0.0;
                    }
                    let p = Vec3::new(state.0.fract(), state.1.fract(), state.2.fract()) * 4.0;
                    if i.is_multiple_of(40) { p.map(|x| if x == 0.0 { 0.0 } else { x + far }) } else { p }
                };
                let points: Vec<Vec3> = (0..400).map(place).collect();
                let grid = Grid::around(dimensions, points.iter().copied(), 0.5);
                let mut order: Vec<usize> = (0..points.len()).collect();
                let cells: Vec<u32> = points.iter().map(|p| grid.cell(&(*p).into())).collect();
                order.sort_by_key(|&i| cells[i]);
                let starts = starts(&grid, &cells);
                for a in 0..points.len() {
                    let ranges = grid.beside(cells[a], &starts);
                    for (b, point) in points.iter().enumerate() {
                        let slot = order.iter().position(|&i| i == b).unwrap() as u32;
                        let seen = ranges.filled().iter().any(|&(from, to)| from <= slot && slot < to);
                        let single = [points[a], *point].map(|p| grid.single(&p.into()));
                        let square = (0..3).fold(0.0, |sum, k| sum + (single[0][k] - single[1][k]).powi(2));
                        let apart = square > grid.longer(0.5).powi(2);
                        assert!((seen && !apart) || (point - points[a]).norm() > 0.5, "{a} {b}");
                    }
                }
            }
        }
    }
}
