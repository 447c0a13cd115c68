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

/// Entries this near to the greatest are as great, so that rounding does not choose among symmetric ones.
const AS_GREAT: f64 = 1e-3;

/// The sign of the first of the greatest entries of a mode: the side that it has whatever the solver gave; one without entries.
pub fn sign_of_greatest(entries: impl Iterator<Item = f64> + Clone) -> f64 {
    let most = entries.clone().fold(0.0, |most: f64, q| most.max(q.abs()));
    let mut great = entries.filter(|q| q.abs() >= (1.0 - AS_GREAT) * most);
    great.next().map_or(1.0, f64::signum)
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

#[cfg(test)]
mod tests {
    use super::sign_of_greatest;

    #[test]
    fn the_first_of_equal_entries_has_the_sign_whatever_the_solver_gave() {
        let wave = [0.5, -0.999_999, 1.0];
        assert_eq!(sign_of_greatest(wave.into_iter()), -1.0);
        assert_eq!(sign_of_greatest(wave.into_iter().map(|q| -q)), 1.0);
    }
}
