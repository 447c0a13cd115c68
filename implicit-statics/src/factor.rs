//! The factor `L D Lᵀ` of a sparse symmetric matrix by supernodes: its pivots, its growth, and substitution with it.
//!
//! Values lie as faer puts them: each supernode is a matrix in column-major order, the square of its own columns above the rows
//! below, L with a unit diagonal and D in its place. Where pivots were exchanged, D has blocks of two as well.

use faer::sparse::linalg::cholesky::supernodal::SymbolicSupernodalCholesky;
use faer::sparse::linalg::cholesky::{SymbolicCholesky, SymbolicCholeskyRaw};

use crate::inertia::Inertia;

/// Values of a factor, for one symbolic analysis.
pub(crate) struct Factor {
    pub values: Vec<f64>,
    /// Couplings of pivots that form a block of two with the next.
    pub subdiagonal: Vec<f64>,
    /// Exchanges within supernodes: what stands at each place, and where each went.
    pub forward: Vec<usize>,
    pub inverse: Vec<usize>,
    /// Rows below a supernode, while it is at work.
    below: Vec<f64>,
    /// The right side in the order of pivots.
    ordered: Vec<f64>,
}

/// The supernodes of an analysis that was asked for them.
pub(crate) fn supernodes(symbolic: &SymbolicCholesky<usize>) -> &SymbolicSupernodalCholesky<usize> {
    match symbolic.raw() {
        SymbolicCholeskyRaw::Supernodal(supernodes) => supernodes,
        SymbolicCholeskyRaw::Simplicial(_) => unreachable!("the supernodal factor was asked for"),
    }
}

/// A supernode: its columns `begin..end`, the rows below them, and its values.
struct Supernode<'a> {
    begin: usize,
    end: usize,
    rows: &'a [usize],
    values: &'a [f64],
}

impl<'a> Supernode<'a> {
    fn of(supernodes: &'a SymbolicSupernodalCholesky<usize>, values: &'a [f64], s: usize) -> Self {
        let (begin, end) = (supernodes.supernode_begin()[s], supernodes.supernode_end()[s]);
        let rows = supernodes.supernode(s).pattern();
        let first = supernodes.col_ptr_for_val()[s];
        Self { begin, end, rows, values: &values[first..first + (end - begin) * (end - begin + rows.len())] }
    }

    /// Columns in order: number, pivot, what is below it in the square, what is below the square.
    fn columns(&self) -> impl DoubleEndedIterator<Item = (usize, f64, &'a [f64], &'a [f64])> + use<'a> {
        let (begin, width) = (self.begin, self.end - self.begin);
        let height = width + self.rows.len();
        self.values.chunks_exact(height).enumerate().map(move |(j, column)| {
            let (square, rest) = column.split_at(width);
            (begin + j, square[j], &square[j + 1..], rest)
        })
    }
}

impl Factor {
    pub fn new(symbolic: &SymbolicCholesky<usize>) -> Self {
        let (supernodes, n) = (supernodes(symbolic), symbolic.nrows());
        let tallest = (0..supernodes.n_supernodes()).map(|s| supernodes.supernode(s).pattern().len()).max();
        Self {
            values: vec![0.0; symbolic.len_val()],
            subdiagonal: vec![0.0; n],
            forward: (0..n).collect(),
            inverse: (0..n).collect(),
            below: vec![0.0; tallest.unwrap_or(0)],
            ordered: vec![0.0; n],
        }
    }

    /// Takes the values for a factor whose pivots were not exchanged.
    pub fn unpivoted(&mut self) {
        self.subdiagonal.fill(0.0);
        for order in [&mut self.forward, &mut self.inverse] {
            order.iter_mut().enumerate().for_each(|(i, place)| *place = i);
        }
    }

    /// Signs of the pivots, and the least magnitude of their eigenvalues (zero if not finite).
    pub fn count_pivots(&self, symbolic: &SymbolicCholesky<usize>) -> (Inertia, f64) {
        let supernodes = supernodes(symbolic);
        let mut inertia = Inertia::default();
        let mut smallest = f64::INFINITY;
        let mut count = |pivot: f64| {
            match pivot {
                p if p > 0.0 => inertia.positive += 1,
                p if p < 0.0 => inertia.negative += 1,
                _ => inertia.zero += 1,
            }
            smallest = smallest.min(if pivot.is_finite() { pivot.abs() } else { 0.0 });
        };
        for s in 0..supernodes.n_supernodes() {
            let mut columns = Supernode::of(supernodes, &self.values, s).columns();
            while let Some((j, pivot, ..)) = columns.next() {
                let coupling = self.subdiagonal[j];
                if coupling == 0.0 {
                    count(pivot);
                } else if let Some((_, next, ..)) = columns.next() {
                    let (mean, half) = (0.5 * (pivot + next), 0.5 * (pivot - next));
                    let radius = libm::hypot(half, coupling);
                    count(mean + radius);
                    count(mean - radius);
                }
            }
        }
        (inertia, smallest)
    }

    /// The largest diagonal entry of `|L| |D| |L|ᵀ` of a factor whose pivots were not exchanged: its rounding is that of a matrix
    /// of such entries. A matrix that is positive definite is this product itself.
    pub fn growth(&mut self, symbolic: &SymbolicCholesky<usize>) -> f64 {
        let supernodes = supernodes(symbolic);
        self.ordered.fill(0.0);
        for s in 0..supernodes.n_supernodes() {
            let supernode = Supernode::of(supernodes, &self.values, s);
            for (j, pivot, square, rest) in supernode.columns() {
                self.ordered[j] += pivot.abs();
                for (sum, l) in self.ordered[j + 1..].iter_mut().zip(square) {
                    *sum += l * l * pivot.abs();
                }
                for (&row, l) in supernode.rows.iter().zip(rest) {
                    self.ordered[row] += l * l * pivot.abs();
                }
            }
        }
        self.ordered.iter().copied().fold(0.0, f64::max)
    }

    /// Solves with the factor in place.
    pub fn substitute(&mut self, symbolic: &SymbolicCholesky<usize>, right: &mut [f64]) {
        let supernodes = supernodes(symbolic);
        let order = symbolic.perm().map(|perm| perm.arrays().0);
        let from = |place: usize| order.map_or(place, |order| order[place]);
        let Self { values, subdiagonal, forward, inverse, below, ordered: x } = self;
        for (value, &place) in x.iter_mut().zip(forward.iter()) {
            *value = right[from(place)];
        }
        for s in 0..supernodes.n_supernodes() {
            let supernode = Supernode::of(supernodes, values, s);
            let below = &mut below[..supernode.rows.len()];
            below.fill(0.0);
            for (j, _, square, rest) in supernode.columns() {
                let (own, next) = x[j..supernode.end].split_at_mut(1);
                next.iter_mut().zip(square).for_each(|(x, l)| *x -= l * own[0]);
                below.iter_mut().zip(rest).for_each(|(sum, l)| *sum += l * own[0]);
            }
            for (&row, sum) in supernode.rows.iter().zip(below) {
                x[inverse[row]] -= *sum;
            }
        }
        for s in 0..supernodes.n_supernodes() {
            let mut columns = Supernode::of(supernodes, values, s).columns();
            while let Some((j, pivot, ..)) = columns.next() {
                let coupling = subdiagonal[j];
                if coupling == 0.0 {
                    x[j] /= pivot;
                } else if let Some((_, next, ..)) = columns.next() {
                    // in units of the coupling, which is the largest entry of its block
                    let (a, b) = (pivot / coupling, next / coupling);
                    let (first, second) = (x[j] / coupling, x[j + 1] / coupling);
                    let determinant = a * b - 1.0;
                    x[j] = (b * first - second) / determinant;
                    x[j + 1] = (a * second - first) / determinant;
                }
            }
        }
        for s in (0..supernodes.n_supernodes()).rev() {
            let supernode = Supernode::of(supernodes, values, s);
            let below = &mut below[..supernode.rows.len()];
            for (value, &row) in below.iter_mut().zip(supernode.rows) {
                *value = x[inverse[row]];
            }
            for (j, _, square, rest) in supernode.columns().rev() {
                x[j] -= product(square, &x[j + 1..supernode.end]) + product(rest, below);
            }
        }
        for (value, &place) in x.iter().zip(forward.iter()) {
            right[from(place)] = *value;
        }
    }
}

/// Scalar product in four sums, one for each place modulo four.
fn product(a: &[f64], b: &[f64]) -> f64 {
    let ((a4, a1), (b4, b1)) = (a.as_chunks::<4>(), b.as_chunks::<4>());
    let mut sums = [0.0; 4];
    for (a, b) in a4.iter().zip(b4) {
        (0..4).for_each(|k| sums[k] += a[k] * b[k]);
    }
    let rest: f64 = a1.iter().zip(b1).map(|(a, b)| a * b).sum();
    (sums[0] + sums[1]) + (sums[2] + sums[3]) + rest
}
