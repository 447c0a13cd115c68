//! Why a body could not be built.

use sph_core::{HexahedraError, ShapeError};

/// A body that was refused before anything ran.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum GalerkinError {
    /// No shape functions at a point.
    #[error(transparent)]
    Shape(#[from] ShapeError),
    /// No background cells.
    #[error(transparent)]
    Cells(#[from] HexahedraError),
    /// Points that are not those of the cells.
    #[error(
        "{cells} background cells take {each} points each, the cube of 1 to 4, with volumes that are not negative, and each node a share of them"
    )]
    Points {
        /// Number of cells.
        cells: usize,
        /// Points of each.
        each: usize,
    },
    /// A number that is not finite.
    #[error("{what} {number} is {value}; it must be finite")]
    NotFinite {
        /// Of what.
        what: &'static str,
        /// Its number, from 0.
        number: usize,
        /// The value.
        value: f64,
    },
    /// Two nodes at one place.
    #[error("nodes {0} and {1} coincide; remove one of them")]
    Coincident(u32, u32),
    /// A density that is none.
    #[error("the density is {0}; it must be positive")]
    Density(f64),
    /// Flow of a law without memory.
    #[error(
        "a material that yields goes by increments, and St Venant's law has none; use increments of strain and rotation"
    )]
    FlowWithoutSteps,
    /// Material axes that are no triad.
    #[error("the material axes are {0:.1e} from orthonormal; give three perpendicular unit vectors")]
    Axes(f64),
    /// A set without members.
    #[error("{0} acts on an empty set; name one that holds at least one member")]
    EmptySet(&'static str),
    /// A node number beyond the body.
    #[error("{what} names node {node}, but the body has {count} nodes (numbered from 0)")]
    NoSuchNode {
        /// Who named it.
        what: &'static str,
        /// The number.
        node: u32,
        /// Nodes of the body.
        count: usize,
    },
    /// A direction without length.
    #[error("a held direction has length {0}; it must be positive and finite")]
    Direction(f64),
    /// Conditions that depend on each other and ask for different values.
    #[error(
        "node {node} is prescribed to move by {wanted:.6e} at level one, but other conditions leave it {left:.6e} from there; remove one of them"
    )]
    Contradiction {
        /// A node of the condition.
        node: u32,
        /// The displacement asked for \[L\].
        wanted: f64,
        /// What is missing \[L\].
        left: f64,
    },
}
