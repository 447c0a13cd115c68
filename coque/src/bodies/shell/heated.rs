//! What heat is put on: a shell with its sets.

use sph_core::{Cloud, EndWeights};

use super::cells::CellSets;
use super::imported::Imported;
use crate::bodies::sets::Sets;

/// A shell on which heat is put.
#[derive(Clone, Copy)]
pub(super) struct Heated<'a> {
    /// Not turned yet.
    pub flat: &'a Cloud,
    pub cloud: &'a Cloud,
    pub sets: &'a Sets,
    pub cells: &'a CellSets<'a>,
    pub imported: Option<&'a Imported>,
    pub weights: EndWeights,
}
