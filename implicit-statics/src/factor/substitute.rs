//! Substitution with a factor, for one right side or for several that read it once: `x = L⁻ᵀ D⁻¹ L⁻¹ b` along the tree.

use lanes::{Lanes, Sweep, widest};

use super::Factor;
use super::tree::{Tree, Work};
use super::walk::{downward, upward};

/// Partial sums of a scalar product, one for each place modulo their number.
const SUMS: usize = 8;
/// Columns at a time.
const FOUR: usize = 4;

impl Factor {
    /// Solves with the factor in place, for each of some right sides the same bits as alone.
    pub fn substitute<const R: usize>(&self, rights: [&mut [f64]; R]) {
        let (tree, sizes) = (&self.tree, &self.sizes);
        let order = |place: usize| self.order.as_ref().map_or(place, |order| order[place]);
        let mut x: Vec<[f64; R]> = Vec::with_capacity(tree.columns());
        x.extend((0..tree.columns()).map(|place| std::array::from_fn(|r| rights[r][order(place)])));
        let mut room = vec![[0.0; R]; sizes.of_all(Work::Forward).max(sizes.of_all(Work::Back))];
        upward(
            (tree, sizes),
            Work::Forward,
            0..tree.count(),
            &mut x,
            &mut room,
            &|s, own, left, update, scratch| {
                let width = tree.width(s);
                let front = &mut scratch[..tree.height(s)];
                front[..width].copy_from_slice(own);
                front[width..].fill([0.0; R]);
                take_left(tree, s, left, front);
                self.exchange(s, front, own);
                widest(Forward { columns: self.columns(s), width, front });
                own.copy_from_slice(&front[..width]);
                update.copy_from_slice(&front[width..]);
            },
        );
        downward((tree, sizes), 0..tree.count(), &mut x, &[], &mut room, &|s, own, above, front| {
            let width = tree.width(s);
            front[..width].copy_from_slice(own);
            self.divide(s, &mut front[..width]);
            for run in tree.runs(s) {
                front[width + run.from..][..run.rows].copy_from_slice(&above[run.to..][..run.rows]);
            }
            widest(Back { columns: self.columns(s), width, front });
            self.exchange_back(s, front, own);
        });
        for (r, right) in rights.into_iter().enumerate() {
            x.iter().enumerate().for_each(|(place, x)| right[order(place)] = x[r]);
        }
    }

    fn columns(&self, s: usize) -> &[f64] {
        self.tree.supernode(&self.values, s).values
    }

    /// Puts the first numbers of a front in the order of pivots; `spare` is as many numbers.
    fn exchange<const R: usize>(&self, s: usize, front: &mut [[f64; R]], spare: &mut [[f64; R]]) {
        if self.exchanged {
            let begin = self.tree.begin(s);
            spare.copy_from_slice(&front[..spare.len()]);
            let places = &self.forward[begin..begin + spare.len()];
            front.iter_mut().zip(places).for_each(|(x, &place)| *x = spare[place - begin]);
        }
    }

    /// Puts them back, in the front and as the supernode's own.
    fn exchange_back<const R: usize>(&self, s: usize, front: &mut [[f64; R]], own: &mut [[f64; R]]) {
        if self.exchanged {
            let begin = self.tree.begin(s);
            let places = &self.forward[begin..begin + own.len()];
            front.iter().zip(places).for_each(|(x, &place)| own[place - begin] = *x);
            front[..own.len()].copy_from_slice(own);
        } else {
            own.copy_from_slice(&front[..own.len()]);
        }
    }

    /// Divides by the pivots of a supernode.
    fn divide<const R: usize>(&self, s: usize, x: &mut [[f64; R]]) {
        let (begin, width) = (self.tree.begin(s), x.len());
        let height = self.tree.height(s);
        let values = self.columns(s);
        let pivot = |j: usize| values[j * height + j];
        let mut j = 0;
        while j < width {
            let coupling = self.subdiagonal[begin + j];
            if coupling == 0.0 {
                x[j].iter_mut().for_each(|x| *x /= pivot(j));
                j += 1;
                continue;
            }
            // in units of the coupling, which is the largest entry of its block
            let (a, b) = (pivot(j) / coupling, pivot(j + 1) / coupling);
            let determinant = a * b - 1.0;
            for r in 0..R {
                let (first, second) = (x[j][r] / coupling, x[j + 1][r] / coupling);
                x[j][r] = (b * first - second) / determinant;
                x[j + 1][r] = (a * second - first) / determinant;
            }
            j += 2;
        }
    }
}

/// Adds what the children of a supernode left to its front.
fn take_left<const R: usize>(tree: &Tree, s: usize, mut left: &[[f64; R]], front: &mut [[f64; R]]) {
    for &child in tree.children(s) {
        let child = child as usize;
        let (own, rest) = left.split_at(tree.rows(child).len());
        for run in tree.runs(child) {
            let parts = &own[run.from..run.from + run.rows];
            for (sum, part) in front[run.to..].iter_mut().zip(parts) {
                (0..R).for_each(|r| sum[r] += part[r]);
            }
        }
        left = rest;
    }
}

/// Eliminates the first numbers of a front from all below them, four columns at a time.
struct Forward<'a, const R: usize> {
    columns: &'a [f64],
    width: usize,
    front: &'a mut [[f64; R]],
}

impl<const R: usize> Sweep for Forward<'_, R> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, _: L) {
        let Self { columns, width, front } = self;
        let height = front.len();
        let mut j = 0;
        while j + FOUR <= width {
            let l: [&[f64]; FOUR] =
                std::array::from_fn(|k| &columns[(j + k) * height + j..(j + k + 1) * height]);
            let (block, rest) = front[j..].split_at_mut(FOUR);
            for k in 0..FOUR {
                for i in k + 1..FOUR {
                    (0..R).for_each(|r| block[i][r] -= l[k][i] * block[k][r]);
                }
            }
            let l: [&[f64]; FOUR] = l.map(|column| &column[FOUR..][..rest.len()]);
            for (i, sum) in rest.iter_mut().enumerate() {
                for r in 0..R {
                    sum[r] -= (l[0][i] * block[0][r] + l[1][i] * block[1][r])
                        + (l[2][i] * block[2][r] + l[3][i] * block[3][r]);
                }
            }
            j += FOUR;
        }
        for j in j..width {
            let (own, rest) = front[j..].split_at_mut(1);
            let l = &columns[j * height + j + 1..(j + 1) * height];
            for (sum, l) in rest.iter_mut().zip(l) {
                (0..R).for_each(|r| sum[r] -= l * own[0][r]);
            }
        }
    }
}

/// Takes what is below them off the first numbers of a front, the last first.
struct Back<'a, const R: usize> {
    columns: &'a [f64],
    width: usize,
    front: &'a mut [[f64; R]],
}

impl<const R: usize> Sweep for Back<'_, R> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, _: L) {
        let Self { columns, width, front } = self;
        let height = front.len();
        let fours = width / FOUR * FOUR;
        for j in (fours..width).rev() {
            let (own, rest) = front[j..].split_at_mut(1);
            let l = &columns[j * height + j + 1..(j + 1) * height];
            let [sum] = products([l], rest);
            (0..R).for_each(|r| own[0][r] -= sum[r]);
        }
        for j in (0..fours).step_by(FOUR).rev() {
            let (block, rest) = front[j..].split_at_mut(FOUR);
            let l: [&[f64]; FOUR] =
                std::array::from_fn(|k| &columns[(j + k) * height + j..(j + k + 1) * height]);
            let sums = products(l.map(|column| &column[FOUR..]), rest);
            for k in (0..FOUR).rev() {
                (0..R).for_each(|r| block[k][r] -= sums[k][r]);
                for i in k + 1..FOUR {
                    (0..R).for_each(|r| block[k][r] -= l[k][i] * block[i][r]);
                }
            }
        }
    }
}

/// Scalar products of some columns with some vectors.
#[inline(always)]
fn products<const K: usize, const R: usize>(columns: [&[f64]; K], x: &[[f64; R]]) -> [[f64; R]; K] {
    let mut out = [[0.0; R]; K];
    if R == 1 {
        partial(columns, x, &mut out);
    } else {
        // Partial sums of one column are as many as registers hold.
        for k in 0..K {
            partial([columns[k]], x, &mut out[k..][..1]);
        }
    }
    out
}

/// The same, in partial sums. Loops, since closures would not be compiled for the lanes.
#[inline(always)]
fn partial<const K: usize, const R: usize>(columns: [&[f64]; K], x: &[[f64; R]], out: &mut [[f64; R]]) {
    let (blocks, rest) = x.as_chunks::<SUMS>();
    let mut sums = [[[0.0; R]; SUMS]; K];
    let l = columns.map(|column| column[..x.len()].as_chunks::<SUMS>());
    for (b, x) in blocks.iter().enumerate() {
        for k in 0..K {
            let l = &l[k].0[b];
            for m in 0..SUMS {
                for r in 0..R {
                    sums[k][m][r] += l[m] * x[m][r];
                }
            }
        }
    }
    for k in 0..K {
        let s = &sums[k];
        for r in 0..R {
            let mut sum =
                ((s[0][r] + s[4][r]) + (s[1][r] + s[5][r])) + ((s[2][r] + s[6][r]) + (s[3][r] + s[7][r]));
            for (x, l) in rest.iter().zip(l[k].1) {
                sum += l * x[r];
            }
            out[k][r] = sum;
        }
    }
}
