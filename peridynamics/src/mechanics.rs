//! What resists: bonds between nodes, or two sheets of bonds on directors.

use crate::bonds::network::Row;

/// The stored energy of a body as a function of its rows, and how bonds break.
pub(crate) trait Mechanics: Send {
    /// Internal forces `∂U/∂row` of all rows; returns the stored energy \[F L\], zero unless wanted.
    ///
    /// The last places of the rows are the mechanics' own. With `watch` it notes the bonds beyond their limit, for
    /// [`Mechanics::break_bonds`].
    fn evaluate(&mut self, rows: &mut [Row], forces: &mut [Row], wanted: Evaluation) -> f64;

    /// Second derivatives at `rows` times the displacements `along`, into `out`; the last places of all are its own. False,
    /// with nothing done, where a mechanics has forces alone.
    fn tangent(&mut self, _rows: &mut [Row], _along: &mut [Row], _out: &mut [Row], _threads: usize) -> bool {
        false
    }

    /// Breaks the bonds noted in the last evaluation; returns the energy they held \[F L\].
    fn break_bonds(&mut self) -> f64;

    /// Memory of the bonds \[bytes\].
    fn bytes(&self) -> usize;

    /// Directed bonds.
    fn bonds(&self) -> usize;
}

/// What an evaluation does.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Evaluation {
    /// Whether the stored energy is summed.
    pub energy: bool,
    /// Whether bonds are held against their limits.
    pub watch: bool,
    /// Threads, at least one.
    pub threads: usize,
}
