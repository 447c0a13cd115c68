//! Second derivatives of a network's energy.
//!
//! With the pull T of a bond, its present length Y and direction M, its stiffness k, and the gradient `gᵢ = Σⱼ Dᵢⱼ ∂eᵢⱼ` of the
//! dilatation of node i over all positions,
//!
//! ```text
//! K = Σ_bonds ∂e [k M Mᵀ + (T/Y)(I − M Mᵀ)] ∂eᵀ + Σᵢ (λ − μ) Vᵢ gᵢ gᵢᵀ
//! ```
//!
//! The second sum joins all pairs of a family, so that nodes up to two horizons apart share a block. Without a dilatation
//! that counts (PMB, or λ = μ) only nodes with a bond do. Each row of blocks is gathered by its own node: any number of
//! threads gives the same bits.

use implicit_statics::BlockPattern;
use rayon::prelude::*;
use sph_core::Vec3;

use super::couplings::{Coupling, add_outer, transposed_product};
use super::linearised::{Linearised, LinearisedBond};
use super::network::Network;
use crate::unknowns::Unknowns;

impl Network {
    /// Pairs of nodes that share a block of second derivatives, by all bonds, whole or broken.
    pub fn couplings(&self) -> BlockPattern {
        let families: Vec<Vec<u32>> = (0..self.len()).map(|node| self.neighbours(node).collect()).collect();
        let wide = self.dilatation_factors().is_some();
        BlockPattern::new(self.len(), |a, row| {
            row.extend(&families[a]);
            if wide {
                for &i in &families[a] {
                    row.extend(&families[i as usize]);
                }
            }
            row.retain(|&b| b as usize <= a);
        })
    }
}

impl Linearised<'_> {
    /// Second derivatives of the stored energy, one block a pair of the pattern of [`Network::couplings`].
    pub fn second_derivatives(&self, pattern: &BlockPattern, blocks: &mut [Coupling], threads: usize) {
        let mut rows = Vec::with_capacity(self.len());
        let mut left = blocks;
        for a in 0..self.len() {
            let (row, rest) = left.split_at_mut(pattern.of(a).len());
            rows.push(row);
            left = rest;
        }
        let gradients = self.own_gradients();
        let gather = |places: &mut Vec<u32>, (a, row): (usize, &mut [Coupling])| {
            for (place, &b) in pattern.columns(a).iter().enumerate() {
                places[b as usize] = place as u32;
            }
            self.row(a, &gradients, places, row);
        };
        let places = || vec![0_u32; self.len()];
        if threads > 1 {
            rows.into_par_iter().enumerate().for_each_init(places, gather);
        } else {
            let mut places = places();
            rows.into_iter().enumerate().for_each(|row| gather(&mut places, row));
        }
    }

    /// `∂θᵢ/∂xᵢ` of all nodes; nothing without a dilatation that counts.
    fn own_gradients(&self) -> Vec<Vec3> {
        let count = if self.factors.is_some() { self.len() } else { 0 };
        (0..count).map(|node| self.own_gradient(node)).collect()
    }

    /// The blocks of node a with those not after it; `places` holds the place of each in the row.
    fn row(&self, a: usize, gradients: &[Vec3], places: &[u32], row: &mut [Coupling]) {
        row.fill([[0.0; 3]; 3]);
        let own = row.len() - 1;
        for bond in self.of(a) {
            let (block, (other, signs)) = (bond_block(bond), self.end(bond));
            for i in 0..3 {
                for j in 0..3 {
                    row[own][i][j] += block[i][j];
                    if other <= a {
                        row[places[other] as usize][i][j] -= block[i][j] * signs[j];
                    }
                }
            }
        }
        let Some(factors) = self.factors else { return };
        let mut add = |i: usize, of_a: Vec3| {
            let scaled = of_a * factors[i];
            // Without images the others ascend.
            let after = |bond: &LinearisedBond| self.images.is_none() && bond.other as usize > a;
            for bond in self.of(i).iter().take_while(|bond| !after(bond)) {
                let (other, signs) = self.end(bond);
                if other <= a {
                    add_outer(
                        &mut row[places[other] as usize],
                        bond.own,
                        &scaled,
                        &signed(bond.direction, signs),
                    );
                }
            }
            if i <= a {
                add_outer(&mut row[places[i] as usize], 1.0, &scaled, &gradients[i]);
            }
        };
        add(a, gradients[a]);
        for bond in self.of(a) {
            // Seen from the other end a bond has the opposite direction.
            add(self.end(bond).0, -bond.direction * bond.twin);
        }
    }

    /// `Σ |K_ij|` over the unknowns of a body whose rows are the nodes alone: exact without a dilatation, else an upper bound,
    ///
    /// ```text
    /// Σ_b |n·K_ab m| ≤ |n·K_aa m| + Σ_bonds |n·k_ab m| + Σᵢ (λ − μ)Vᵢ |n·g_ia| (sᵢ − |g_ia|₁)        sᵢ = Σ_b |g_ib|₁
    /// ```
    ///
    /// with n, m the directions of the unknowns and |·|₁ the sum of components along those of its node. It needs one pass
    /// over the bonds, no matrix.
    pub fn row_sums(&self, unknowns: &Unknowns, out: &mut [f64]) {
        let gradients = self.own_gradients();
        let along = |node: usize, v: &Vec3| -> f64 {
            unknowns.directions_of(node).iter().map(|m| m.dot(v).abs()).sum()
        };
        let along_other = |bond: &LinearisedBond, v: Vec3| {
            let (other, signs) = self.end(bond);
            along(other, &signed(v, signs))
        };
        let spread: Vec<f64> = (0..gradients.len())
            .map(|i| {
                let far = |bond: &LinearisedBond| along_other(bond, bond.direction) * bond.own.abs();
                along(i, &gradients[i]) + self.of(i).iter().map(far).sum::<f64>()
            })
            .collect();
        for a in 0..self.len() {
            let mut own = [[0.0; 3]; 3];
            let sums = &mut out[unknowns.of(a)];
            sums.fill(0.0);
            let join = |i: usize, of_a: &Vec3, own: &mut Coupling, sums: &mut [f64]| {
                let Some(factors) = self.factors else { return };
                add_outer(own, factors[i], of_a, of_a);
                let rest = (spread[i] - along(a, of_a)).max(0.0) * factors[i].abs();
                for (sum, n) in sums.iter_mut().zip(unknowns.directions_of(a)) {
                    *sum += n.dot(of_a).abs() * rest;
                }
            };
            if self.factors.is_some() {
                join(a, &gradients[a], &mut own, sums);
            }
            for bond in self.of(a) {
                let block = bond_block(bond);
                for (sum, n) in sums.iter_mut().zip(unknowns.directions_of(a)) {
                    *sum += along_other(bond, transposed_product(&block, n));
                }
                for i in 0..3 {
                    (0..3).for_each(|j| own[i][j] += block[i][j]);
                }
                join(self.end(bond).0, &(-bond.direction * bond.twin), &mut own, sums);
            }
            for (sum, n) in sums.iter_mut().zip(unknowns.directions_of(a)) {
                *sum += along(a, &transposed_product(&own, n));
            }
        }
    }
}

/// A vector with the signs that an image gives its components.
#[inline(always)]
fn signed(v: Vec3, signs: [f64; 3]) -> Vec3 {
    Vec3::new(v.x * signs[0], v.y * signs[1], v.z * signs[2])
}

/// `k M Mᵀ + (T/Y)(I − M Mᵀ)` of a bond.
#[inline(always)]
fn bond_block(bond: &LinearisedBond) -> Coupling {
    let mut block = [[0.0; 3]; 3];
    add_outer(&mut block, bond.stiffness - bond.across, &bond.direction, &bond.direction);
    (0..3).for_each(|k| block[k][k] += bond.across);
    block
}
