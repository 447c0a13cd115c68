//! The free temperatures as unknowns of a sparse matrix.

use implicit_statics::SymmetricSolver;

use super::given::Given;
use super::{Conduction, ConductionError};

/// Where each free node stands among the unknowns, and each entry of a cell in the pattern.
pub(super) struct System {
    /// The nodes of the unknowns.
    pub free: Vec<u32>,
    /// Unknown of each node, one up; zero of those that are held or none.
    unknown: Vec<u32>,
    pattern: Vec<(usize, usize)>,
    pub solver: SymmetricSolver,
}

impl System {
    /// Orders and analyses the matrix of the free nodes.
    ///
    /// # Errors
    /// [`ConductionError::Balance`] for a pattern that cannot be analysed; none is known.
    pub fn new(of: &Conduction) -> Result<Self, ConductionError> {
        let mut used = vec![false; of.node.len()];
        of.cells.iter().flat_map(|cell| &cell.nodes[..cell.count]).for_each(|&a| used[a as usize] = true);
        let is_free = |a: &u32| used[*a as usize] && of.given.held[*a as usize].is_none();
        let free: Vec<u32> = (0..of.node.len() as u32).filter(is_free).collect();
        let mut unknown = vec![0; of.node.len()];
        (1..).zip(&free).for_each(|(number, &a)| unknown[a as usize] = number);
        let mut pattern: Vec<(usize, usize)> = (0..free.len()).map(|i| (i, i)).collect();
        let pairs = of.cells.iter().flat_map(|cell| {
            let own = &cell.nodes[..cell.count];
            own.iter().flat_map(move |&a| own.iter().map(move |&b| (a, b)))
        });
        pattern.extend(pairs.filter_map(|(a, b)| {
            let [row, column] = [a, b].map(|a| (unknown[a as usize] as usize).checked_sub(1));
            row.zip(column).filter(|(row, column)| row > column)
        }));
        pattern.sort_unstable();
        pattern.dedup();
        let solver = SymmetricSolver::new(free.len(), &pattern)?;
        Ok(Self { free, unknown, pattern, solver })
    }

    /// Factorises what heat does at these temperatures, times a factor, with so much more on the diagonal of each node.
    ///
    /// # Errors
    /// [`ConductionError::Balance`] for a matrix that is not finite.
    pub fn factor(
        &mut self,
        of: &Conduction,
        given: &Given,
        temperatures: &[f64],
        factor: f64,
        more: impl Fn(usize) -> f64,
    ) -> Result<(), ConductionError> {
        let mut values = vec![0.0; self.pattern.len()];
        let slot = |row: usize, column: usize| self.pattern.binary_search(&(row, column)).ok();
        let unknown = |a: u32| (self.unknown[a as usize] as usize).checked_sub(1);
        for (c, cell) in of.cells.iter().enumerate() {
            let factor = factor * of.conducts(c, temperatures);
            for a in 0..cell.count {
                for b in 0..cell.count {
                    let found = unknown(cell.nodes[a]).zip(unknown(cell.nodes[b]));
                    let found = found.filter(|(row, column)| row >= column);
                    if let Some(at) = found.and_then(|(row, column)| slot(row, column)) {
                        values[at] += factor * cell.entries[a][b];
                    }
                }
            }
        }
        let surface = given.surface_slopes(temperatures);
        for (row, &a) in self.free.iter().enumerate() {
            if let Some(at) = slot(row, row) {
                values[at] += factor * surface[a as usize] + more(a as usize);
            }
        }
        self.solver.factor(&values)?;
        Ok(())
    }
}
