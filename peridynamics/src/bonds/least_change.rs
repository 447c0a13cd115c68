//! The least change of the shares of bonds that fulfils moments at every node.
//!
//! A bond has a share u at each of its ends. With n its direction and `v_q = r n_a n_b …` (`n_a` alone without r), the rows of
//! a node are
//!
//! ```text
//! y_q = Σⱼ v_q uᵢⱼ   for even products of n         y_q = Σⱼ v_q (uᵢⱼ + uⱼᵢ)   for odd ones
//! ```
//!
//! Of all shares with `y = t` those are taken for which `Σ (u − u₀)²/w` is least, w the same at both ends. With multipliers λ
//!
//! ```text
//! uᵢⱼ = u₀ + w [Σ_even v_q λᵢ_q + Σ_odd v_q (λᵢ_q − λⱼ_q)]
//! ```
//!
//! λ solves a symmetric system as sparse as the bonds: conjugate gradients, scaled by the block of each node. Images have the
//! multipliers of their nodes, mirrored.

use nalgebra::{Cholesky, SMatrix, SVector};
use rayon::prelude::*;
use sph_core::Vec3;

use super::families::Families;

/// Residuals over the greatest row wanted: while it is looked which bonds take part, then ever finer.
const STAGES: [f64; 4] = [1e-3, 1e-6, 1e-11, 1e-13];
/// Rows that start this close to what is wanted are left alone, with the bonds of their nodes, far from faces.
const QUIET: f64 = 1e-10;
/// A residual that is good enough when rounding lets it fall no further.
const GOOD: f64 = 1e-9;
/// Most iterations of one solution.
const MOST: usize = 20_000;
/// Iterations within which a residual that is good enough halves, or it is as small as rounding lets it be.
const PATIENCE: usize = 200;
/// Growth of a residual over its least that no solution comes back from.
const LOST: f64 = 1e6;
/// Rounds of bonds that drop out.
const ROUNDS: usize = 200;
/// Part of the trace added to blocks, some of which are singular.
const LIFT: f64 = 1e-9;

/// Shares to change, and rows to fulfil.
pub(super) struct Wanted<'a, const T: usize> {
    pub families: &'a Families,
    /// Places of nodes and images \[L\].
    pub positions: &'a [Vec3],
    /// A length that makes r a number \[L\].
    pub spacing: f64,
    /// Axes of the product of each row, one to three.
    pub products: [&'static [usize]; T],
    /// t of each node, those with r over the spacing.
    pub rows: Vec<SVector<f64, T>>,
    /// Lengths of directed bonds \[L\].
    pub lengths: Vec<f64>,
    /// u of directed bonds at the start, then as found.
    pub shares: Vec<f64>,
    /// w of directed bonds, the same from both ends.
    pub mobility: Vec<f64>,
    /// Nodes whose rows may be fulfilled by chance, because what is wrong on either side cancels.
    pub near: &'a [bool],
    /// Whether the sum of the shares of a bond may not fall below zero.
    pub positive: bool,
}

impl<const T: usize> Wanted<'_, T> {
    /// Changes the shares.
    ///
    /// # Errors
    /// The residual over the greatest row wanted, where it stays too large.
    pub fn solve(&mut self) -> Result<(), f64> {
        let count = self.families.len();
        let scale = self.rows.iter().map(SVector::amax).fold(0.0, f64::max);
        let twins = self.twins();
        let zero = vec![SVector::zeros(); count];
        let lacking = self.residual(&twins, &self.shares);
        let quiet =
            (0..count).map(|node| !self.near[node] && lacking[node].amax() <= QUIET * scale).collect();
        let mut system = System { wanted: self, mobility: self.mobility.clone(), quiet, scale };
        for node in 0..count {
            for bond in self.families.of(node) {
                let other = self.families.source(self.families.others[bond] as usize);
                if system.quiet[node] || system.quiet[other] {
                    system.mobility[bond] = 0.0;
                }
            }
        }
        let mut start = self.shares.clone();
        let (mut lambda, mut stage) = (zero, 0);
        for _ in 0..ROUNDS {
            let right = self.residual(&twins, &start);
            let left = system.solve(&right, &mut lambda, STAGES[stage] * scale);
            let changed = system.changed(&start, &lambda);
            let beyond: Vec<usize> = (0..changed.len())
                .filter(|&bond| {
                    let sum = changed[bond] + changed[twins[bond]];
                    self.positive && system.mobility[bond] > 0.0 && sum < 0.0
                })
                .collect();
            if beyond.is_empty() {
                stage += 1;
                if stage == STAGES.len() {
                    self.shares = changed;
                    return if left <= GOOD { Ok(()) } else { Err(left) };
                }
            }
            for bond in beyond {
                (start[bond], system.mobility[bond]) = (0.0, 0.0);
            }
        }
        Err(f64::INFINITY)
    }

    /// The bond seen from its other end, of each bond.
    fn twins(&self) -> Vec<usize> {
        let mut twins = self.families.twins();
        (0..self.families.others.len()).map(|bond| twins.next(bond)).collect()
    }

    /// v of a bond.
    #[inline(always)]
    fn values(&self, node: usize, bond: usize) -> SVector<f64, T> {
        let r = self.lengths[bond];
        let n = (self.positions[self.families.others[bond] as usize] - self.positions[node]) / r;
        SVector::from_fn(|q, _| {
            let product: f64 = self.products[q].iter().map(|&a| n[a]).product();
            if self.products[q].len() == 1 { product } else { product * (r / self.spacing) }
        })
    }

    #[inline(always)]
    fn is_odd(&self, q: usize) -> bool {
        self.products[q].len() % 2 == 1
    }

    /// What is missing of each row.
    fn residual(&self, twins: &[usize], shares: &[f64]) -> Vec<SVector<f64, T>> {
        let of = |node: usize| {
            let mut row = self.rows[node];
            for bond in self.families.of(node) {
                let (own, both) = (shares[bond], shares[bond] + shares[twins[bond]]);
                let v = self.values(node, bond);
                for q in 0..T {
                    row[q] -= v[q] * if self.is_odd(q) { both } else { own };
                }
            }
            row
        };
        (0..self.families.len()).into_par_iter().map(of).collect()
    }

    /// Multipliers of nodes, with those of images behind.
    fn extended(&self, lambda: &[SVector<f64, T>]) -> Vec<SVector<f64, T>> {
        let mut out = lambda.to_vec();
        let Some(images) = &self.families.images else { return out };
        for number in lambda.len()..lambda.len() + images.len() {
            let (source, signs) = (images.source(number), images.signs(number));
            let sign = |q: usize| self.products[q].iter().map(|&a| signs[a]).product::<f64>();
            out.push(SVector::from_fn(|q, _| sign(q) * lambda[source][q]));
        }
        out
    }
}

/// The system of the multipliers.
struct System<'a, const T: usize> {
    wanted: &'a Wanted<'a, T>,
    /// w, zero for bonds that do not change.
    mobility: Vec<f64>,
    /// Nodes whose rows need nothing.
    quiet: Vec<bool>,
    scale: f64,
}

impl<const T: usize> System<'_, T> {
    /// What the multipliers make of both shares of a bond, over w: with its values, at this end and at the other.
    #[inline(always)]
    fn change(&self, v: &SVector<f64, T>, here: &SVector<f64, T>, there: &SVector<f64, T>) -> [f64; 2] {
        let (mut odd, mut even) = (0.0, [0.0; 2]);
        for q in 0..T {
            if self.wanted.is_odd(q) {
                odd += v[q] * (here[q] - there[q]);
            } else {
                even[0] += v[q] * here[q];
                even[1] += v[q] * there[q];
            }
        }
        even.map(|even| odd + even)
    }

    /// The matrix times multipliers.
    fn product(&self, lambda: &[SVector<f64, T>]) -> Vec<SVector<f64, T>> {
        let (wanted, long) = (self.wanted, self.wanted.extended(lambda));
        let of = |node: usize| {
            let mut row = SVector::<f64, T>::zeros();
            if self.quiet[node] {
                return row;
            }
            for bond in wanted.families.of(node).filter(|&bond| self.mobility[bond] > 0.0) {
                let v = wanted.values(node, bond);
                let other = wanted.families.others[bond] as usize;
                let [own, twin] =
                    self.change(&v, &long[node], &long[other]).map(|change| change * self.mobility[bond]);
                for q in 0..T {
                    row[q] += v[q] * if wanted.is_odd(q) { own + twin } else { own };
                }
            }
            row
        };
        (0..lambda.len()).into_par_iter().map(of).collect()
    }

    /// The inverse of the block of each node.
    fn blocks(&self) -> Vec<SMatrix<f64, T, T>> {
        let wanted = self.wanted;
        let of = |node: usize| {
            let mut block = SMatrix::<f64, T, T>::zeros();
            for bond in wanted.families.of(node).filter(|&bond| self.mobility[bond] > 0.0) {
                let v = wanted.values(node, bond);
                block += v * (v * self.mobility[bond]).transpose();
            }
            for p in 0..T {
                for q in 0..T {
                    if wanted.is_odd(p) && wanted.is_odd(q) {
                        block[(p, q)] *= 2.0;
                    }
                }
            }
            let lift = LIFT * block.trace();
            (0..T).for_each(|q| block[(q, q)] += lift);
            Cholesky::new(block).map_or_else(SMatrix::zeros, |factor| factor.inverse())
        };
        (0..wanted.families.len()).into_par_iter().map(of).collect()
    }

    /// Conjugate gradients from multipliers that are there; returns the greatest residual over the scale.
    fn solve(&self, right: &[SVector<f64, T>], lambda: &mut [SVector<f64, T>], tolerance: f64) -> f64 {
        let (blocks, count) = (self.blocks(), lambda.len());
        let share: Vec<f64> = (0..count).map(|node| self.wanted.families.share(node)).collect();
        let dot = |a: &[SVector<f64, T>], b: &[SVector<f64, T>]| -> f64 {
            (0..count).map(|node| share[node] * a[node].dot(&b[node])).sum()
        };
        let scaled = |r: &[SVector<f64, T>]| -> Vec<SVector<f64, T>> {
            blocks.iter().zip(r).map(|(block, r)| block * r).collect()
        };
        let greatest = |r: &[SVector<f64, T>]| r.iter().map(SVector::amax).fold(0.0, f64::max);
        let mut r: Vec<_> =
            right.iter().zip(self.product(lambda)).map(|(right, left)| right - left).collect();
        for (r, quiet) in r.iter_mut().zip(&self.quiet) {
            if *quiet {
                *r = SVector::zeros();
            }
        }
        let mut z = scaled(&r);
        let (mut p, mut rz) = (z.clone(), dot(&r, &z));
        // The system is singular: rounding grows once nothing else is left, so that the best that was met is kept.
        let (mut best, mut least, mut since) = (lambda.to_vec(), greatest(&r), 0);
        for _ in 0..MOST {
            let left = greatest(&r);
            if left <= 0.5 * least {
                best.copy_from_slice(lambda);
                (least, since) = (left, 0);
            }
            since += 1;
            let tired = since > PATIENCE && least <= GOOD * self.scale;
            if left <= tolerance || tired || !(rz > 0.0 && left < LOST * least) {
                break;
            }
            let along = self.product(&p);
            let step = rz / dot(&p, &along);
            for node in 0..count {
                lambda[node] += p[node] * step;
                r[node] -= along[node] * step;
            }
            z = scaled(&r);
            let next = dot(&r, &z);
            let keep = next / rz;
            for (p, z) in p.iter_mut().zip(&z) {
                *p = z + *p * keep;
            }
            rz = next;
        }
        let left = greatest(&r);
        if left.is_nan() || left > least {
            lambda.copy_from_slice(&best);
        }
        least.min(left) / self.scale
    }

    /// The shares as the multipliers change them.
    fn changed(&self, start: &[f64], lambda: &[SVector<f64, T>]) -> Vec<f64> {
        let (wanted, long) = (self.wanted, self.wanted.extended(lambda));
        let mut out = start.to_vec();
        for node in 0..lambda.len() {
            for bond in wanted.families.of(node).filter(|&bond| self.mobility[bond] > 0.0) {
                let v = wanted.values(node, bond);
                let other = wanted.families.others[bond] as usize;
                out[bond] += self.mobility[bond] * self.change(&v, &long[node], &long[other])[0];
            }
        }
        out
    }
}
