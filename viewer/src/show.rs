//! What a page is made of: bodies over their frames, and what is said beside them.

use serde::Serialize;

use crate::body::Body;

/// All that a page shows.
#[derive(Clone, Debug, Default)]
pub struct Show {
    /// One line that names the problem.
    pub title: String,
    /// What was run, one short line each.
    pub facts: Vec<String>,
    /// What may be wrong with a number, in words.
    pub warnings: Vec<String>,
    /// The scene as a text.
    pub scene: String,
    /// Columns of the curve.
    pub columns: Vec<Column>,
    /// Rows of the curve, each as long as `columns`.
    pub rows: Vec<Vec<f64>>,
    /// Columns that are drawn first: along, and up.
    pub plot: Option<[String; 2]>,
    /// The frames, in the order in which bodies were given theirs.
    pub frames: Vec<Instant>,
    /// Whether the frames are shapes without a size: they are drawn as large as can be seen.
    pub sizeless: bool,
    /// The bodies.
    pub bodies: Vec<Body>,
    /// Fields that are kept longest when a page would be too large, and of which the first one there is shown first.
    pub wanted: Vec<String>,
    /// Seconds after which the page loads itself again; none once the run has ended.
    pub reload: Option<f64>,
}

/// A column of the curve.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Column {
    /// Name.
    pub name: String,
    /// Unit; `-` without.
    pub unit: String,
}

/// Where a frame stands.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Instant {
    /// What the frames run along, ascending.
    pub along: f64,
    /// The same in words, with its unit.
    pub label: String,
    /// Row of the curve that belongs to it.
    pub row: Option<usize>,
}
