//! Points through the thickness: the middles of equal slices, moved so that elastic bending is exact.

/// A point through the thickness.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slice {
    /// Height over the mid-surface of the section \[L\].
    pub height: f64,
    /// Thickness that it stands for \[L\].
    pub weight: f64,
}

/// `z_i = z_m + (t/2)(2i − 1 − n)/√(n² − 1)` with weights t/n, i from 1 to n ≥ 2: `Σ w = t` and `Σ w (z − z_m)² = t³/12`.
pub(super) fn slices(count: usize, thickness: f64, middle: f64) -> impl Iterator<Item = Slice> {
    let n = count as f64;
    let stretch = 0.5 * thickness / (n * n - 1.0).sqrt();
    (0..count)
        .map(move |i| Slice { height: middle + stretch * ((2 * i + 1) as f64 - n), weight: thickness / n })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn elastic_bending_is_exact_with_any_number_of_slices() {
        for count in [2, 3, 6, 7, 40] {
            let moment =
                |power: i32| slices(count, 0.3, 0.05).map(|s| s.weight * s.height.powi(power)).sum::<f64>();
            let exact = [0.3, 0.3 * 0.05, 0.3 * 0.05 * 0.05 + 0.3_f64.powi(3) / 12.0];
            for (power, exact) in exact.into_iter().enumerate() {
                assert!((moment(power as i32) / exact - 1.0).abs() < 1e-14, "{count} slices, moment {power}");
            }
        }
    }
}
