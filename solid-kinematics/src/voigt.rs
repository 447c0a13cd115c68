//! Symmetric tensors as six numbers: `11, 22, 33, 12, 23, 13`, strains with engineering shears.

use nalgebra::Matrix3;

use crate::Tensor;

/// Rows and columns of the six components.
pub const PAIRS: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2)];

/// Place of a component in the six.
pub const PLACES: [[usize; 3]; 3] = [[0, 3, 5], [3, 1, 4], [5, 4, 2]];

/// The symmetric part of a tensor as strains, shears twice.
pub fn strains(e: &Tensor) -> [f64; 6] {
    [e[(0, 0)], e[(1, 1)], e[(2, 2)], e[(0, 1)] + e[(1, 0)], e[(1, 2)] + e[(2, 1)], e[(0, 2)] + e[(2, 0)]]
}

/// The tensor of six stresses.
pub fn stress_tensor(s: &[f64; 6]) -> Tensor {
    Matrix3::new(s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2])
}
