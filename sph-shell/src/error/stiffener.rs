//! What is no stiffener.

/// Why a stiffener makes no sense, with its number.
#[derive(Clone, Debug, thiserror::Error)]
pub enum StiffenerError {
    /// Stiffeners where strains are not sampled in cells.
    #[error("a stiffener wants strains sampled in cells; use the formulation by cells")]
    WideStencils,
    /// A particle with no neighbour on the line.
    #[error(
        "particle {particle} of the stiffener stands alone: no cell has an edge from it to another of the set; take in the particles between, or leave it out"
    )]
    Alone {
        /// Number of the stiffener.
        number: usize,
        /// The particle.
        particle: u32,
    },
    /// All corners of a cell.
    #[error(
        "the stiffener has all corners of cell {cell}: it is no line there; take one row of particles, or give the cells a section of their own"
    )]
    CoversCell {
        /// Number of the stiffener.
        number: usize,
        /// The cell.
        cell: usize,
    },
    /// Two pieces on one place.
    #[error(
        "the stiffener runs twice between the places of particles {} and {}, on two sheets that meet there; take the particles of one of them", .ends[0], .ends[1]
    )]
    Twice {
        /// Number of the stiffener.
        number: usize,
        /// Ends of the piece on one of the sheets.
        ends: [u32; 2],
    },
    /// A centroid line beyond the centre of curvature.
    #[error(
        "the stiffener lies {height:.4e} over its particles and reaches the centre of curvature of their line between particles {} and {}; lay it nearer to the surface, or on the other side", .ends[0], .ends[1]
    )]
    BeyondCentre {
        /// Number of the stiffener.
        number: usize,
        /// Particles between which it does.
        ends: [u32; 2],
        /// Height over the particles \[L\].
        height: f64,
    },
    /// A line that is none where it bends in the surface.
    #[error(
        "the stiffener bends in the surface, and more than two of its pieces meet at particle {particle}, so that it has no one turn there; give each line a stiffener of its own"
    )]
    Forks {
        /// Number of the stiffener.
        number: usize,
        /// The particle.
        particle: u32,
    },
    /// A corner of it.
    #[error(
        "the stiffener bends in the surface, and its line has a corner of more than 45° at particle {particle}; end it there and begin another, or take finer cells along the curve"
    )]
    Corner {
        /// Number of the stiffener.
        number: usize,
        /// The particle.
        particle: u32,
    },
    /// A particle where its direction is to be held that is no end.
    #[error(
        "the direction of the stiffener is held at particle {particle}, which is no end of its line; name sets that have ends of it alone"
    )]
    NoEnd {
        /// Number of the stiffener.
        number: usize,
        /// The particle.
        particle: u32,
    },
    /// A number that is none.
    #[error("{what} of the stiffener is {value}; it must be positive and finite")]
    Number {
        /// Number of the stiffener.
        number: usize,
        /// What it is.
        what: &'static str,
        /// Its value.
        value: f64,
    },
}

impl StiffenerError {
    /// Number of the stiffener.
    pub fn number(&self) -> usize {
        match *self {
            Self::WideStencils => 0,
            Self::Alone { number, .. }
            | Self::CoversCell { number, .. }
            | Self::Twice { number, .. }
            | Self::BeyondCentre { number, .. }
            | Self::Forks { number, .. }
            | Self::Corner { number, .. }
            | Self::NoEnd { number, .. }
            | Self::Number { number, .. } => number,
        }
    }
}
