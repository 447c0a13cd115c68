//! Particles near a place, found anew for whoever asks between two steps.

use sph_core::Vec3;

use crate::cells::{Grid, NOWHERE};
use crate::fluid::Fluid;
use crate::sorted::Sorted;

/// The particles of a fluid by cells.
pub(crate) struct Nearby {
    grid: Grid,
    fluid: Sorted,
    boundary: Sorted,
}

impl Nearby {
    /// Of the present places.
    pub fn new(fluid: &Fluid) -> Self {
        let (positions, points) = (&fluid.present.positions, &fluid.boundary.points);
        let grid = Grid::around(fluid.dimensions, positions.iter().copied(), 2.0 * fluid.momentum.kernel.h);
        let (mut own, mut boundary) = (Sorted::default(), Sorted::default());
        own.sort(1, &grid, positions.len(), |i, _| positions[i].into());
        boundary.sort(1, &grid, points.len(), |i, _| points[i].into());
        Self { grid, fluid: own, boundary }
    }

    /// Calls for each particle of the fluid that may be within reach of a place.
    pub fn each(&self, at: Vec3, call: impl FnMut(usize)) {
        self.of(&self.fluid, at, call);
    }

    /// Calls for each particle of a boundary that may be within reach of a place.
    pub fn each_boundary(&self, at: Vec3, call: impl FnMut(usize)) {
        self.of(&self.boundary, at, call);
    }

    fn of(&self, set: &Sorted, at: Vec3, mut call: impl FnMut(usize)) {
        let cell = self.grid.cell(&at.into());
        if cell == NOWHERE {
            return;
        }
        for &(from, to) in self.grid.beside(cell, &set.starts).filled() {
            set.order[from as usize..to as usize].iter().for_each(|&i| call(i as usize));
        }
    }
}
