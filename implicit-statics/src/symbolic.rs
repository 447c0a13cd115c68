//! The symbolic factor of a pattern: its order of elimination and its supernodes.

use faer::Side;
use faer::perm::Perm;
use faer::sparse::SymbolicSparseColMat;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, SymbolicCholesky, SymmetricOrdering, factorize_symbolic_cholesky,
};

use crate::factor::supernodes;
use crate::ordering::{dissection, front_multiplications, sweep};

/// Unknowns up to which every order is tried: beyond, dissection is as good as minimum degree and found in less time, and a sweep
/// is analysed only where its front is narrow.
const MANY: usize = 20_000;

/// Analyses a lower triangle in the order that multiplies least: of a sweep, of nested dissection and, for few unknowns, of
/// approximate minimum degree where places are known, else by the last.
pub(crate) fn analyse(
    matrix: &SymbolicSparseColMat<usize>,
    places: Option<&[[f64; 3]]>,
) -> SymbolicCholesky<usize> {
    let Some(places) = places else {
        return in_order(matrix, SymmetricOrdering::Amd);
    };
    let placed = |order: Vec<usize>| {
        let mut inverse = vec![0; order.len()];
        order.iter().enumerate().for_each(|(new, &old)| inverse[old] = new);
        let count = order.len();
        let order = Perm::new_checked(order.into(), inverse.into(), count);
        in_order(matrix, SymmetricOrdering::Custom(order.as_ref()))
    };
    let better = |one: SymbolicCholesky<usize>, other: SymbolicCholesky<usize>| {
        if multiplications(&other) < multiplications(&one) { other } else { one }
    };
    let mut best = placed(dissection(places, matrix.col_ptr(), matrix.row_idx()));
    // A wide body swept has a wide front, and to find the supernodes of that costs a fifth of a linear answer.
    let few = places.len() <= MANY;
    let along = sweep(places);
    let front = || front_multiplications(&along, matrix.col_ptr(), matrix.row_idx());
    if few || front() < multiplications(&best) {
        best = better(best, placed(along));
    }
    if few {
        best = better(best, in_order(matrix, SymmetricOrdering::Amd));
    }
    best
}

/// Multiplications of the factor: each column updates half a square as large as what is below it.
pub(crate) fn multiplications(symbolic: &SymbolicCholesky<usize>) -> f64 {
    let supernodes = supernodes(symbolic);
    let of = |s: usize| {
        let width = (supernodes.supernode_end()[s] - supernodes.supernode_begin()[s]) as f64;
        let below = supernodes.supernode(s).pattern().len() as f64;
        width * (width * width / 6.0 + 0.5 * width * below + 0.5 * below * below)
    };
    (0..supernodes.n_supernodes()).map(of).sum()
}

fn in_order(
    matrix: &SymbolicSparseColMat<usize>,
    order: SymmetricOrdering<'_, usize>,
) -> SymbolicCholesky<usize> {
    // FORCE_SUPERNODAL is a ratio of 0, which a diagonal matrix (no multiplications) does not exceed.
    let threshold = SupernodalThreshold(SupernodalThreshold::FORCE_SUPERNODAL.0 - 1.0);
    let parameters =
        CholeskySymbolicParams { supernodal_flop_ratio_threshold: threshold, ..Default::default() };
    factorize_symbolic_cholesky(matrix.as_ref(), Side::Lower, order, parameters)
        .expect("memory for the symbolic factor")
}
