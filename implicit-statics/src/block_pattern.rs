//! Which rows of a body share a block of its tangent, a row being what moves together: a node, a director, a particle with both.

use std::ops::Range;

/// Blocks by rows, the columns of each ascending: of a symmetric tangent the lower half or the upper one, with the diagonal.
#[derive(Clone, Debug)]
pub struct BlockPattern {
    /// First block of each row, and the end.
    offsets: Vec<u32>,
    /// The column of each block.
    columns: Vec<u32>,
}

impl BlockPattern {
    /// Joins each row with itself and with the rows listed for it, in any order, again and again.
    pub fn new(rows: usize, mut partners: impl FnMut(usize, &mut Vec<u32>)) -> Self {
        let mut out = Self { offsets: vec![0], columns: Vec::new() };
        let mut row = Vec::new();
        for a in 0..rows {
            row.clear();
            row.push(a as u32);
            partners(a, &mut row);
            row.sort_unstable();
            row.dedup();
            out.columns.extend(&row);
            out.offsets.push(out.columns.len() as u32);
        }
        out
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.offsets.len() - 1
    }

    /// Number of blocks.
    pub fn blocks(&self) -> usize {
        self.columns.len()
    }

    /// First block of each row, and the end.
    pub fn offsets(&self) -> &[u32] {
        &self.offsets
    }

    /// Blocks of a row.
    #[inline]
    pub fn of(&self, row: usize) -> Range<usize> {
        self.offsets[row] as usize..self.offsets[row + 1] as usize
    }

    /// Columns of the blocks of a row.
    #[inline]
    pub fn columns(&self, row: usize) -> &[u32] {
        &self.columns[self.of(row)]
    }

    /// Number of the block of a row with a column, if they share one.
    #[inline]
    pub fn find(&self, row: u32, column: u32) -> Option<usize> {
        let blocks = self.of(row as usize);
        self.columns[blocks.clone()].binary_search(&column).ok().map(|at| blocks.start + at)
    }

    /// Row, column and number of each block.
    pub fn pairs(&self) -> impl Iterator<Item = (usize, usize, usize)> {
        (0..self.rows()).flat_map(move |row| self.of(row).map(move |at| (row, self.columns[at] as usize, at)))
    }

    /// Number, row and column of the entries of each block that lie in the lower half, rows of the body standing for some unknowns each:
    /// of a lower half of blocks the order of [`crate::Equilibrium::pattern`].
    pub fn entries<'a>(
        &'a self,
        unknowns: impl Fn(usize) -> Range<usize> + Copy + 'a,
    ) -> impl Iterator<Item = (usize, usize, usize)> + 'a {
        self.pairs().flat_map(move |(a, b, block)| {
            let columns = move |row: usize| unknowns(b).filter(move |&column| column <= row);
            unknowns(a).flat_map(move |row| columns(row).map(move |column| (block, row, column)))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_have_each_partner_once_and_entries_are_those_of_the_lower_half() {
        let pattern = BlockPattern::new(3, |a, row| row.extend([0, 0].iter().filter(|_| a > 0)));
        assert_eq!(pattern.offsets(), [0, 1, 3, 5]);
        assert_eq!([pattern.columns(1), pattern.columns(2)], [[0, 1], [0, 2]]);
        assert_eq!([pattern.find(2, 0), pattern.find(2, 1)], [Some(3), None]);
        assert_eq!(pattern.pairs().last(), Some((2, 2, 4)));
        // Rows of two, no and one unknown.
        let unknowns = |row: usize| [0..2, 2..2, 2..3][row].clone();
        let entries: Vec<_> = pattern.entries(unknowns).collect();
        assert_eq!(entries, [(0, 0, 0), (0, 1, 0), (0, 1, 1), (3, 2, 0), (3, 2, 1), (4, 2, 2)]);
    }
}
