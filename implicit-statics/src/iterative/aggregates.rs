//! Coarser unknowns: nodes in groups, and the rigid motions of each group \[vanek1996\].

use super::rows::Rows;

/// Couplings weaker than this, relative to the nodes' own stiffness, do not make a group: across long cells.
const WEAK: f64 = 0.05;

/// What of a rigid motion must be left, relative to it, once the ones before are taken out: below, a group has it not (a particle
/// without unknowns about its normal, particles on a line).
const DEPENDENT: f64 = 1e-9;

/// Unknowns of one level: nodes as ranges of unknowns, and rigid motions as rows.
pub(super) struct Nodes {
    /// First unknown of each node, and the end.
    pub begin: Vec<usize>,
    /// What each unknown does while the body moves rigidly in six ways.
    pub rigid: Vec<[f64; 6]>,
}

impl Nodes {
    pub fn len(&self) -> usize {
        self.begin.len() - 1
    }

    /// The node of each unknown.
    pub fn of_unknowns(&self) -> Vec<u32> {
        let node = |i: usize| std::iter::repeat_n(i as u32, self.begin[i + 1] - self.begin[i]);
        (0..self.len()).flat_map(node).collect()
    }

    /// Group of each node, and how many there are.
    pub fn groups(&self, matrix: &Rows) -> (Vec<u32>, usize) {
        let near = self.strong(matrix);
        let mut group = vec![u32::MAX; self.len()];
        let mut count = 0;
        // Whole neighbourhoods that are free, then what is left beside the group it hangs on most, then the rest.
        for (i, near) in near.iter().enumerate() {
            if group[i] == u32::MAX && near.iter().all(|&(j, _)| group[j as usize] == u32::MAX) {
                group[i] = count;
                near.iter().for_each(|&(j, _)| group[j as usize] = count);
                count += 1;
            }
        }
        let first = group.clone();
        for (i, near) in near.iter().enumerate().filter(|&(i, _)| first[i] == u32::MAX) {
            let beside = near.iter().filter(|&&(j, _)| first[j as usize] != u32::MAX);
            if let Some(&(j, _)) = beside.max_by(|a, b| a.1.total_cmp(&b.1)) {
                group[i] = first[j as usize];
            }
        }
        for (i, near) in near.iter().enumerate() {
            if group[i] == u32::MAX {
                group[i] = count;
                for &(j, _) in near {
                    if group[j as usize] == u32::MAX {
                        group[j as usize] = count;
                    }
                }
                count += 1;
            }
        }
        (group, count as usize)
    }

    /// Nodes that each is strongly coupled with, and the square of the coupling.
    fn strong(&self, matrix: &Rows) -> Vec<Vec<(u32, f64)>> {
        let node = self.of_unknowns();
        let mut own = vec![0.0; self.len()];
        let mut all: Vec<Vec<(u32, f64)>> = Vec::with_capacity(self.len());
        for (i, own) in own.iter_mut().enumerate() {
            let mut near: Vec<(u32, f64)> = Vec::new();
            for row in self.begin[i]..self.begin[i + 1] {
                let (at, values) = matrix.row(row);
                for (&column, value) in at.iter().zip(values) {
                    let j = node[column as usize];
                    match near.iter_mut().find(|known| known.0 == j) {
                        Some(known) => known.1 += value * value,
                        None => near.push((j, value * value)),
                    }
                }
            }
            *own = near.iter().find(|known| known.0 as usize == i).map_or(0.0, |known| known.1);
            near.retain(|known| known.0 as usize != i);
            near.sort_unstable_by_key(|known| known.0);
            all.push(near);
        }
        for (i, near) in all.iter_mut().enumerate() {
            near.retain(|&(j, square)| square > WEAK * WEAK * (own[i] * own[j as usize]).sqrt());
        }
        all
    }

    /// The rigid motions of every group as orthonormal columns, and what is left of them on those: the nodes of the next level.
    pub fn motions(&self, group: &[u32], count: usize) -> (Rows, Self) {
        let mut members = vec![Vec::new(); count];
        for (i, &group) in group.iter().enumerate() {
            members[group as usize].extend(self.begin[i]..self.begin[i + 1]);
        }
        let unknowns = self.rigid.len();
        let mut rows: Vec<Vec<(u32, f64)>> = vec![Vec::new(); unknowns];
        let mut coarse = Self { begin: vec![0], rigid: Vec::new() };
        for members in &members {
            let (columns, left) = orthonormal(members.iter().map(|&i| self.rigid[i]).collect());
            let first = coarse.rigid.len();
            for (k, column) in columns.iter().enumerate() {
                members.iter().zip(column).for_each(|(&i, &value)| rows[i].push(((first + k) as u32, value)));
            }
            coarse.rigid.extend(left);
            coarse.begin.push(coarse.rigid.len());
        }
        let mut out = Rows { columns: coarse.rigid.len(), begin: vec![0], ..Rows::default() };
        for row in rows {
            for (column, value) in row {
                out.at.push(column);
                out.values.push(value);
            }
            out.begin.push(out.at.len());
        }
        (out, coarse)
    }
}

/// Gram's and Schmidt's columns of six motions, twice for rounding, and the triangle that takes them back.
fn orthonormal(rows: Vec<[f64; 6]>) -> (Vec<Vec<f64>>, Vec<[f64; 6]>) {
    let (mut columns, mut left): (Vec<Vec<f64>>, Vec<[f64; 6]>) = Default::default();
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    for k in 0..6 {
        let mut motion: Vec<f64> = rows.iter().map(|row| row[k]).collect();
        let whole = dot(&motion, &motion).sqrt();
        for _ in 0..2 {
            for (column, left) in columns.iter().zip(&mut left) {
                let part = dot(column, &motion);
                left[k] += part;
                motion.iter_mut().zip(column).for_each(|(x, q)| *x -= part * q);
            }
        }
        let rest = dot(&motion, &motion).sqrt();
        if rest > DEPENDENT * whole && columns.len() < rows.len() {
            motion.iter_mut().for_each(|x| *x /= rest);
            columns.push(motion);
            let mut row = [0.0; 6];
            row[k] = rest;
            left.push(row);
        }
    }
    (columns, left)
}
