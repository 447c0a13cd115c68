//! What columns were over a run in time: mean, root mean square, integral, least and greatest.

use serde::Serialize;

use crate::results::curve::{Column, Curve};

/// A column over the time of the run. Between records it goes along straight lines: means and the integral are trapezoids, the mean square is exact for them.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OverTime {
    /// The column.
    #[serde(flatten)]
    pub column: Column,
    /// Mean over the time.
    pub mean: f64,
    /// Root of the mean square over the time.
    pub root_mean_square: f64,
    /// Integral over the time: of a force its impulse, in the unit of the column times that of time.
    pub integral: f64,
    /// Least number at a record.
    pub least: f64,
    /// When that was, first \[T\].
    pub least_at: f64,
    /// Greatest number at a record.
    pub greatest: f64,
    /// When that was, first \[T\].
    pub greatest_at: f64,
}

impl OverTime {
    /// Of all columns from a given one on; the first column is the time. None of a curve without records.
    pub(crate) fn of(curve: &Curve, first: usize) -> Vec<Self> {
        let columns = curve.columns.iter().enumerate().skip(first);
        columns.filter_map(|(at, column)| Self::of_column(column, curve, at)).collect()
    }

    fn of_column(column: &Column, curve: &Curve, at: usize) -> Option<Self> {
        let points: Vec<[f64; 2]> = curve.rows.iter().map(|row| [row[0], row[at]]).collect();
        let (&[begin, start], &[end, _]) = (points.first()?, points.last()?);
        let (mut integral, mut squares) = (0.0, 0.0);
        let [mut least, mut greatest] = [[begin, start]; 2];
        for pair in points.windows(2) {
            let ([t0, a], [t1, b]) = (pair[0], pair[1]);
            integral += 0.5 * (t1 - t0) * (a + b);
            squares += (t1 - t0) * (a * a + a * b + b * b) / 3.0;
            if b < least[1] {
                least = pair[1];
            }
            if b > greatest[1] {
                greatest = pair[1];
            }
        }
        let length = end - begin;
        let (mean, square) =
            if length > 0.0 { (integral / length, squares / length) } else { (start, start * start) };
        Some(Self {
            column: column.clone(),
            mean,
            root_mean_square: square.sqrt(),
            integral,
            least: least[1],
            least_at: least[0],
            greatest: greatest[1],
            greatest_at: greatest[0],
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A sine over whole periods, recorded so often that straight lines leave (2π/n)²/12 of it, 3e-6.
    #[test]
    fn a_sine_has_its_figures() {
        let n = 1000;
        let row = |i: i32| {
            let t = 2.0 * f64::from(i) / f64::from(n);
            vec![t, 3.0 * libm::sin(std::f64::consts::TAU * t) + 1.0]
        };
        let column = |name: &str| Column { name: name.into(), unit: "-".into() };
        let curve = Curve { columns: vec![column("time"), column("x")], rows: (0..=n).map(row).collect() };
        let found = OverTime::of(&curve, 1).remove(0);
        assert!((found.mean - 1.0).abs() < 1e-13 && (found.integral - 2.0).abs() < 1e-13, "{found:?}");
        let exact = 5.5_f64.sqrt();
        assert!((found.root_mean_square / exact - 1.0).abs() < 1e-4, "{found:?}");
        assert!(
            (found.greatest - 4.0).abs() < 1e-12 && (found.greatest_at - 0.25).abs() < 1e-12,
            "{found:?}"
        );
        assert!((found.least + 2.0).abs() < 1e-12 && (found.least_at - 0.75).abs() < 1e-12, "{found:?}");
        assert!(OverTime::of(&Curve { rows: Vec::new(), ..curve }, 1).is_empty());
    }
}
