//! One-line operations on flat vectors, and a start vector for eigenvalue iterations.

/// A fixed vector in (−1, 1) without structure, from the golden-ratio (Weyl) sequence.
pub(crate) fn unstructured(length: usize, seed: usize) -> Vec<f64> {
    let golden = 0.618_033_988_749_894_9;
    (0..length)
        .map(|i| {
            let x = (i + 1) as f64 * golden + seed as f64 * 0.414_213_562_373_095_1;
            let y = (x - x.floor()) * 97.31 + (i % 7) as f64 * 0.37;
            2.0 * (y - y.floor()) - 1.0
        })
        .collect()
}

pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

pub(crate) fn difference(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}

pub(crate) fn norm(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}
