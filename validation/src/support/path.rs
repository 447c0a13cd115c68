//! Paths of load over displacement: values on them, distances from them.

use crate::judge::measure::{cubic_at, largest};

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
        libm::hypot(p.0 - a.0 - t * dx, p.1 - a.1 - t * dy)
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
