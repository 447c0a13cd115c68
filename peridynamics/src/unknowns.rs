//! The free degrees of freedom of a body as unknowns: of each row, its components along directions that no support holds.
//!
//! A director counts as an arc at a fixed radius, a power of two near the spacing: all unknowns are lengths and all their
//! forces are forces, so that no norm and no pivot depends on the units of a scene.

use sph_core::{Vec3, follow_turn};

use crate::constraint::Constraints;

/// Where the unknowns of each row start, and along what they move it.
#[derive(Clone, Debug)]
pub(crate) struct Unknowns {
    /// First unknown of each row, and the end.
    offsets: Vec<u32>,
    /// What a unit of each unknown adds to its row: orthogonal, of length one, for directors of length `1/arc`.
    directions: Vec<Vec3>,
}

impl Unknowns {
    /// Numbers what the constraints of all rows leave free; the first `nodes` rows are positions.
    pub fn new(constraints: &Constraints, nodes: usize, spacing: f64) -> Self {
        // A power of two: scaling by it leaves every digit.
        let arc = libm::exp2(libm::round(libm::log2(spacing)));
        let mut out = Self { offsets: vec![0], directions: Vec::new() };
        for row in 0..constraints.of.len() {
            let unit = if row < nodes { 1.0 } else { 1.0 / arc };
            match constraints.get(row) {
                None => out.directions.extend([Vec3::x(), Vec3::y(), Vec3::z()].map(|axis| axis * unit)),
                Some(constraint) => out.directions.extend(constraint.held.free().iter().map(|n| n * unit)),
            }
            out.offsets.push(out.directions.len() as u32);
        }
        out
    }

    /// The same of nodes whose free directions follow a turn of each.
    pub fn turned(&self, turns: &[Vec3]) -> Self {
        let mut out = self.clone();
        for (row, turn) in turns.iter().enumerate() {
            let own = self.of(row);
            follow_turn(&mut out.directions[own.clone()], &self.directions[own], turn);
        }
        out
    }

    /// Number of unknowns.
    pub fn count(&self) -> usize {
        self.directions.len()
    }

    /// Unknowns of a row.
    pub fn of(&self, row: usize) -> std::ops::Range<usize> {
        self.offsets[row] as usize..self.offsets[row + 1] as usize
    }

    /// What units of the unknowns of a row add to it.
    pub fn directions_of(&self, row: usize) -> &[Vec3] {
        &self.directions[self.of(row)]
    }

    /// What a unit of an unknown adds to its row.
    #[inline]
    pub fn direction(&self, unknown: usize) -> &Vec3 {
        &self.directions[unknown]
    }

    /// The row of an unknown, and what a unit of it adds to that row.
    pub fn find(&self, unknown: usize) -> (usize, Vec3) {
        let row = self.offsets.partition_point(|&first| first as usize <= unknown) - 1;
        (row, self.directions[unknown])
    }

    /// Components of vectors of all rows along the unknowns.
    pub fn project(&self, row: impl Fn(usize) -> Vec3, out: &mut [f64]) {
        for a in 0..self.offsets.len() - 1 {
            let v = row(a);
            for unknown in self.of(a) {
                out[unknown] = self.directions[unknown].dot(&v);
            }
        }
    }
}
