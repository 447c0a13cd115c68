//! The stiffness of a body: cells in batches, added in their order, and what loads add that follow.

use rayon::prelude::*;
use solid_kinematics::{PointTangent, Tangent};

use crate::body::Galerkin;
use crate::stiffness::{Scratch, cell_stiffness};

/// Cells whose matrices are computed at once.
const BATCH: usize = 16;

impl Galerkin {
    /// Assembles the stiffness of the stresses between all parameters, at the present state and a level.
    pub(crate) fn assemble(&mut self, level: f64) {
        self.evaluate_internal(level);
        let points = self.space.points;
        if self.scratch.is_empty() {
            let widest =
                self.space.cells.iter().fold(0, |most, cell| most.max(cell.nodes.len() * cell.width));
            let rooms = 0..BATCH.min(self.space.cells.len());
            self.scratch = rooms.map(|_| Scratch::new(points, 9 * widest)).collect();
        }
        self.blocks.clear();
        let mut scratch = std::mem::take(&mut self.scratch);
        for begin in (0..self.space.cells.len()).step_by(BATCH) {
            let count = BATCH.min(self.space.cells.len() - begin);
            let work = |(at, room): (usize, &mut Scratch)| self.cell(begin + at, room);
            let rooms = &mut scratch[..count];
            if self.threads > 1 {
                rooms.par_iter_mut().enumerate().for_each(work);
            } else {
                rooms.iter_mut().enumerate().for_each(work);
            }
            for (cell, room) in self.space.cells[begin..].iter().zip(rooms.iter()) {
                self.blocks.add_cell(cell, &room.matrix);
            }
        }
        self.scratch = scratch;
    }

    /// Adds the symmetric part of the stiffness of loads that follow.
    pub(crate) fn add_load_stiffness(&mut self, level: f64) {
        let blocks = &mut self.blocks;
        self.loads.stiffness(&self.parameters, |row, column, k| {
            let half = -0.5 * level;
            let straight: [[f64; 3]; 3] = std::array::from_fn(|i| std::array::from_fn(|j| half * k[i][j]));
            let turned: [[f64; 3]; 3] = std::array::from_fn(|i| std::array::from_fn(|j| half * k[j][i]));
            if row <= column {
                blocks.add(row, column, &straight);
            }
            if row >= column {
                blocks.add(column, row, &turned);
            }
        });
    }

    /// Moduli of the points of a cell and its matrix.
    fn cell(&self, number: usize, room: &mut Scratch) {
        let cell = &self.space.cells[number];
        let kind = if self.insists { Tangent::Consistent } else { self.tangent };
        for (at, moduli) in room.moduli.iter_mut().enumerate() {
            *moduli = self.moduli_of(number * self.space.points + at, kind);
            if kind == Tangent::Consistent {
                for row in 0..9 {
                    for column in 0..row {
                        let mean = 0.5 * (moduli[row][column] + moduli[column][row]);
                        (moduli[row][column], moduli[column][row]) = (mean, mean);
                    }
                }
            }
        }
        cell_stiffness(cell, self.space.slice, room);
    }

    /// Derivative of the stress of a point; where the update failed, that of its last sound state.
    pub(crate) fn moduli_of(&self, point: usize, kind: Tangent) -> PointTangent {
        let (from, trial) = (&self.history[point], &self.trials[point]);
        self.material.tangent(kind, from, trial).unwrap_or([[0.0; 9]; 9])
    }
}
