//! Fields of one lattice on another of the same surface: by the cubic through the four nearest rows, direction by direction.

/// Numbers of a particle: position and director.
const NUMBERS: usize = 6;
/// Most rows that a place is found from.
const ROWS: usize = 4;

/// From the particles of one lattice to those of another.
pub(super) struct Between {
    /// Particles of the first along u and v.
    from: [usize; 2],
    /// Of each row of the other along u, along v, the rows that it is found from.
    places: [Vec<Place>; 2],
}

/// A row between rows.
struct Place {
    first: usize,
    weights: Vec<f64>,
}

impl Between {
    /// Between lattices with so many particles along u and v, two at least.
    pub fn new(from: [usize; 2], to: [usize; 2]) -> Self {
        let along = |axis: usize| (0..to[axis]).map(|row| place(row, from[axis], to[axis])).collect();
        Self { from, places: [along(0), along(1)] }
    }

    /// Six numbers a particle, in the order of the particles of a lattice, on the other one.
    pub fn carried(&self, field: &[f64]) -> Vec<f64> {
        let [along, across] = &self.places;
        let mut found = Vec::with_capacity(NUMBERS * along.len() * across.len());
        for place in along {
            for other in across {
                let mut sum = [0.0; NUMBERS];
                for (i, a) in place.weights.iter().enumerate() {
                    for (j, b) in other.weights.iter().enumerate() {
                        let at = NUMBERS * ((place.first + i) * self.from[1] + other.first + j);
                        sum.iter_mut().zip(&field[at..]).for_each(|(sum, value)| *sum += a * b * value);
                    }
                }
                found.extend(sum);
            }
        }
        found
    }
}

/// Row `row` of `to` between those of `from`: Lagrange's polynomial through the nearest.
fn place(row: usize, from: usize, to: usize) -> Place {
    let x = row as f64 / (to - 1) as f64 * (from - 1) as f64;
    let count = from.min(ROWS);
    let first = (x as usize).saturating_sub(1).min(from - count);
    let weight = |i: usize| {
        let others = (0..count).filter(move |&j| j != i);
        others.map(|j| (x - (first + j) as f64) / (i as f64 - j as f64)).product()
    };
    Place { first, weights: (0..count).map(weight).collect() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cubics_are_carried_exactly_to_finer_and_coarser_lattices() {
        let field = |[n, m]: [usize; 2]| -> Vec<f64> {
            let at = |i: usize, j: usize| {
                let (u, v) = (i as f64 / (n - 1) as f64, j as f64 / (m - 1) as f64);
                (0..6).map(move |k| 1.0 + u * (2.0 - u * (1.0 + f64::from(k) * u)) * (1.0 - v * v * v))
            };
            (0..n).flat_map(|i| (0..m).flat_map(move |j| at(i, j))).collect()
        };
        for (from, to) in [([9, 7], [17, 13]), ([17, 13], [12, 9]), ([5, 4], [5, 4])] {
            let found = Between::new(from, to).carried(&field(from));
            let wanted = field(to);
            assert_eq!(found.len(), wanted.len());
            for (found, wanted) in found.iter().zip(&wanted) {
                assert!((found - wanted).abs() < 1e-13, "{found} {wanted}");
            }
        }
    }

    #[test]
    fn few_rows_carry_what_their_degree_allows() {
        // Three rows: a parabola.
        let field: Vec<f64> = [0.0, 0.25, 1.0].iter().flat_map(|&x| [x; 12]).collect();
        let found = Between::new([3, 2], [5, 2]).carried(&field);
        let rows: Vec<f64> = found.chunks(12).map(|row| row[0]).collect();
        for (found, wanted) in rows.iter().zip([0.0, 0.0625, 0.25, 0.5625, 1.0]) {
            assert!((found - wanted).abs() < 1e-15);
        }
    }
}
