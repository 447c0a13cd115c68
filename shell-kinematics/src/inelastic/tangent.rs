//! The tangent of a section that yields: the tangents of its points, summed with one, height and its square.

use super::section::PlasticSection;
use crate::pack::Pack;
use crate::strains::Strains;
use crate::tangent::{Matrix8, ZERO8};

/// A 3×3 matrix of packs.
type Matrix3 = [[Pack; 3]; 3];

/// `Σ a_ik b_kj`.
fn product(a: &Matrix3, b: &Matrix3) -> Matrix3 {
    std::array::from_fn(|i| {
        std::array::from_fn(|j| (0..3).fold(Pack::ZERO, |sum, k| sum + a[i][k] * b[k][j]))
    })
}

fn transposed(a: &Matrix3) -> Matrix3 {
    std::array::from_fn(|i| std::array::from_fn(|j| a[j][i]))
}

impl PlasticSection {
    /// `[[Σ w D, Σ w z D F], [Fᵀ Σ w z D, Fᵀ Σ w z² D F]]` with D the tangent of a point, and shear.
    pub(super) fn tangent_in(&self, strains: &Strains, read: impl Fn(usize) -> Pack) -> Matrix8 {
        let lever = self.lever(&read);
        let mut sums = [[[Pack::ZERO; 3]; 3]; 3];
        for layer in &self.layers {
            let across = layer.across(strains, &lever);
            let mut own = [[Pack::ZERO; 6]; 3];
            for (slice, place) in layer.points() {
                let tangent = match &layer.law {
                    Some(law) => {
                        let committed = layer.committed(law, &read, place);
                        law.tangent(
                            &law.step(&across.at(slice), &committed, layer.pace(law, &read, place)),
                            &committed,
                        )
                    }
                    None => [1.0, 1.0, 1.0, 0.0, 0.0, 0.0].map(Pack::splat),
                };
                let (w, z) = (slice.weight, slice.height);
                for (sum, factor) in own.iter_mut().zip([w, w * z, w * z * z]) {
                    sum.iter_mut().zip(tangent).for_each(|(sum, value)| *sum += value * factor);
                }
            }
            let basis = layer.modes.basis.map(|row| row.map(Pack::splat));
            for (sum, [a, b, c, d, e, f]) in sums.iter_mut().zip(own) {
                let turned =
                    product(&product(&basis, &[[a, d, e], [d, b, f], [e, f, c]]), &transposed(&basis));
                for i in 0..3 {
                    for j in 0..3 {
                        // The half of it twice: symmetric to the last bit.
                        sum[i][j] += turned[i.min(j)][i.max(j)];
                    }
                }
            }
        }
        let unit = |i: usize| std::array::from_fn(|j| Pack::splat(if i == j { 1.0 } else { 0.0 }));
        let lifted = transposed(&std::array::from_fn(|i| lever.strains(&unit(i)))); // F
        let [membrane, coupling, bending] = sums;
        let coupling = product(&coupling, &lifted);
        let bending = product(&transposed(&lifted), &product(&bending, &lifted));
        let mut out = ZERO8;
        for i in 0..3 {
            for j in 0..3 {
                out[i][j] = membrane[i][j];
                out[i][3 + j] = coupling[i][j];
                out[3 + j][i] = coupling[i][j];
                out[3 + i][3 + j] = bending[i.min(j)][i.max(j)];
            }
        }
        for i in 0..2 {
            for j in 0..2 {
                out[6 + i][6 + j] = Pack::splat(self.shear[i][j]);
            }
        }
        out
    }
}
