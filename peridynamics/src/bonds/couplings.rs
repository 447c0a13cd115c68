//! Blocks of second derivatives, of the pairs of rows that share one.

use sph_core::Vec3;

/// Second derivatives `∂²U/∂row∂row` of one pair of rows \[F/L\].
pub(crate) type Coupling = [[f64; 3]; 3];

/// Adds `factor a bᵀ`.
#[inline(always)]
pub(crate) fn add_outer(block: &mut Coupling, factor: f64, a: &Vec3, b: &Vec3) {
    for i in 0..3 {
        for j in 0..3 {
            block[i][j] += factor * a[i] * b[j];
        }
    }
}

/// `block · v`.
pub(crate) fn product(block: &Coupling, v: &Vec3) -> Vec3 {
    Vec3::from_fn(|i, _| (0..3).map(|j| block[i][j] * v[j]).sum())
}

/// `blockᵀ · v`.
pub(crate) fn transposed_product(block: &Coupling, v: &Vec3) -> Vec3 {
    Vec3::from_fn(|i, _| (0..3).map(|j| block[j][i] * v[j]).sum())
}
