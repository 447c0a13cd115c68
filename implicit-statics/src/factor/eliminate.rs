//! Elimination by fronts (the multifrontal method \[duff1983, liu1992\]): each supernode takes what its children left, eliminates its own
//! columns and leaves the rest of its front for its parent.
//!
//! ```text
//! ⎡A₁₁   ·  ⎤   ⎡L₁₁   ⎤ ⎡D     ⎤ ⎡L₁₁ᵀ L₂₁ᵀ⎤      A: entries of the matrix in these columns, and what the children left
//! ⎣A₂₁  A₂₂⎦ = ⎣L₂₁  1⎦ ⎣   U ⎦ ⎣       1  ⎦      U = A₂₂ − L₂₁ D L₂₁ᵀ goes to the parent
//! ```

use std::ops::Range;

use faer::linalg::matmul::matmul;
use faer::{Accum, MatMut, MatRef, Par};
use lanes::{Lanes, Sweep, widest};

use super::room::Room;
use super::tree::{Tree, Work};
use super::walk::upward;

/// Columns that are eliminated one by one; more are halved.
const PANEL: usize = 16;
/// Columns of a product, and the number of tiles of a large one: each packs its factors anew, and of its square on the diagonal the
/// upper half is made for nothing, a twelfth of an update in twelve.
const TILE: usize = 96;
const TILES: usize = 12;
/// Multiplications of an update from which its tiles are shared among threads.
const WORTH_SHARING: usize = 1_000_000;

/// Factors a matrix, given by its entries, into the values of a tree.
pub(super) fn eliminate((tree, sizes): (&Tree, &Room), matrix: &[f64], values: &mut [f64], room: &mut [f64]) {
    upward((tree, sizes), Work::Factor, 0..tree.count(), values, room, &|s, own, left, update, scratch| {
        let (width, below) = (tree.width(s), tree.rows(s).len());
        own.fill(0.0);
        for &(entry, place) in tree.entries(s) {
            own[place as usize] = matrix[entry as usize];
        }
        take_columns(tree, s, left, own);
        factor_columns(own, width + below, 0..width, scratch);
        leave(own, width, scratch, update);
        take_rest(tree, s, left, update);
        debug_assert_eq!(update.len(), below * below);
    });
}

/// Adds what the children left to the columns of a supernode.
fn take_columns(tree: &Tree, s: usize, left: &[f64], own: &mut [f64]) {
    let (width, height) = (tree.width(s), tree.height(s));
    each_column(tree, s, left, |child, column, to, from| {
        if to < width {
            add_runs(tree, child, column, 0, from, &mut own[to * height..(to + 1) * height]);
        }
    });
}

/// Adds what they left beyond them to what the supernode leaves.
fn take_rest(tree: &Tree, s: usize, left: &[f64], update: &mut [f64]) {
    let (width, below) = (tree.width(s), tree.rows(s).len());
    each_column(tree, s, left, |child, column, to, from| {
        if let Some(to) = to.checked_sub(width) {
            add_runs(tree, child, column, width, from, &mut update[to * below..(to + 1) * below]);
        }
    });
}

/// Calls with each column that the children of a supernode left: the child, the column, its place in the front, its numbers.
fn each_column(tree: &Tree, s: usize, mut left: &[f64], mut visit: impl FnMut(usize, usize, usize, &[f64])) {
    for &child in tree.children(s) {
        let child = child as usize;
        let rows = tree.rows(child).len();
        let (own, rest) = left.split_at(rows * rows);
        for run in tree.runs(child) {
            for k in 0..run.rows {
                let column = run.from + k;
                visit(child, column, run.to + k, &own[column * rows..(column + 1) * rows]);
            }
        }
        left = rest;
    }
}

/// Adds a column from its diagonal on to one whose first row is so many rows into the front.
fn add_runs(tree: &Tree, child: usize, column: usize, first: usize, from: &[f64], to: &mut [f64]) {
    for run in tree.runs(child).iter().rev() {
        if run.from + run.rows <= column {
            break;
        }
        let skipped = column.saturating_sub(run.from);
        let from = &from[run.from + skipped..run.from + run.rows];
        let to = &mut to[run.to + skipped - first..][..from.len()];
        to.iter_mut().zip(from).for_each(|(sum, part)| *sum += part);
    }
}

/// Eliminates some columns of a front that have what came before them: L below the diagonal, D on it. The first half is eliminated, the others
/// get all of it in products, tile by tile, and are eliminated themselves.
fn factor_columns(own: &mut [f64], height: usize, columns: Range<usize>, scratch: &mut [f64]) {
    let Range { start: begin, end } = columns;
    if end - begin <= PANEL {
        return widest(Panel { own, height, begin, end });
    }
    let middle = begin + ((end - begin) / 2).next_multiple_of(PANEL);
    factor_columns(own, height, begin..middle, scratch);
    let (before, now) = own.split_at_mut(middle * height);
    let done = &before[begin * height..];
    let weighted = weighted_rows(done, height, begin, middle..end, scratch);
    let done = MatRef::from_column_major_slice(done, height, middle - begin);
    let wide = tile_width(end - middle);
    let tile = |piece: usize, tile: &mut [f64]| {
        let (first, count) = (piece * wide, tile.len() / height);
        let tile = MatMut::from_column_major_slice_mut(tile, height, count);
        let (row, rows) = (middle + first, height - middle - first);
        let (tile, done) = (tile.subrows_mut(row, rows), done.subrows(row, rows));
        matmul(tile, Accum::Add, done, weighted.subcols(first, count), -1.0, Par::Seq);
    };
    let shared = (middle - begin) * (end - middle) * (height - middle) >= WORTH_SHARING;
    parallel::pieces(shared, wide * height, &mut now[..(end - middle) * height], &tile);
    factor_columns(own, height, middle..end, scratch);
}

/// Columns of each tile of so many, whole blocks of the products' kernels.
fn tile_width(columns: usize) -> usize {
    TILE.max((columns / TILES).next_multiple_of(TILE / 2))
}

/// `D Lᵀ` for some rows of columns that are done, the first of which is this one of the front.
fn weighted_rows<'a>(
    done: &[f64],
    height: usize,
    first: usize,
    rows: Range<usize>,
    scratch: &'a mut [f64],
) -> MatRef<'a, f64> {
    let (width, count) = (done.len() / height, rows.len());
    let weighted = &mut scratch[..width * count];
    for (p, column) in done.chunks_exact(height).enumerate() {
        let pivot = column[first + p];
        column[rows.clone()].iter().enumerate().for_each(|(k, l)| weighted[k * width + p] = pivot * l);
    }
    MatRef::from_column_major_slice(weighted, width, count)
}

/// Columns of a front that have what came before them: each gets those of the panel before it, four at a time, and is divided by its
/// pivot.
struct Panel<'a> {
    own: &'a mut [f64],
    height: usize,
    begin: usize,
    end: usize,
}

impl Sweep for Panel<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, _: L) {
        let Self { own, height, begin, end } = self;
        for j in begin..end {
            let (before, now) = own.split_at_mut(j * height);
            let now = &mut now[j..height];
            let column = |p: usize| &before[p * height + j..(p + 1) * height];
            let pivot = |p: usize| before[p * height + p];
            let mut p = begin;
            while p + 4 <= j {
                let l: [&[f64]; 4] = std::array::from_fn(|k| &column(p + k)[..now.len()]);
                let f: [f64; 4] = std::array::from_fn(|k| l[k][0] * pivot(p + k));
                for (i, sum) in now.iter_mut().enumerate() {
                    *sum -= (f[0] * l[0][i] + f[1] * l[1][i]) + (f[2] * l[2][i] + f[3] * l[3][i]);
                }
                p += 4;
            }
            for p in p..j {
                let factor = column(p)[0] * pivot(p);
                now.iter_mut().zip(column(p)).for_each(|(sum, l)| *sum -= factor * l);
            }
            let inverse = 1.0 / now[0];
            now[1..].iter_mut().for_each(|l| *l *= inverse);
        }
    }
}

/// `update = −L₂₁ D L₂₁ᵀ`, its lower triangle.
fn leave(own: &[f64], width: usize, scratch: &mut [f64], update: &mut [f64]) {
    let height = own.len() / width;
    let below = height - width;
    if below == 0 {
        return;
    }
    let weighted = weighted_rows(own, height, 0, width..height, scratch);
    let rows = MatRef::from_column_major_slice(own, height, width).subrows(width, below);
    let tile = |first: usize, columns: &mut [f64]| {
        let count = columns.len() / below;
        let out = MatMut::from_column_major_slice_mut(columns, below, count);
        let (out, rows) = (out.subrows_mut(first, below - first), rows.subrows(first, below - first));
        matmul(out, Accum::Replace, rows, weighted.subcols(first, count), -1.0, Par::Seq);
    };
    let shared = width * below * below >= WORTH_SHARING;
    let wide = tile_width(below);
    parallel::pieces(shared, wide * below, update, &|piece, columns| tile(piece * wide, columns));
}
