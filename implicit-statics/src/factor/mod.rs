//! The factor `L D Lᵀ` of a sparse symmetric matrix by supernodes: its pivots, its growth, and substitution with it.
//!
//! Values lie as faer puts them: each supernode is a matrix in column-major order, the square of its own columns above the rows
//! below, L with a unit diagonal and D in its place. Where pivots were exchanged, D has blocks of two as well.

mod eliminate;
mod room;
mod substitute;
mod tree;
mod walk;

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::SparseColMatRef;
use faer::sparse::linalg::cholesky::SymbolicCholesky;
use faer::{Par, Side};

use crate::inertia::Inertia;
use room::Room;
use tree::{Tree, Work};

/// A factor, for one symbolic analysis.
pub(crate) struct Factor {
    tree: Tree,
    /// What work along it needs at a time.
    sizes: Room,
    /// The unknown at each place of the order of elimination.
    order: Option<Vec<usize>>,
    values: Vec<f64>,
    room: Vec<f64>,
    /// Couplings of pivots that form a block of two with the next.
    subdiagonal: Vec<f64>,
    /// Whether pivots were exchanged, within supernodes: what stands at each place, and where each went.
    exchanged: bool,
    forward: Vec<usize>,
    inverse: Vec<usize>,
}

impl Factor {
    pub fn new(
        symbolic: &SymbolicCholesky<usize>,
        matrix: faer::sparse::SymbolicSparseColMatRef<usize>,
    ) -> Self {
        let tree = Tree::new(symbolic, matrix);
        let sizes = Room::of(&tree);
        let columns = tree.columns();
        Self {
            order: symbolic.perm().map(|perm| perm.arrays().0.to_vec()),
            values: vec![0.0; tree.values()],
            room: vec![0.0; sizes.of_all(Work::Factor)],
            subdiagonal: vec![0.0; columns],
            exchanged: false,
            forward: (0..columns).collect(),
            inverse: (0..columns).collect(),
            tree,
            sizes,
        }
    }

    /// Number of values.
    pub fn entries(&self) -> usize {
        self.values.len()
    }

    /// Factors the values of the matrix without exchanging pivots. One that is zero leaves numbers that are not finite.
    pub fn eliminate(&mut self, matrix: &[f64]) {
        eliminate::eliminate((&self.tree, &self.sizes), matrix, &mut self.values, &mut self.room);
        self.exchanged = false;
        self.subdiagonal.fill(0.0);
    }

    /// Factors with pivots exchanged within supernodes \[bunch1977\].
    pub fn eliminate_pivoted(
        &mut self,
        symbolic: &SymbolicCholesky<usize>,
        matrix: SparseColMatRef<usize, f64>,
    ) {
        // faer writes the subdiagonal of 2×2 pivots only: those of the last factor would stay.
        self.subdiagonal.fill(0.0);
        let scratch = symbolic.factorize_numeric_intranode_lblt_scratch::<f64>(Par::Seq, Default::default());
        symbolic.factorize_numeric_intranode_lblt(
            &mut self.values,
            &mut self.subdiagonal,
            &mut self.forward,
            &mut self.inverse,
            matrix,
            Side::Lower,
            Par::Seq,
            MemStack::new(&mut MemBuffer::new(scratch)),
            Default::default(),
        );
        self.exchanged = true;
    }

    /// Signs of the pivots, and the least magnitude of their eigenvalues (zero if not finite).
    pub fn count_pivots(&self) -> (Inertia, f64) {
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
        for s in 0..self.tree.count() {
            let mut columns = self.tree.supernode(&self.values, s).columns(self.tree.width(s));
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
    pub fn growth(&self) -> f64 {
        let mut sums = vec![0.0; self.tree.columns()];
        for s in 0..self.tree.count() {
            let supernode = self.tree.supernode(&self.values, s);
            for (j, pivot, square, rest) in supernode.columns(self.tree.width(s)) {
                sums[j] += pivot.abs();
                for (sum, l) in sums[j + 1..].iter_mut().zip(square) {
                    *sum += l * l * pivot.abs();
                }
                for (&row, l) in supernode.rows.iter().zip(rest) {
                    sums[row as usize] += l * l * pivot.abs();
                }
            }
        }
        sums.into_iter().fold(0.0, f64::max)
    }
}
