//! The stiffness of a background cell, `K_iIkL = Σ_g V_g ∂_Jφ_I A_iJkL ∂_Lφ_K`.
//!
//! Points are summed by slices: nine rows of the result stay in registers while the points of a slice pass. The sums go over the points
//! in their order, so that the widest vectors give the same bits as the narrowest.

use rayon::prelude::*;
use solid_kinematics::{PointTangent, Tangent};

use crate::body::Galerkin;
use crate::discretisation::{Cell, LANES, MOST_IN_SLICE};

/// Entries of a row of moduli, three times nine, up to a multiple of the lanes.
const ROW: usize = 28;
/// Cells whose matrices are computed at once, then added in their order.
const BATCH: usize = 16;

/// Writes the matrix of a cell: for each node I nine rows `3i + k` over the nodes K ≥ I, as wide as the cell.
pub(crate) fn cell_stiffness(cell: &Cell, moduli: &[PointTangent], slice: usize, out: &mut [f64]) {
    let work = Work { cell, moduli, slice, out };
    #[cfg(target_arch = "x86_64")]
    if let Some(lanes) = pulp::x86::V3::try_new() {
        return lanes.vectorize(work);
    }
    work.run();
}

struct Work<'a> {
    cell: &'a Cell,
    moduli: &'a [PointTangent],
    slice: usize,
    out: &'a mut [f64],
}

impl pulp::NullaryFnOnce for Work<'_> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        self.run();
    }
}

impl Work<'_> {
    #[inline(always)]
    fn run(self) {
        let Self { cell, moduli, slice, out } = self;
        let width = cell.width;
        out.fill(0.0);
        for (number, &(first, end)) in cell.slices.iter().enumerate() {
            let points = number * slice;
            let mut arranged = [[[0.0; ROW]; 3]; MOST_IN_SLICE];
            for p in 0..slice {
                arrange(&moduli[points + p], cell.volumes[points + p], &mut arranged[p]);
            }
            let gradients = &cell.gradients[3 * points * width..][..3 * slice * width];
            for node in first as usize..(end as usize).min(cell.nodes.len()) {
                let mut left = [[0.0; ROW]; MOST_IN_SLICE];
                for p in 0..slice {
                    for j in 0..3 {
                        let g = gradients[(3 * p + j) * width + node];
                        for c in 0..ROW {
                            left[p][c] += g * arranged[p][j][c];
                        }
                    }
                }
                let rows = &mut out[9 * node * width..][..9 * width];
                let mut at = node / LANES * LANES;
                while at < end as usize {
                    multiply(&left[..slice], gradients, width, at, rows);
                    at += LANES;
                }
            }
        }
    }
}

/// `out_{3l + (3i + k)…}`: moduli times volume as rows j over `l`, then `3i + k`.
#[inline(always)]
fn arrange(moduli: &PointTangent, volume: f64, out: &mut [[f64; ROW]; 3]) {
    for j in 0..3 {
        for l in 0..3 {
            for i in 0..3 {
                for k in 0..3 {
                    out[j][9 * l + 3 * i + k] = volume * moduli[3 * i + j][3 * k + l];
                }
            }
        }
    }
}

/// Adds the products of one node with as many others as there are lanes, over the points of a slice.
#[inline(always)]
fn multiply(left: &[[f64; ROW]], gradients: &[f64], width: usize, at: usize, rows: &mut [f64]) {
    let mut sums = [[0.0; LANES]; 9];
    for (component, sum) in sums.iter_mut().enumerate() {
        sum.copy_from_slice(&rows[component * width + at..][..LANES]);
    }
    for (p, left) in left.iter().enumerate() {
        for l in 0..3 {
            let g: &[f64] = &gradients[(3 * p + l) * width + at..][..LANES];
            for component in 0..9 {
                let factor = left[9 * l + component];
                for lane in 0..LANES {
                    sums[component][lane] += factor * g[lane];
                }
            }
        }
    }
    for (component, sum) in sums.iter().enumerate() {
        rows[component * width + at..][..LANES].copy_from_slice(sum);
    }
}

/// Room for the matrix of one cell.
pub(crate) struct Scratch {
    moduli: Vec<PointTangent>,
    matrix: Vec<f64>,
}

impl Galerkin {
    /// Assembles the symmetric stiffness of all parameters at the present state and a level.
    pub(crate) fn assemble(&mut self, level: f64) {
        self.evaluate_internal(level);
        let points = self.space.points;
        if self.scratch.is_empty() {
            let widest = self.space.cells.iter().fold(0, |most, cell| most.max(cell.nodes.len() * cell.width));
            let room = || Scratch { moduli: vec![[[0.0; 9]; 9]; points], matrix: vec![0.0; 9 * widest] };
            self.scratch = (0..BATCH.min(self.space.cells.len())).map(|_| room()).collect();
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
        let size = 9 * cell.nodes.len() * cell.width;
        cell_stiffness(cell, &room.moduli, self.space.slice, &mut room.matrix[..size]);
    }

    /// Derivative of the stress of a point; where the update failed, that of its last sound state.
    pub(crate) fn moduli_of(&self, point: usize, kind: Tangent) -> PointTangent {
        let (from, trial) = (&self.history[point], &self.trials[point]);
        self.material.tangent(kind, from, trial).unwrap_or([[0.0; 9]; 9])
    }
}
