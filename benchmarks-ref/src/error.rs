//! What can go wrong when a reference is looked up, read as numbers, or compared with.

use thiserror::Error;

/// The errors of this crate; each names the value, the bound, and what to do about it.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ReferenceError {
    /// No entry of the catalogue has this name.
    #[error("no reference is named \"{name}\"; the catalogue holds: {known}")]
    UnknownReference {
        /// The name asked for.
        name: String,
        /// Every name there is, separated by commas.
        known: String,
    },
    /// A data file does not have the shape that the catalogue expects.
    #[error("the data file of reference \"{name}\" cannot be read: {reason}; repair data/{name}.json")]
    BadData {
        /// The entry of the catalogue.
        name: String,
        /// What the reader says, with line and column.
        reason: String,
    },
    /// The table has no such column.
    #[error("reference \"{reference}\" has no column \"{column}\"; its columns are: {known}")]
    UnknownColumn {
        /// The entry of the catalogue.
        reference: String,
        /// The column asked for.
        column: String,
        /// Every column there is, separated by commas.
        known: String,
    },
    /// The table has fewer rows.
    #[error("reference \"{reference}\" has no row {row}; its rows are 0 to {last}")]
    UnknownRow {
        /// The entry of the catalogue.
        reference: String,
        /// The row asked for, counted from 0.
        row: usize,
        /// The last row.
        last: usize,
    },
    /// A cell holds text or nothing where a number was asked for.
    #[error(
        "reference \"{reference}\", column \"{column}\", row {row} holds {found}, not a number; \
         read single cells with `number` or choose another column"
    )]
    NotANumber {
        /// The entry of the catalogue.
        reference: String,
        /// The column asked for.
        column: String,
        /// The row, counted from 0.
        row: usize,
        /// What stands there, as JSON.
        found: String,
    },
    /// Abscissae and ordinates do not pair up.
    #[error("a curve needs as many x as y and at least two points, got {x} x and {y} y")]
    BadLength {
        /// The number of abscissae.
        x: usize,
        /// The number of ordinates.
        y: usize,
    },
    /// The abscissae turn back, stand still, or a value is not finite.
    #[error(
        "a curve needs finite values and growing x, but point {index} is ({x}, {y}) after x = {previous}; \
         cut the curve where it turns, or choose an abscissa that grows"
    )]
    NotGrowing {
        /// The offending point, counted from 0.
        index: usize,
        /// Its abscissa.
        x: f64,
        /// Its ordinate.
        y: f64,
        /// The abscissa before it.
        previous: f64,
    },
    /// An abscissa lies outside of the curve.
    #[error(
        "x = {x} lies outside of the curve, which spans {first} to {last}; narrow the range or compute further"
    )]
    OutOfRange {
        /// The abscissa asked for.
        x: f64,
        /// The first abscissa of the curve.
        first: f64,
        /// The last abscissa of the curve.
        last: f64,
    },
    /// No abscissa of the curve lies within the range asked for.
    #[error(
        "no point of the curve, which spans {first} to {last}, lies within the range asked for; widen the range"
    )]
    EmptyRange {
        /// The first abscissa of the curve.
        first: f64,
        /// The last abscissa of the curve.
        last: f64,
    },
    /// The extreme value stands at an edge, where the curve may still be rising or falling.
    #[error(
        "the {kind} stands at the edge x = {x} (y = {y}) of the range: the curve does not turn inside; \
         choose a range that holds the turning point and its neighbours"
    )]
    ExtremumAtEdge {
        /// "maximum" or "minimum".
        kind: &'static str,
        /// The abscissa of the edge.
        x: f64,
        /// The ordinate there.
        y: f64,
    },
    /// A Green–Lagrange strip cannot carry this moment.
    #[error(
        "no equilibrium: M t/(E I) = {ratio} exceeds {bound}, the most that the strip carries; lower M or t"
    )]
    MomentTooLarge {
        /// M t/(E I), without dimension.
        ratio: f64,
        /// 2√2/3.
        bound: f64,
    },
}
