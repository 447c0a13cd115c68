//! Blocks of second derivatives: which pairs of rows share one.

use sph_core::Vec3;

/// Second derivatives `∂²U/∂row∂row` of one pair of rows \[F/L\].
pub(crate) type Coupling = [[f64; 3]; 3];

/// Pairs of rows (the first not before the second) that share a block, row by row, seconds ascending.
#[derive(Clone, Debug)]
pub(crate) struct Couplings {
    /// First block of each row, and the end.
    pub offsets: Vec<u32>,
    /// The second row of each block; the last of a row is the row itself.
    pub columns: Vec<u32>,
}

impl Couplings {
    /// Joins each row with the rows listed for it, in any order, again and again; those after it do not count.
    pub fn new(rows: usize, mut partners: impl FnMut(usize, &mut Vec<u32>)) -> Self {
        let mut out = Self { offsets: vec![0], columns: Vec::new() };
        let mut row = Vec::new();
        for a in 0..rows {
            row.clear();
            partners(a, &mut row);
            row.retain(|&b| (b as usize) < a);
            row.push(a as u32);
            row.sort_unstable();
            row.dedup();
            out.columns.extend(&row);
            out.offsets.push(out.columns.len() as u32);
        }
        out
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        self.offsets.len() - 1
    }

    /// Blocks of a row.
    pub fn of(&self, row: usize) -> std::ops::Range<usize> {
        self.offsets[row] as usize..self.offsets[row + 1] as usize
    }

    /// The block of a row with a second row that it shares one with.
    pub fn place(&self, row: usize, second: u32) -> usize {
        let blocks = self.of(row);
        blocks.start + self.columns[blocks].partition_point(|&b| b < second)
    }
}

/// Adds `factor a bᵀ`.
#[inline(always)]
pub(crate) fn add_outer(block: &mut Coupling, factor: f64, a: &Vec3, b: &Vec3) {
    for i in 0..3 {
        for j in 0..3 {
            block[i][j] += factor * a[i] * b[j];
        }
    }
}

/// `block · v`.
pub(crate) fn product(block: &Coupling, v: &Vec3) -> Vec3 {
    Vec3::from_fn(|i, _| (0..3).map(|j| block[i][j] * v[j]).sum())
}

/// `blockᵀ · v`.
pub(crate) fn transposed_product(block: &Coupling, v: &Vec3) -> Vec3 {
    Vec3::from_fn(|i, _| (0..3).map(|j| block[j][i] * v[j]).sum())
}
