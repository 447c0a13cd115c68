//! Structures that stand in fluids: first alone, then in the fluid; a new case is a file, a line here, and one in the list.

mod clamped_strip;
mod gate_alone;
mod turek_hron;

use crate::Case;

/// Every case, in the order of table and report.
pub fn all() -> Vec<Case> {
    vec![clamped_strip::case(), turek_hron::case(), gate_alone::case()]
}
