//! A symmetric matrix of blocks of three by three between nodes, its upper half by rows.

use std::mem::replace;

use implicit_statics::BlockPattern;

use crate::discretisation::Cell;

/// Which nodes couple, and the values between them.
///
/// Row I holds the columns J ≥ I, ascending; its nine component planes lie one after the other, each as long as the row.
pub(crate) struct Blocks {
    pattern: BlockPattern,
    values: Vec<f64>,
}

impl Blocks {
    /// Zeros between all nodes that share one of these lists, each ascending.
    pub fn new(nodes: usize, lists: &[&[u32]]) -> Self {
        let mut of: Vec<Vec<(u32, u32)>> = vec![Vec::new(); nodes]; // lists that hold a node, and where
        for (number, list) in lists.iter().enumerate() {
            for (at, &node) in list.iter().enumerate() {
                of[node as usize].push((number as u32, at as u32));
            }
        }
        let mut seen = vec![usize::MAX; nodes];
        let pattern = BlockPattern::new(nodes, |node, row| {
            let others = of[node].iter().flat_map(|&(list, at)| &lists[list as usize][at as usize..]);
            row.extend(others.filter(|&&other| replace(&mut seen[other as usize], node) != node));
        });
        Self { values: vec![0.0; 9 * pattern.blocks()], pattern }
    }

    /// Forgets all values.
    pub fn clear(&mut self) {
        self.values.fill(0.0);
    }

    /// Number of values.
    pub fn len(&self) -> usize {
        self.values.len()
    }

    /// Where the value between parameters `3I + i` and `3J + k`, J ≥ I, is stored, if nodes I and J couple.
    pub fn place(&self, row: usize, column: usize) -> Option<usize> {
        let (i, k) = (row % 3, column % 3);
        let own = self.pattern.of(row / 3);
        let block = self.pattern.find((row / 3) as u32, (column / 3) as u32)?;
        Some(9 * own.start + (3 * i + k) * own.len() + block - own.start)
    }

    /// The values.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Adds the matrix of a cell: for each of its nodes I nine rows `3i + k` over its nodes J, of which J ≥ I count.
    pub fn add_cell(&mut self, cell: &Cell, matrix: &[f64]) {
        let width = cell.width;
        for &(first, length) in &cell.runs {
            for at in first..first + length {
                let node = cell.nodes[at as usize] as usize;
                let (begin, columns) = (self.pattern.of(node).start, self.pattern.columns(node));
                let count = columns.len();
                for &(other, other_length) in cell.runs.iter().filter(|run| run.0 + run.1 > at) {
                    let from = other.max(at) as usize;
                    let length = (other + other_length) as usize - from;
                    let place = columns.partition_point(|&c| c < cell.nodes[from]);
                    for component in 0..9 {
                        let source = &matrix[(9 * at as usize + component) * width + from..][..length];
                        let target = &mut self.values[9 * begin + component * count + place..][..length];
                        target.iter_mut().zip(source).for_each(|(target, source)| *target += source);
                    }
                }
            }
        }
    }

    /// Adds a block between nodes `I ≤ J` that couple, by rows.
    pub fn add(&mut self, row: u32, column: u32, block: &[[f64; 3]; 3]) {
        let count = self.pattern.of(row as usize).len();
        if let Some(place) = self.place(3 * row as usize, 3 * column as usize) {
            for i in 0..3 {
                for k in 0..3 {
                    self.values[place + (3 * i + k) * count] += block[i][k];
                }
            }
        }
    }

    /// `out = K x` over all parameters.
    pub fn product(&self, x: &[f64], out: &mut [f64]) {
        out.fill(0.0);
        self.visit(|row, column, place| {
            out[row] += self.values[place] * x[column];
            if row != column {
                out[column] += self.values[place] * x[row];
            }
        });
    }

    /// Visits every value once: parameters of row and column, place. Of diagonal blocks the upper half is left out.
    pub fn visit(&self, mut found: impl FnMut(usize, usize, usize)) {
        for row in 0..self.pattern.rows() {
            let columns = self.pattern.columns(row);
            for component in 0..9 {
                let (i, k) = (component / 3, component % 3);
                for (at, &column) in columns.iter().enumerate() {
                    if column as usize > row || k >= i {
                        let place = 9 * self.pattern.of(row).start + component * columns.len() + at;
                        found(3 * row + i, 3 * column as usize + k, place);
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::discretisation::runs;

    #[test]
    fn places_are_where_values_are_added_and_each_is_visited_once() {
        let lists = [vec![0, 1, 3], vec![1, 2], vec![0, 1, 3]];
        let mut blocks = Blocks::new(4, &[&lists[0], &lists[1], &lists[2]]);
        assert_eq!(blocks.pattern.columns(0), [0, 1, 3]);
        assert_eq!(blocks.pattern.columns(1), [1, 2, 3]);
        assert_eq!(blocks.place(0, 6), None);
        blocks.add(1, 3, &[[1.0, 2.0, 3.0], [4.0, 5.0, 6.0], [7.0, 8.0, 9.0]]);
        let mut count = 0;
        blocks.visit(|row, column, place| {
            count += 1;
            assert_eq!(blocks.place(row, column), Some(place));
            let inside = row / 3 == 1 && column / 3 == 3;
            let value = if inside { (3 * (row % 3) + column % 3 + 1) as f64 } else { 0.0 };
            assert_eq!(blocks.values()[place], value);
        });
        assert_eq!(count, blocks.len() - 3 * 4);
        assert_eq!(runs(&[4, 5, 6, 9, 11, 12]), [(0, 3), (3, 1), (4, 2)]);
    }
}
