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
use lanes::{LANES, Lanes, Sweep, widest};

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
        let height = width + below;
        widest(Take { tree, s, left, columns: 0..width, to: own });
        factor_columns(own, height, 0..width, scratch);
        leave(own, width, scratch, update);
        widest(Take { tree, s, left, columns: width..height, to: update });
        debug_assert_eq!(update.len(), below * below);
    });
}

/// Adds what the children of a supernode left to some columns of its front, which are as high as their number and what is below them.
/// Loops, since closures would not be compiled for the lanes.
struct Take<'a> {
    tree: &'a Tree,
    s: usize,
    left: &'a [f64],
    columns: Range<usize>,
    to: &'a mut [f64],
}

impl Sweep for Take<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, _: L) {
        let Self { tree, s, mut left, columns, to } = self;
        let first = columns.start;
        let height = if columns.is_empty() { 0 } else { to.len() / columns.len() };
        for &child in tree.children(s) {
            let child = child as usize;
            let rows = tree.rows(child).len();
            let (own, rest) = left.split_at(rows * rows);
            let runs = tree.runs(child);
            for (r, run) in runs.iter().enumerate() {
                for k in 0..run.rows {
                    if !columns.contains(&(run.to + k)) {
                        continue;
                    }
                    let column = &own[(run.from + k) * rows..(run.from + k + 1) * rows];
                    let sums = &mut to[(run.to + k - first) * height..(run.to + k + 1 - first) * height];
                    // From the diagonal on.
                    add(&column[run.from + k..run.from + run.rows], &mut sums[run.to + k - first..]);
                    for run in &runs[r + 1..] {
                        add(&column[run.from..run.from + run.rows], &mut sums[run.to - first..]);
                    }
                }
            }
            left = rest;
        }
    }
}

/// Adds some numbers to the first of others.
#[inline(always)]
fn add(parts: &[f64], sums: &mut [f64]) {
    for (sum, part) in sums.iter_mut().zip(parts) {
        *sum += part;
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
    widest(Weighted { done, height, first, rows, weighted: &mut *weighted });
    MatRef::from_column_major_slice(weighted, width, count)
}

/// Transposes and weights, four columns at a time.
struct Weighted<'a> {
    done: &'a [f64],
    height: usize,
    first: usize,
    rows: Range<usize>,
    weighted: &'a mut [f64],
}

impl Sweep for Weighted<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) {
        let Self { done, height, first, rows, weighted } = self;
        let width = done.len() / height;
        let fours = width / LANES * LANES;
        for p in (0..fours).step_by(LANES) {
            let column = |k: usize| &done[(p + k) * height..(p + k + 1) * height];
            let l: [&[f64]; LANES] = std::array::from_fn(column);
            let mut pivots = [lanes.splat(0.0); LANES];
            for k in 0..LANES {
                pivots[k] = lanes.splat(l[k][first + p + k]);
            }
            let l = l.map(|column| column[rows.clone()].as_chunks::<LANES>());
            for b in 0..l[0].0.len() {
                let mut out = [lanes.splat(0.0); LANES];
                for k in 0..LANES {
                    out[k] = lanes.mul(pivots[k], lanes.load(&l[k].0[b]));
                }
                for (i, row) in lanes.rows(out).into_iter().enumerate() {
                    weighted[(b * LANES + i) * width + p..][..LANES].copy_from_slice(&row);
                }
            }
            for i in 0..l[0].1.len() {
                for k in 0..LANES {
                    weighted[(rows.len() / LANES * LANES + i) * width + p + k] =
                        done[(p + k) * height + first + p + k] * l[k].1[i];
                }
            }
        }
        for p in fours..width {
            let column = &done[p * height..(p + 1) * height];
            let pivot = column[first + p];
            for (k, l) in column[rows.clone()].iter().enumerate() {
                weighted[k * width + p] = pivot * l;
            }
        }
    }
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
                for (sum, l) in now.iter_mut().zip(column(p)) {
                    *sum -= factor * l;
                }
            }
            let inverse = 1.0 / now[0];
            for l in &mut now[1..] {
                *l *= inverse;
            }
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
