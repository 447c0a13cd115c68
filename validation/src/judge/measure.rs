//! What is measured on curves: values between points, order of convergence, the best of cost and error.

/// The value at `at` of the cubic through the four points nearest to it; none outside the points.
///
/// `x` grows. Between smooth samples of spacing h the error is of order h⁴.
pub fn cubic_at(x: &[f64], y: &[f64], at: f64) -> Option<f64> {
    let last = x.len().min(y.len()).checked_sub(1)?;
    if last < 3 || !(x[0] <= at && at <= x[last]) {
        return None;
    }
    let right = x.partition_point(|&known| known < at).max(1);
    let first = right.saturating_sub(2).min(last - 3);
    let near = first..first + 4;
    let lagrange =
        |a: usize| near.clone().filter(|&b| b != a).map(|b| (at - x[b]) / (x[a] - x[b])).product::<f64>();
    Some(near.clone().map(|a| y[a] * lagrange(a)).sum())
}

/// The order p of `error ~ spacing^p`: slope of the straight line through the logarithms, by least squares.
///
/// None for fewer than two points, equal spacings, or errors that are not positive.
pub fn order_of_convergence(points: &[(f64, f64)]) -> Option<f64> {
    if points.len() < 2 || points.iter().any(|&(spacing, error)| !(spacing > 0.0 && error > 0.0)) {
        return None;
    }
    let logs: Vec<(f64, f64)> =
        points.iter().map(|(spacing, error)| (libm::log(*spacing), libm::log(*error))).collect();
    let mean = |pick: fn(&(f64, f64)) -> f64| logs.iter().map(pick).sum::<f64>() / logs.len() as f64;
    let (x0, y0) = (mean(|p| p.0), mean(|p| p.1));
    let across: f64 = logs.iter().map(|(x, y)| (x - x0) * (y - y0)).sum();
    let spread: f64 = logs.iter().map(|(x, _)| (x - x0).powi(2)).sum();
    (spread > 0.0).then(|| across / spread)
}

/// The points that no other point beats in both cost and error, by growing cost; points are `(cost, error)`.
pub fn frontier(points: &[(f64, f64)]) -> Vec<usize> {
    let mut by_cost: Vec<usize> = (0..points.len()).collect();
    by_cost.sort_by(|&a, &b| points[a].0.total_cmp(&points[b].0).then(points[a].1.total_cmp(&points[b].1)));
    let mut best = f64::INFINITY;
    by_cost.retain(|&i| {
        let better = points[i].1 < best;
        best = best.min(points[i].1);
        better
    });
    by_cost
}

/// The largest of the values; none if there are none or one is missing.
pub fn largest(values: impl IntoIterator<Item = Option<f64>>) -> Option<f64> {
    let mut largest: Option<f64> = None;
    for value in values {
        let value = value?;
        largest = Some(largest.map_or(value, |known| known.max(value)));
    }
    largest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cubics_are_met_between_uneven_points_up_to_the_ends() {
        let x = [0.0, 0.5, 2.0, 3.0, 4.5, 5.0];
        let cubic = |x: f64| 1.0 - 2.0 * x + 0.5 * x * x - 0.1 * x * x * x;
        let y = x.map(cubic);
        for at in [0.0, 0.2, 0.5, 1.9, 2.5, 4.0, 4.9, 5.0] {
            let found = cubic_at(&x, &y, at).unwrap();
            assert!((found - cubic(at)).abs() < 1e-13, "{at}: {found}");
        }
        assert_eq!(cubic_at(&x, &y, 5.1), None);
        assert_eq!(cubic_at(&x, &y, f64::NAN), None);
        assert_eq!(cubic_at(&x[..3], &y[..3], 1.0), None);
    }

    #[test]
    fn the_order_of_a_power_is_its_exponent() {
        let power = |p: f64| [0.4, 0.2, 0.1].map(|h: f64| (h, 3.0 * libm::pow(h, p)));
        for p in [1.0, 1.8, 2.0, 4.0] {
            assert!((order_of_convergence(&power(p)).unwrap() - p).abs() < 1e-12);
            assert!((order_of_convergence(&power(p)[1..]).unwrap() - p).abs() < 1e-12);
        }
        assert_eq!(order_of_convergence(&[(0.1, 1.0)]), None);
        assert_eq!(order_of_convergence(&[(0.1, 1.0), (0.1, 2.0)]), None);
        assert_eq!(order_of_convergence(&[(0.1, 1.0), (0.2, 0.0)]), None);
    }

    #[test]
    fn the_frontier_holds_what_nothing_beats() {
        let points = [(1.0, 5.0), (2.0, 5.0), (3.0, 1.0), (2.5, 2.0), (4.0, 1.5), (1.0, 6.0)];
        assert_eq!(frontier(&points), [0, 3, 2]);
        assert_eq!(frontier(&[]), [0; 0]);
    }

    #[test]
    fn one_missing_value_hides_the_largest() {
        assert_eq!(largest([Some(1.0), Some(3.0), Some(2.0)]), Some(3.0));
        assert_eq!(largest([Some(1.0), None]), None);
        assert_eq!(largest([]), None);
    }
}
