//! Cells that conduct by their temperature: a factor of their matrix, that of the mean of their corners.
//!
//! Between two particles of a bar a conductivity that is linear in the temperature lets through `∫ k dT`, which is that of the mean times the difference: there
//! Kirchhoff's transform is met to rounding \[carslaw1959\].

use explicit_dynamics::Amplitude;

use super::cells::CellMatrix;
use super::{Cells, ConductionError};

/// Tables of factors, and which cell has which.
#[derive(Clone, Debug, Default)]
pub(super) struct Tables {
    tables: Vec<Vec<[f64; 2]>>,
    /// Number of the table of each cell, one up; empty where no cell has one.
    of_cell: Vec<u32>,
}

impl Tables {
    /// Gives some of so many cells a table.
    pub fn put(&mut self, cells: &[u32], table: Vec<[f64; 2]>, count: usize) {
        self.tables.push(table);
        self.of_cell.resize(count, 0);
        cells.iter().for_each(|&cell| self.of_cell[cell as usize] = self.tables.len() as u32);
    }

    /// Whether no cell has one.
    pub fn is_empty(&self) -> bool {
        self.tables.is_empty()
    }

    fn of(&self, cell: usize) -> Option<&[[f64; 2]]> {
        let number = (*self.of_cell.get(cell)? as usize).checked_sub(1)?;
        self.tables.get(number).map(Vec::as_slice)
    }
}

fn mean(cell: &CellMatrix, values: &[f64]) -> f64 {
    let own = &cell.nodes[..cell.count];
    own.iter().map(|&a| values[a as usize]).sum::<f64>() / own.len() as f64
}

impl Cells {
    /// The factor by which a cell conducts at temperatures of nodes; beyond the ends of its table, where iterations may come, that of the end.
    pub(super) fn conducts(&self, cell: usize, values: &[f64]) -> f64 {
        let Some(table) = self.tables.of(cell) else { return 1.0 };
        Amplitude::along(table, mean(&self.cells[cell], values))
    }

    /// Refuses cells whose temperature is in no table.
    pub(super) fn refuse_other_temperatures(&self, values: &[f64]) -> Result<(), ConductionError> {
        for (cell, own) in self.cells.iter().enumerate() {
            let table = self.tables.of(cell).unwrap_or_default();
            let (Some(first), Some(last)) = (table.first(), table.last()) else { continue };
            let temperature = mean(own, values);
            if temperature < first[0] || temperature > last[0] {
                return Err(ConductionError::Table { cell, temperature, ends: [first[0], last[0]] });
            }
        }
        Ok(())
    }
}
