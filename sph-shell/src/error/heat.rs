//! What cannot be heated.

/// Why a change of temperature makes no sense, with its number.
#[derive(Clone, Debug, thiserror::Error)]
pub enum HeatError {
    /// A section that does not say how it expands.
    #[error(
        "cell {cell} is heated and its material has no coefficient of expansion; give one to the material, of plies to each of theirs, or leave the cell out"
    )]
    NoExpansion {
        /// Number of the change.
        number: usize,
        /// The cell.
        cell: u32,
    },
    /// Changes that are not one a cell, or not finite.
    #[error("change of temperature {number} needs two finite numbers for each of its cells")]
    Changes {
        /// Number of the change.
        number: usize,
    },
    /// Heat where strains are not sampled in cells.
    #[error("a change of temperature wants strains sampled in cells; use the formulation by cells")]
    WideStencils,
}

impl HeatError {
    /// Number of the change.
    pub fn number(&self) -> usize {
        match *self {
            Self::NoExpansion { number, .. } | Self::Changes { number } => number,
            Self::WideStencils => 0,
        }
    }
}
