//! What conducts no heat.

use sph_core::SpaceError;

/// Why a surface conducts no heat.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ConductorError {
    /// The surface cannot be sampled, or an axis stands on it.
    #[error(transparent)]
    Space(#[from] SpaceError),
    /// Conductors that are not one a cell.
    #[error("{conductors} conductors for {cells} cells; heat is conducted by cells, each by its own")]
    Cells {
        /// Cells.
        cells: usize,
        /// Conductors.
        conductors: usize,
    },
    /// A cell that does not conduct heat in all directions.
    #[error(
        "cell {cell} must conduct heat in all directions, but its conductivity times thickness is {tensor:?}"
    )]
    Conductor {
        /// The cell.
        cell: usize,
        /// Its conductance along the axes and between them \[F L/(T Θ)\].
        tensor: [f64; 3],
    },
}
