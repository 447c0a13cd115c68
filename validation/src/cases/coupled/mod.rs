//! Fluids against structures; a new case is a file or folder, a line here, and one in the list.

mod baffle;
pub mod column;
mod gate;
pub mod measure;
mod plate;
mod ring;
mod square;
mod wedge;

use crate::Case;

/// Every case, in the order of table and report.
pub fn all() -> Vec<Case> {
    vec![
        column::case(),
        ring::case(),
        square::case(),
        gate::case(),
        plate::case(),
        wedge::case(),
        baffle::case(),
    ]
}
