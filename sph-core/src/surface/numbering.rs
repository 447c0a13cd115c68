//! The numbering of a lattice: rows and columns of particles, its edges and cells.

use crate::error::SpaceError;
use crate::surface::cell::Cell;
use crate::surface::sides::Sides;

/// Numbering of a lattice: particle (i, j) has index `i·counts[1] + j`, i along u and j along v.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Lattice {
    /// Particles along u and along v.
    pub counts: [usize; 2],
}

impl Lattice {
    /// Index of particle (i, j).
    pub fn index(&self, i: usize, j: usize) -> usize {
        i * self.counts[1] + j
    }

    /// Particles with the `j`-th value of v, along u.
    pub fn row(&self, j: usize) -> Vec<u32> {
        (0..self.counts[0]).map(|i| self.index(i, j) as u32).collect()
    }

    /// Particles with the `i`-th value of u, along v.
    pub fn column(&self, i: usize) -> Vec<u32> {
        (0..self.counts[1]).map(|j| self.index(i, j) as u32).collect()
    }

    /// The particle in the middle; none unless both counts are odd.
    pub fn centre(&self) -> Option<u32> {
        let [n, m] = self.counts;
        (n % 2 == 1 && m % 2 == 1).then(|| self.index(n / 2, m / 2) as u32)
    }

    /// The four edges.
    pub(crate) fn sides(&self) -> Sides {
        let [last_u, last_v] = self.counts.map(|n| n - 1);
        Sides::new([self.column(0), self.column(last_u), self.row(0), self.row(last_v)])
    }

    /// One quadrangle per lattice cell, counter-clockwise about `∂X/∂u × ∂X/∂v`, starting at its lowest particle.
    pub(crate) fn cells(&self) -> Vec<Cell> {
        let at = |i, j| self.index(i, j) as u32;
        let mut cells = Vec::new();
        for i in 0..self.counts[0] - 1 {
            for j in 0..self.counts[1] - 1 {
                cells.push(Cell::quadrangle([at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]));
            }
        }
        cells
    }

    /// Refuses lattices with less than two particles a row.
    pub(crate) fn check(&self) -> Result<(), SpaceError> {
        let found = self.counts[0].min(self.counts[1]);
        if found < 2 {
            return Err(SpaceError::TooFew { what: "particles in a lattice row", found, needed: 2 });
        }
        Ok(())
    }
}
