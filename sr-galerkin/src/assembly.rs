//! The stiffness of a body: cells in batches, added in their order, and what loads add that follow.

use std::cmp::Ordering;

use rayon::prelude::*;
use solid_kinematics::{PointTangent, Tangent, Tensor};

use crate::blocks::Blocks;
use crate::body::Galerkin;
use crate::discretisation::Cell;
use crate::heat::warm_volumes;
use crate::images::Images;
use crate::stiffness::{Scratch, cell_stiffness};
use crate::volumes::{Coupled, Nine, couple};

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
            let scratches = 0..BATCH.min(self.space.cells.len());
            self.scratch = scratches.map(|_| Scratch::new(points, 9 * widest)).collect();
        }
        self.blocks.clear();
        let mut scratch = std::mem::take(&mut self.scratch);
        for begin in (0..self.space.cells.len()).step_by(BATCH) {
            let count = BATCH.min(self.space.cells.len() - begin);
            let work = |(at, scratch): (usize, &mut Scratch)| self.cell(begin + at, scratch);
            let scratches = &mut scratch[..count];
            if self.threads > 1 {
                scratches.par_iter_mut().enumerate().for_each(work);
            } else {
                scratches.iter_mut().enumerate().for_each(work);
            }
            for (cell, scratch) in self.space.cells[begin..].iter().zip(scratches.iter()) {
                if cell.runs.is_empty() {
                    add_mirrored(&mut self.blocks, cell, &self.space.images, &scratch.matrix);
                } else {
                    self.blocks.add_cell(cell, &scratch.matrix);
                }
            }
        }
        self.scratch = scratch;
    }

    /// Adds the symmetric part of the stiffness of loads that follow.
    pub(crate) fn add_load_stiffness(&mut self, level: f64) {
        let blocks = &mut self.blocks;
        self.loads.stiffness((&self.space.images, &self.parameters), |row, column, k| {
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
    fn cell(&self, number: usize, scratch: &mut Scratch) {
        let cell = &self.space.cells[number];
        let kind = if self.insists { Tangent::Consistent } else { self.tangent };
        for (at, moduli) in scratch.moduli.iter_mut().enumerate() {
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
        let coupled = self.couple(number, &mut scratch.moduli);
        cell_stiffness(cell, self.space.slice, scratch);
        if let Some(coupled) = coupled {
            add_coupled(cell, &coupled, &mut scratch.matrix);
        }
    }

    /// Turns moduli of the points of a cell into those with a common change of volume, where there is one, and of a warm body into those by rest.
    pub(crate) fn couple(&self, number: usize, moduli: &mut [PointTangent]) -> Option<Coupled> {
        let points = number * self.space.points..(number + 1) * self.space.points;
        let of_points = (&self.trials[points.clone()], &self.shared[points]);
        let cell = &self.space.cells[number];
        let Some(stretches) = self.stretches(number) else {
            return self.sharing.map(|sharing| couple(sharing, of_points, &cell.volumes, moduli));
        };
        let warm = warm_volumes(cell, Some(stretches)).unwrap_or_default();
        let mut coupled = self.sharing.map(|sharing| couple(sharing, of_points, &warm, moduli));
        for (point, s) in stretches.iter().enumerate() {
            moduli[point].iter_mut().flatten().for_each(|own| *own *= s);
            if let Some(own) = &mut coupled {
                for nines in [&mut own.mean, &mut own.rows, &mut own.columns] {
                    nines[point].iter_mut().for_each(|own| *own /= s);
                }
            }
        }
        coupled
    }

    /// Derivative of the stress of a point; where the update failed, that of its last sound state.
    pub(crate) fn moduli_of(&self, point: usize, kind: Tangent) -> PointTangent {
        let (from, trial) = (&self.history[point], &self.trials[point]);
        self.material.tangent(kind, from, trial).unwrap_or([[0.0; 9]; 9])
    }
}

/// Adds the matrix of a cell that sees images: what couples images couples their nodes, `R_Iᵀ K R_J`.
fn add_mirrored(blocks: &mut Blocks, cell: &Cell, images: &Images, matrix: &[f64]) {
    let real: Vec<(u32, Tensor)> = cell.nodes.iter().map(|&number| images.real(number)).collect();
    let mut add = |row: u32, column: u32, k: &Tensor| {
        let rows = std::array::from_fn(|i| std::array::from_fn(|j| k[(i, j)]));
        blocks.add(row, column, &rows);
    };
    for (a, (row, left)) in real.iter().enumerate() {
        for (b, (column, right)) in real.iter().enumerate().skip(a) {
            let own = Tensor::from_fn(|i, j| matrix[(9 * a + 3 * i + j) * cell.width + b]);
            let k = left.transpose() * own * right;
            match row.cmp(column) {
                Ordering::Less => add(*row, *column, &k),
                Ordering::Greater => add(*column, *row, &k.transpose()),
                Ordering::Equal if a == b => add(*row, *row, &k),
                Ordering::Equal => add(*row, *row, &(k + k.transpose())),
            }
        }
    }
}

/// Adds `q bᵀ + b qᵀ + S b bᵀ` to the matrix of a cell, b and q being the rows of mean and coupling over its parameters.
fn add_coupled(cell: &Cell, coupled: &Coupled, matrix: &mut [f64]) {
    let width = cell.width;
    let [mean, side] = [&coupled.mean, &coupled.rows].map(|nines| over_parameters(cell, nines));
    for node in 0..cell.nodes.len() {
        for component in 0..9 {
            let (i, k) = (component / 3, component % 3);
            let (b, q) = (mean[i * width + node], side[i * width + node]);
            let (mean, side) = (&mean[k * width..][..width], &side[k * width..][..width]);
            let row = &mut matrix[(9 * node + component) * width..][..width];
            for at in node..width {
                row[at] += q * mean[at] + b * side[at] + coupled.scalar * (b * mean[at]);
            }
        }
    }
}

/// `Σ_g ∂φ_I/∂X_J n_iJ` over the nodes of a cell, three rows.
pub(crate) fn over_parameters(cell: &Cell, nines: &[Nine]) -> Vec<f64> {
    let width = cell.width;
    let mut out = vec![0.0; 3 * width];
    for (point, nine) in nines.iter().enumerate() {
        for (component, n) in nine.iter().enumerate() {
            let row = &mut out[component / 3 * width..][..width];
            let gradient = cell.gradient(point, component % 3);
            row.iter_mut().zip(gradient).for_each(|(row, g)| *row += n * g);
        }
    }
    out
}
