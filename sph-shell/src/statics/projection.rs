//! From blocks between particles to entries between unknowns, rows on threads: every entry is one product, the same for any number.

use implicit_statics::BlockPattern;
use std::ops::Range;

use crate::conditions::body::Block;
use crate::statics::dofs::{Basis, DofMap};

/// Entries below which a thread's share is not divided.
const SHARE: usize = 4096;

/// Blocks, and the directions of the unknowns that they are taken along.
pub(crate) struct Projection<'a, R> {
    pub bases: &'a [Basis],
    pub pattern: &'a BlockPattern,
    /// As [`entries`] counts them.
    pub entries: &'a [usize],
    pub blocks: &'a [Block],
    /// What the turns of a particle lose on the diagonal.
    pub radial: R,
}

/// First entry of the rows of each particle in the pattern of the unknowns, and the end.
pub(crate) fn entries(dofs: &DofMap, pattern: &BlockPattern) -> Vec<usize> {
    let mut out = vec![0];
    for a in 0..pattern.rows() {
        let own = dofs.of(a).len();
        let others = pattern.columns(a).iter().map(|&b| b as usize).filter(|&b| b != a);
        let others: usize = others.map(|b| dofs.of(b).len()).sum();
        out.push(out[a] + own * others + own * (own + 1) / 2);
    }
    out
}

impl<R: Fn(usize) -> f64 + Sync> Projection<'_, R> {
    /// Entries of the rows of some particles, halves of them on two threads.
    pub fn run(&self, particles: Range<usize>, values: &mut [f64], threads: usize) {
        if threads > 1 && values.len() >= 2 * SHARE {
            let first = self.entries[particles.start];
            let half = first + values.len() / 2;
            let own = &self.entries[particles.start..=particles.end];
            let cut = particles.start + own.partition_point(|&entry| entry < half);
            let (left, right) = values.split_at_mut(self.entries[cut] - first);
            rayon::join(
                || self.run(particles.start..cut, left, threads / 2),
                || self.run(cut..particles.end, right, threads / 2),
            );
            return;
        }
        let mut next = values.iter_mut();
        for a in particles {
            self.rows(a, |value| {
                if let Some(slot) = next.next() {
                    *slot = value;
                }
            });
        }
    }

    /// Visits the entries of a particle's rows.
    #[inline]
    fn rows(&self, a: usize, mut visit: impl FnMut(f64)) {
        let own = &self.bases[a];
        for (&b, block) in self.pattern.columns(a).iter().zip(&self.blocks[self.pattern.of(a)]) {
            let b = b as usize;
            let other = &self.bases[b];
            let along = if a == b { (self.radial)(a) } else { 0.0 };
            for row in 0..own.count {
                let left = if row < own.translations { 0 } else { 3 };
                let d = &own.directions[row];
                let product: [f64; 6] = std::array::from_fn(|j| {
                    d.x * block[left][j] + d.y * block[left + 1][j] + d.z * block[left + 2][j]
                });
                for column in 0..if a == b { row + 1 } else { other.count } {
                    let top = if column < other.translations { 0 } else { 3 };
                    let e = &other.directions[column];
                    let mut value = product[top] * e.x + product[top + 1] * e.y + product[top + 2] * e.z;
                    if a == b && row == column && left == 3 {
                        value -= along;
                    }
                    visit(value * own.rates[row] * other.rates[column]);
                }
            }
        }
    }
}
