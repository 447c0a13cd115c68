//! Points of the boundary that come and go.

use std::ops::Range;

use sph_core::Vec3;

use crate::boundary::points::{Boundary, WallPart};

impl Boundary {
    /// Adds room for so many points behind all walls, aside at a place \[L\], of a boundary without structures.
    pub fn add(&mut self, count: usize, aside: Vec3, density: f64) -> Range<usize> {
        let range = self.points.len()..self.points.len() + count;
        self.points.resize(range.end, aside);
        self.velocities.resize(range.end, Vec3::zeros());
        self.densities.resize(range.end, density);
        self.forces.resize(range.end, [0.0; 3]);
        self.ledger.shares.resize(range.end, 0.0);
        self.ledger.owed.resize(range.end, 0.0);
        self.walls.push(WallPart { range: range.clone(), rest: Vec::new(), motion: None });
        range
    }
}
