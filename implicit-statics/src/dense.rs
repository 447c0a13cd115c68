//! The small dense symmetric eigenproblem.

use faer::{Mat, Side};

/// Eigenvalues in rising order and unit eigenvectors (one after the other) of a small dense symmetric matrix,
/// given by its lower triangle in column-major order.
pub fn dense_eigen(size: usize, matrix: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let eigen = Mat::from_fn(size, size, |i, j| matrix[i + j * size])
        .self_adjoint_eigen(Side::Lower)
        .expect("a finite symmetric matrix has its eigenpairs");
    let values = (0..size).map(|i| eigen.S()[i]).collect();
    let vectors = (0..size * size).map(|k| eigen.U()[(k % size, k / size)]).collect();
    (values, vectors)
}
