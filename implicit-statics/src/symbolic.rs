//! The symbolic factor of a pattern: its order of elimination and its supernodes.

use faer::Side;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::perm::Perm;
use faer::sparse::SymbolicSparseColMat;
use faer::sparse::linalg::cholesky::supernodal::SymbolicSupernodalCholesky;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering,
    factorize_symbolic_cholesky,
};
use faer::sparse::linalg::{SupernodalThreshold, amd};

use crate::ordering::{dissection, front_multiplications, sweep};
use crate::places::Places;
use crate::postorder::postordered;

/// Unknowns up to which every order is tried: beyond, dissection is as good as minimum degree and found in less time, and a sweep
/// is analysed only where its front is narrow.
const MANY: usize = 20_000;

/// Analyses a lower triangle in the order that multiplies least: of a sweep, of nested dissection and, for few unknowns, of
/// approximate minimum degree where places are known, else by the last. Orders are compared place by place, one is analysed.
pub(crate) fn analyse(
    matrix: &SymbolicSparseColMat<usize>,
    coordinates: Option<&[[f64; 3]]>,
) -> SymbolicCholesky<usize> {
    let Some(coordinates) = coordinates else {
        return in_order(matrix, &minimum_degree(matrix));
    };
    let places = Places::of(coordinates, matrix.col_ptr(), matrix.row_idx());
    in_order(matrix, &places.spread(&best_order(&places, coordinates.len() <= MANY)))
}

/// Of the orders of places the one that multiplies least.
fn best_order(places: &Places, few: bool) -> Vec<usize> {
    let count = places.count();
    let (pointers, rows) = (places.pointers.clone(), places.rows.clone());
    let graph = SymbolicSparseColMat::new_checked(count, count, pointers, None, rows);
    let cost = |order: &[usize]| multiplications_at(places, &in_order(&graph, order));
    let best = dissection(places);
    let along = sweep(places);
    if !few {
        // A wide body swept has a wide front.
        return if front_multiplications(&along, places) < cost(&best) { along } else { best };
    }
    let least = |(best, least): (Vec<usize>, f64), other: Vec<usize>| {
        let more = cost(&other);
        if more < least { (other, more) } else { (best, least) }
    };
    let first = cost(&best);
    [along, minimum_degree(&graph)].into_iter().fold((best, first), least).0
}

/// Multiplications of the factor of the unknowns at places, from the supernodes of their graph.
fn multiplications_at(places: &Places, symbolic: &SymbolicCholesky<usize>) -> f64 {
    let supernodes = supernodes(symbolic);
    let place_of = symbolic.perm().map(|perm| perm.arrays().0);
    let weight = |k: usize| places.weight(place_of.map_or(k, |of| of[k]));
    let of = |s: usize| {
        let width: usize = (supernodes.supernode_begin()[s]..supernodes.supernode_end()[s]).map(weight).sum();
        let below = supernodes.supernode(s).pattern().iter().map(|&row| weight(row)).sum();
        multiplications_of(width, below)
    };
    (0..supernodes.n_supernodes()).map(of).sum()
}

/// Multiplications of the factor: each column updates half a square as large as what is below it.
pub(crate) fn multiplications(symbolic: &SymbolicCholesky<usize>) -> f64 {
    let supernodes = supernodes(symbolic);
    let of = |s: usize| {
        let width = supernodes.supernode_end()[s] - supernodes.supernode_begin()[s];
        multiplications_of(width, supernodes.supernode(s).pattern().len())
    };
    (0..supernodes.n_supernodes()).map(of).sum()
}

/// Multiplications of the factor of a supernode: each column updates half a square as large as what is below it.
pub(crate) fn multiplications_of(width: usize, below: usize) -> f64 {
    let (width, below) = (width as f64, below as f64);
    width * (width * width / 6.0 + 0.5 * width * below + 0.5 * below * below)
}

/// The supernodes of an analysis that was asked for them.
pub(crate) fn supernodes(symbolic: &SymbolicCholesky<usize>) -> &SymbolicSupernodalCholesky<usize> {
    match symbolic.raw() {
        SymbolicCholeskyRaw::Supernodal(supernodes) => supernodes,
        SymbolicCholeskyRaw::Simplicial(_) => unreachable!("the supernodal factor was asked for"),
    }
}

fn minimum_degree(matrix: &SymbolicSparseColMat<usize>) -> Vec<usize> {
    let count = matrix.nrows();
    let (mut order, mut inverse) = (vec![0; count], vec![0; count]);
    let mut scratch = MemBuffer::new(amd::order_maybe_unsorted_scratch::<usize>(count, matrix.compute_nnz()));
    let stack = MemStack::new(&mut scratch);
    amd::order_maybe_unsorted(&mut order, &mut inverse, matrix.as_ref(), amd::Control::default(), stack)
        .expect("memory for the order");
    order
}

/// The analysis in an order, or in one that fills as much ([`postordered`]).
fn in_order(matrix: &SymbolicSparseColMat<usize>, order: &[usize]) -> SymbolicCholesky<usize> {
    let order = postordered(order, matrix.col_ptr(), matrix.row_idx());
    let count = order.len();
    let mut inverse = vec![0; count];
    order.iter().enumerate().for_each(|(new, &old)| inverse[old] = new);
    let order = Perm::new_checked(order.into(), inverse.into(), count);
    // FORCE_SUPERNODAL is a ratio of 0, which a diagonal matrix (no multiplications) does not exceed.
    let threshold = SupernodalThreshold(SupernodalThreshold::FORCE_SUPERNODAL.0 - 1.0);
    let parameters =
        CholeskySymbolicParams { supernodal_flop_ratio_threshold: threshold, ..Default::default() };
    factorize_symbolic_cholesky(
        matrix.as_ref(),
        Side::Lower,
        SymmetricOrdering::Custom(order.as_ref()),
        parameters,
    )
    .expect("memory for the symbolic factor")
}
