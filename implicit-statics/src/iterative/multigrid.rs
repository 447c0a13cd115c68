//! Smoothed aggregation \[vanek1996\]: the tangent on ever coarser unknowns, and one symmetric cycle through them.

use super::aggregates::Nodes;
use super::rows::Rows;
use crate::EquilibriumError;
use crate::solver::SymmetricSolver;
use crate::vectors::unstructured;

/// Unknowns that are factored as they are.
const FEW: usize = 600;
/// Levels beyond which coarsening no longer gains.
const LEVELS: usize = 12;
/// Iterations for the largest eigenvalue of `D⁻¹K`, which comes out up to a tenth too small.
const POWER: usize = 15;
const MARGIN: f64 = 1.1;

/// A level: its matrix, how its nodes are solved, and what takes corrections from the next.
struct Level {
    matrix: Rows,
    begin: Vec<usize>,
    /// Inverses of the nodes' own blocks, row by row, one after the other.
    inverses: Vec<f64>,
    from_coarse: Rows,
    /// Correction, right side and residual of this level.
    x: Vec<f64>,
    right: Vec<f64>,
    residual: Vec<f64>,
}

/// An approximate inverse of a tangent, symmetric and positive.
pub(super) struct Multigrid {
    levels: Vec<Level>,
    coarsest: SymmetricSolver,
    right: Vec<f64>,
}

impl Multigrid {
    /// Builds the levels of a tangent.
    pub fn new(mut matrix: Rows, mut nodes: Nodes) -> Result<Self, EquilibriumError> {
        let mut levels = Vec::new();
        while matrix.len() > FEW && levels.len() < LEVELS {
            let inverses = inverses(&matrix, &nodes.begin)?;
            let (group, count) = nodes.groups(&matrix);
            let (motions, coarse) = nodes.motions(&group, count);
            let from_coarse = smoothed(&matrix, &nodes.begin, &inverses, motions);
            let next = from_coarse.transposed().product(&matrix.product(&from_coarse));
            let zeros = || vec![0.0; matrix.len()];
            let (x, right, residual) = (zeros(), zeros(), zeros());
            levels.push(Level { begin: nodes.begin, inverses, from_coarse, x, right, residual, matrix });
            (matrix, nodes) = (next, coarse);
        }
        let (mut pattern, mut values) = (Vec::new(), Vec::new());
        for i in 0..matrix.len() {
            let (at, row) = matrix.row(i);
            for (&j, &value) in at.iter().zip(row).filter(|(j, _)| **j as usize <= i) {
                pattern.push((i, j as usize));
                values.push(value);
            }
        }
        let mut coarsest = SymmetricSolver::new(matrix.len(), &pattern)?;
        let inertia = coarsest.factor(&values)?;
        if inertia.negative + inertia.zero > 0 {
            return Err(EquilibriumError::Indefinite { found: "in the motion of large parts" });
        }
        Ok(Self { levels, coarsest, right: vec![0.0; matrix.len()] })
    }

    /// Unknowns of each level, finest first.
    pub fn unknowns(&self) -> Vec<usize> {
        self.levels.iter().map(|level| level.matrix.len()).chain([self.right.len()]).collect()
    }

    /// The finest matrix; none where it was factored as it is.
    pub fn finest(&self) -> Option<&Rows> {
        self.levels.first().map(|level| &level.matrix)
    }

    /// `out ≈ K⁻¹ right`: nodes in order on the way down, in reverse on the way up.
    pub fn cycle(&mut self, right: &[f64], out: &mut [f64]) -> Result<(), EquilibriumError> {
        let Self { levels, coarsest, right: last } = self;
        match levels.first_mut() {
            Some(level) => level.right.copy_from_slice(right),
            None => last.copy_from_slice(right),
        }
        for i in 0..levels.len() {
            let (above, below) = levels.split_at_mut(i + 1);
            let level = &mut above[i];
            level.x.fill(0.0);
            (0..level.begin.len() - 1).for_each(|node| level.solve_node(node));
            for row in 0..level.x.len() {
                level.residual[row] = level.right[row] - level.matrix.times(row, &level.x);
            }
            let next = below.first_mut().map_or(&mut *last, |next| &mut next.right);
            level.from_coarse.apply_transposed(&level.residual, next);
        }
        coarsest.solve(last)?;
        for i in (0..levels.len()).rev() {
            let (above, below) = levels.split_at_mut(i + 1);
            let level = &mut above[i];
            let correction = below.first().map_or(&*last, |next| &next.x);
            for (row, x) in level.x.iter_mut().enumerate() {
                *x += level.from_coarse.times(row, correction);
            }
            (0..level.begin.len() - 1).rev().for_each(|node| level.solve_node(node));
        }
        out.copy_from_slice(levels.first().map_or(&*last, |level| &level.x));
        Ok(())
    }
}

impl Level {
    /// Balances one node, all others held.
    fn solve_node(&mut self, node: usize) {
        let (begin, end) = (self.begin[node], self.begin[node + 1]);
        let size = end - begin;
        let mut residual = [0.0; 6];
        for (row, residual) in (begin..end).zip(&mut residual) {
            *residual = self.right[row] - self.matrix.times(row, &self.x);
        }
        let inverse = block(&self.inverses, begin, size);
        for (row, inverse) in inverse.chunks_exact(size.max(1)).enumerate() {
            self.x[begin + row] += inverse.iter().zip(&residual).map(|(a, r)| a * r).sum::<f64>();
        }
    }
}

/// The inverse of a node: rows of six numbers an unknown are reserved.
fn block(inverses: &[f64], begin: usize, size: usize) -> &[f64] {
    &inverses[6 * begin..][..size * size]
}

/// Inverses of the nodes' own blocks.
fn inverses(matrix: &Rows, begin: &[usize]) -> Result<Vec<f64>, EquilibriumError> {
    let mut all = vec![0.0; 6 * matrix.len()];
    for node in begin.windows(2) {
        let size = node[1] - node[0];
        let own = &mut all[6 * node[0]..][..size * size];
        for (i, row) in (node[0]..node[1]).enumerate() {
            let (at, values) = matrix.row(row);
            for (&column, &value) in at.iter().zip(values) {
                if (node[0]..node[1]).contains(&(column as usize)) {
                    own[i * size + column as usize - node[0]] = value;
                }
            }
        }
        invert(own, size).ok_or(EquilibriumError::Indefinite { found: "at a single node" })?;
    }
    Ok(all)
}

/// The inverse of a positive definite matrix in place, by Gauss and Jordan; none if a pivot is not positive.
fn invert(a: &mut [f64], n: usize) -> Option<()> {
    for k in 0..n {
        let pivot = a[k * n + k];
        if pivot.is_nan() || pivot <= 0.0 {
            return None;
        }
        a[k * n + k] = 1.0;
        (0..n).for_each(|j| a[k * n + j] /= pivot);
        for i in (0..n).filter(|&i| i != k) {
            let factor = std::mem::take(&mut a[i * n + k]);
            (0..n).for_each(|j| a[i * n + j] -= factor * a[k * n + j]);
        }
    }
    Some(())
}

/// `(1 − 4/(3ρ) D⁻¹K) P`, ρ the largest eigenvalue of `D⁻¹K`.
fn smoothed(matrix: &Rows, begin: &[usize], inverses: &[f64], motions: Rows) -> Rows {
    let scaled = |right: &[f64], out: &mut [f64]| {
        for node in begin.windows(2) {
            let size = node[1] - node[0];
            for (row, inverse) in block(inverses, node[0], size).chunks_exact(size.max(1)).enumerate() {
                out[node[0] + row] = inverse.iter().zip(&right[node[0]..]).map(|(a, r)| a * r).sum();
            }
        }
    };
    let n = matrix.len();
    let (mut x, mut kx, mut largest) = (unstructured(n, 0), vec![0.0; n], 1.0);
    for _ in 0..POWER {
        let norm = x.iter().map(|x| x * x).sum::<f64>().sqrt();
        x.iter_mut().for_each(|x| *x /= norm);
        matrix.apply(&x, &mut kx);
        scaled(&kx, &mut x);
        largest = x.iter().map(|x| x * x).sum::<f64>().sqrt();
    }
    let part = 4.0 / (3.0 * MARGIN * largest);
    // D⁻¹ times rows of K P, which take up all columns that the node's rows have.
    let mut out = matrix.product(&motions);
    for node in begin.windows(2) {
        let size = node[1] - node[0];
        let inverse = block(inverses, node[0], size);
        let range = out.begin[node[0]]..out.begin[node[1]];
        let width = range.len() / size.max(1);
        debug_assert!((node[0]..node[1]).all(|row| out.row(row).0 == out.row(node[0]).0));
        let before = out.values[range.clone()].to_vec();
        for row in 0..size {
            for k in 0..width {
                let sum: f64 = (0..size).map(|j| inverse[row * size + j] * before[j * width + k]).sum();
                out.values[range.start + row * width + k] = -part * sum;
            }
            let own = range.start + row * width..range.start + (row + 1) * width;
            let (at, values) = motions.row(node[0] + row);
            for (&column, value) in at.iter().zip(values) {
                if let Ok(k) = out.at[own.clone()].binary_search(&column) {
                    out.values[own.start + k] += value;
                }
            }
        }
    }
    out
}
