//! How bodies lie one behind the other: their particles, sampling points, and numbers that fields of linear answers take.

use std::ops::Range;

use sph_core::{Cell, Vec3};

use crate::bodies::Body;

/// Names and ranges of all bodies.
#[derive(Clone, Debug, Default)]
pub(in crate::bodies) struct Layout {
    /// Names of the bodies.
    pub names: Vec<String>,
    /// Particles of each.
    pub particles: Vec<Range<usize>>,
    /// Points of each at which strains are sampled.
    pub points: Vec<Range<usize>>,
    /// Of each its part of [`crate::StaticBody::forces`]; empty where no linear answer is sought.
    pub forces: Vec<Range<usize>>,
    /// Which of the interactions are contacts.
    pub contacts: Range<usize>,
    /// Which of them are glue.
    pub glue: Range<usize>,
    /// Which of them are links.
    pub links: Range<usize>,
    /// Particles at rest, all bodies one behind the other \[L\].
    pub rest: Vec<Vec3>,
    /// Cells of all, by these numbers.
    pub cells: Vec<Cell>,
}

impl Layout {
    /// Adds a body that samples strains at so many points.
    pub fn add(&mut self, name: &str, body: &dyn Body, points: usize) {
        let own = body.configuration();
        let first = self.rest.len();
        self.cells.extend(own.cells.iter().map(|cell| Cell {
            corners: cell.corners.map(|corner| corner + first as u32),
            count: cell.count,
        }));
        self.rest.extend_from_slice(own.rest);
        self.names.push(name.into());
        self.particles.push(first..self.rest.len());
        let sampled = self.points.last().map_or(0, |last| last.end);
        self.points.push(sampled..sampled + points);
    }

    /// Of ascending particles of all those of each body, by its own numbers.
    pub fn of_each(&self, all: &[u32]) -> Vec<Vec<u32>> {
        let own = |range: &Range<usize>| {
            let inside = all.iter().map(|&particle| particle as usize).filter(|a| range.contains(a));
            inside.map(|particle| (particle - range.start) as u32).collect()
        };
        self.particles.iter().map(own).collect()
    }

    /// The body of a particle, and its number there.
    pub fn place(&self, particle: usize) -> (usize, usize) {
        within(&self.particles, particle)
    }

    /// The body of a sampling point, and its number there.
    pub fn point(&self, point: usize) -> (usize, usize) {
        within(&self.points, point)
    }
}

/// Which of some ranges, one behind the other, has a number, and which it is there.
fn within(ranges: &[Range<usize>], number: usize) -> (usize, usize) {
    let found = ranges.partition_point(|range| range.end <= number);
    (found, number - ranges.get(found).map_or(0, |range| range.start))
}

#[cfg(test)]
mod tests {
    use super::within;

    #[test]
    fn every_number_is_one_of_one_body() {
        let ranges = [0..2, 2..2, 2..5];
        let found: Vec<_> = (0..5).map(|number| within(&ranges, number)).collect();
        assert_eq!(found, [(0, 0), (0, 1), (2, 0), (2, 1), (2, 2)]);
    }
}
