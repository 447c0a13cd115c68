//! Which row of one run answers a row of another: by level, by time, along a path, by the shape of a mode.

use sph_core::{Cell, Vec3};

use crate::results::curve::Curve;
use crate::scene::Analysis;

/// Relative difference of two levels or times that are the same.
const SAME: f64 = 1e-9;
/// Least squared cosine between the shapes of two modes that are the same: two that share a frequency turn freely among each other,
/// and half of each may be in either.
const ALIKE: f64 = 0.3;
/// Most points at which shapes are compared.
const SAMPLES: usize = 1500;

/// By what rows are paired.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Key {
    /// One row answers one row.
    Only,
    /// By a column.
    Column(usize),
    /// By the shape of the mode.
    Shape,
}

/// By what the rows of an analysis are paired, whose curves are those of all its lattices.
///
/// # Errors
/// In words: a path along which no column grows.
pub(super) fn key(analysis: &Analysis, curves: &[&Curve]) -> Result<Key, String> {
    let Some(own) = curves.first() else { return Ok(Key::Only) };
    let named = |name: &str| own.columns.iter().position(|column| column.name == name);
    Ok(match analysis {
        Analysis::Linear(_) => Key::Only,
        Analysis::Modal(_) | Analysis::Buckling(_) => Key::Shape,
        Analysis::ResponseSpectrum(_) => named("base").map_or(Key::Only, Key::Column),
        Analysis::Harmonic(_) | Analysis::RandomVibration(_) => {
            named("frequency").map_or(Key::Only, Key::Column)
        }
        Analysis::ArcLength(_) => {
            let always = analysis.kind().columns;
            let grows = |&at: &usize| curves.iter().all(|curve| is_monotone(curve, at));
            let probes =
                (0..own.columns.len()).filter(|&at| !always.contains(&own.columns[at].name.as_str()));
            let along = probes.chain(named("level")).find(grows);
            Key::Column(along.ok_or("no column grows or falls all along the path, by which its points could be paired; measure one that does")?)
        }
        Analysis::Explicit(explicit) if explicit.transient.is_some() => {
            named("time").map_or(Key::Only, Key::Column)
        }
        _ => named("level").map_or(Key::Only, Key::Column),
    })
}

/// Whether a column grows, or falls, from each row to the next.
fn is_monotone(curve: &Curve, at: usize) -> bool {
    let steps: Vec<f64> = curve.rows.windows(2).map(|pair| pair[1][at] - pair[0][at]).collect();
    !steps.is_empty() && (steps.iter().all(|&step| step > 0.0) || steps.iter().all(|&step| step < 0.0))
}

/// The rows of another run that answer those of a run; interpolated by the third degree where records differ, none where there is none.
pub(super) fn by_column(own: &Curve, other: &Curve, key: usize) -> Vec<Option<Vec<f64>>> {
    let of = |curve: &Curve| -> Vec<f64> { curve.rows.iter().map(|row| row[key]).collect() };
    let (wanted, there) = (of(own), of(other));
    let size = wanted.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    let same = |a: f64, b: f64| (a - b).abs() <= SAME * size;
    let monotone = is_monotone(other, key);
    let pair = |(row, &x): (usize, &f64)| {
        if there.get(row).is_some_and(|&other| same(other, x)) {
            return other.rows.get(row).cloned();
        }
        if let Some(at) = there.iter().position(|&other| same(other, x)) {
            return other.rows.get(at).cloned();
        }
        if monotone { between_rows(&there, &other.rows, x) } else { None }
    };
    wanted.iter().enumerate().map(pair).collect()
}

/// Rows at `x` by the polynomial through the four nearest of a monotone list; none beyond its ends.
pub(super) fn between_rows(places: &[f64], rows: &[Vec<f64>], x: f64) -> Option<Vec<f64>> {
    let rises = places.last()? > places.first()?;
    let after = places.iter().position(|&place| if rises { place > x } else { place < x })?;
    if after == 0 {
        return None;
    }
    let count = places.len().min(4);
    let first = after.saturating_sub(2).min(places.len() - count);
    let weight = |i: usize| {
        let others = (first..first + count).filter(move |&j| j != i);
        others.map(|j| (x - places[j]) / (places[i] - places[j])).product::<f64>()
    };
    let weights: Vec<f64> = (first..first + count).map(weight).collect();
    let column = |at: usize| weights.iter().zip(&rows[first..]).map(|(w, row)| w * row[at]).sum();
    Some((0..rows[first].len()).map(column).collect())
}

/// The shapes of modes, as displacements of places at rest.
pub(super) struct Shapes<'a> {
    /// Places at rest \[L\].
    pub rest: &'a [Vec3],
    /// Cells between them, by whose areas places count; none of solids, all of whose nodes count alike.
    pub cells: &'a [Cell],
    /// Places in each mode, enlarged for the eye \[L\].
    pub modes: Vec<&'a [Vec3]>,
}

/// For each mode of a run the one of another with the same shape, by the greatest product weighted with areas; each is taken once.
pub(super) fn by_shape(own: &Shapes<'_>, other: &Shapes<'_>) -> Vec<Option<usize>> {
    // Where the coarser has its places the finer has one near.
    let coarser = if own.rest.len() <= other.rest.len() { own } else { other };
    let weights = areas(coarser);
    let step = coarser.rest.len().div_ceil(SAMPLES).max(1);
    let points: Vec<usize> = (0..coarser.rest.len()).step_by(step).collect();
    let nearest = |places: &[Vec3], x: &Vec3| {
        let distances = places.iter().enumerate().map(|(i, y)| (i, (x - y).norm_squared()));
        distances.min_by(|(_, a), (_, b)| a.total_cmp(b)).map_or(0, |(i, _)| i)
    };
    let at = |shapes: &Shapes<'_>| -> Vec<usize> {
        points.iter().map(|&point| nearest(shapes.rest, &coarser.rest[point])).collect()
    };
    let weights: Vec<f64> = points.iter().map(|&point| weights[point]).collect();
    let of = |shapes: &Shapes<'_>| -> Vec<Vec<Vec3>> {
        let places = at(shapes);
        let sampled = |mode: &&[Vec3]| {
            places.iter().map(|&i| mode.get(i).map_or(Vec3::zeros(), |x| x - shapes.rest[i])).collect()
        };
        shapes.modes.iter().map(sampled).collect()
    };
    let (mine, theirs) = (of(own), of(other));
    let product = |a: &[Vec3], b: &[Vec3]| -> f64 {
        a.iter().zip(b).zip(&weights).map(|((a, b), weight)| weight * a.dot(b)).sum()
    };
    let mut alike: Vec<(f64, usize, usize)> = Vec::new();
    for (i, a) in mine.iter().enumerate() {
        for (j, b) in theirs.iter().enumerate() {
            let squared = product(a, b) * product(a, b) / (product(a, a) * product(b, b));
            alike.extend((squared >= ALIKE).then_some((squared, i, j)));
        }
    }
    alike.sort_by(|a, b| b.0.total_cmp(&a.0).then((a.1, a.2).cmp(&(b.1, b.2))));
    let mut pairs = vec![None; mine.len()];
    let mut taken = vec![false; theirs.len()];
    for (_, i, j) in alike {
        if pairs[i].is_none() && !taken[j] {
            (pairs[i], taken[j]) = (Some(j), true);
        }
    }
    pairs
}

/// The share of the area of its cells that each place has; one each without cells.
fn areas(shapes: &Shapes<'_>) -> Vec<f64> {
    if shapes.cells.is_empty() {
        return vec![1.0; shapes.rest.len()];
    }
    let mut areas = vec![0.0; shapes.rest.len()];
    for cell in shapes.cells {
        let corners = &cell.corners[..usize::from(cell.count)];
        let [a, b, c] = [0, 1, 2].map(|i| shapes.rest[corners[i] as usize]);
        let d = shapes.rest[corners[corners.len() - 1] as usize];
        let area = 0.5 * (c - a).cross(&(d - b)).norm();
        corners.iter().for_each(|&a| areas[a as usize] += area / corners.len() as f64);
    }
    areas
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::results::curve::Column;

    fn curve(rows: &[[f64; 2]]) -> Curve {
        let columns = ["level", "w"].map(|name| Column { name: name.into(), unit: "-".into() });
        Curve { columns: columns.into(), rows: rows.iter().map(|row| row.to_vec()).collect() }
    }

    #[test]
    fn the_same_levels_are_paired_as_they_are_and_others_by_a_cubic() {
        let own = curve(&[[0.0, 0.0], [0.3, 0.0], [1.0, 0.0], [1.2, 0.0]]);
        let cubic = |x: f64| 1.0 + x * (2.0 + x * (3.0 - 4.0 * x));
        let there = [0.0, 0.25, 0.5, 0.75, 1.0].map(|x| [x, cubic(x)]);
        let found = by_column(&own, &curve(&there), 0);
        assert!((found[1].as_ref().unwrap()[1] - cubic(0.3)).abs() < 1e-14);
        assert_eq!(found[2].as_ref().unwrap()[1].to_bits(), cubic(1.0).to_bits());
        assert_eq!(found[3], None);
    }

    #[test]
    fn levels_that_come_twice_are_paired_by_their_rows() {
        let rows = [[0.0, 0.0], [1.0, 1.0], [0.0, 0.2]];
        let found = by_column(&curve(&rows), &curve(&rows), 0);
        assert_eq!(found[2].as_ref().unwrap()[1], 0.2);
    }

    /// Places in a row, and modes that are waves along it.
    fn waves(count: usize, waves: &[f64]) -> (Vec<Vec3>, Vec<Vec<Vec3>>) {
        let rest: Vec<Vec3> = (0..=count).map(|i| Vec3::new(i as f64 / count as f64, 0.0, 0.0)).collect();
        let mode = |&k: &f64| {
            let up = |x: &Vec3| x + Vec3::new(0.0, 0.0, 0.1 * libm::sin(std::f64::consts::PI * k * x.x));
            rest.iter().map(up).collect()
        };
        let modes = waves.iter().map(mode).collect();
        (rest, modes)
    }

    #[test]
    fn modes_in_another_order_are_found_by_their_shapes() {
        let ((rest, modes), (coarse, swapped)) = (waves(20, &[1.0, 2.0, 3.0]), waves(14, &[2.0, 1.0, 4.0]));
        let own = Shapes { rest: &rest, cells: &[], modes: modes.iter().map(Vec::as_slice).collect() };
        let other = Shapes { rest: &coarse, cells: &[], modes: swapped.iter().map(Vec::as_slice).collect() };
        assert_eq!(by_shape(&own, &other), [Some(1), Some(0), None]);
        assert_eq!(by_shape(&other, &own), [Some(1), Some(0), None]);
    }
}
