//! What the large-deflection problems share: distances from published tables and paths.

use benchmarks_ref::{Curve, reference};

use crate::JudgeError;
use crate::case::Run;
use crate::measure::{cubic_at, largest};

/// A column of a table against a column of a run, both over the load.
pub struct Compared<'a> {
    /// Name of the table.
    pub table: &'a str,
    /// Its columns: load, value.
    pub known: [&'a str; 2],
    /// The run's columns: load, value.
    pub found: [&'a str; 2],
}

impl Compared<'_> {
    /// The largest difference at the table's rows up to a load, leaving out one load, on the run's part of first rise;
    /// none if that ended before.
    pub fn largest(&self, run: &Run, until: f64, without: Option<f64>) -> Result<Option<f64>, JudgeError> {
        let table = reference(self.table)?;
        let rows = table.column(self.known[0])?.into_iter().zip(table.column(self.known[1])?);
        // Straight pieces: a cubic would swing where the load hardly grows and the displacement runs.
        let (loads, values) = (run.column(self.found[0])?, run.column(self.found[1])?);
        let rising = 1 + loads.windows(2).take_while(|pair| pair[1] > pair[0]).count();
        let own = Curve::new(
            loads[..rising.min(loads.len())].to_vec(),
            values[..rising.min(values.len())].to_vec(),
        );
        let at = |load: f64| own.as_ref().ok().and_then(|curve| curve.at(load).ok());
        let differences = rows
            .filter(|&(load, _)| load <= until && without.is_none_or(|left_out| left_out != load))
            .map(|(load, known)| at(load).map(|found| (found - known).abs()));
        Ok(largest(differences))
    }
}

/// The value at a place of a path whose abscissa grows; the last digits of one that was stepped to do not count.
pub fn value_at(x: &[f64], y: &[f64], at: f64) -> Option<f64> {
    let last = x.last().copied()?;
    let slack = 1e-6 * last.abs();
    let at = if (at - last).abs() <= slack { last } else { at };
    cubic_at(x, y, at)
}

/// The largest distance of points from a path of straight pieces, both axes in parts of `scale`, in percent.
pub fn distance(path: &[(f64, f64)], points: &[(f64, f64)], scale: (f64, f64)) -> Option<f64> {
    let scaled = |&(x, y): &(f64, f64)| (x / scale.0, y / scale.1);
    let to_piece = |p: (f64, f64), a: (f64, f64), b: (f64, f64)| {
        let (dx, dy) = (b.0 - a.0, b.1 - a.1);
        let square = dx * dx + dy * dy;
        let along = if square > 0.0 { ((p.0 - a.0) * dx + (p.1 - a.1) * dy) / square } else { 0.0 };
        let t = along.clamp(0.0, 1.0);
        (p.0 - a.0 - t * dx).hypot(p.1 - a.1 - t * dy)
    };
    largest(points.iter().map(|point| {
        let point = scaled(point);
        let pieces = path.windows(2).map(|pair| to_piece(point, scaled(&pair[0]), scaled(&pair[1])));
        pieces.reduce(f64::min).map(|nearest| 100.0 * nearest)
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_are_across_the_path_and_in_parts_of_the_scale() {
        let path = [(0.0, 0.0), (10.0, 0.0), (10.0, 20.0)];
        // 1/10 of the scale above the first piece, half of it beyond the end of the second.
        assert_eq!(distance(&path, &[(5.0, 2.0)], (10.0, 20.0)), Some(10.0));
        assert_eq!(distance(&path, &[(5.0, 2.0), (10.0, 30.0)], (10.0, 20.0)), Some(50.0));
        assert_eq!(distance(&[], &[(1.0, 1.0)], (1.0, 1.0)), None);
    }
}
