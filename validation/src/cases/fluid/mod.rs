//! Fluids by themselves; a new case is a file, a line here, and one in the list.

mod basin;
mod between_plates;
mod channel_with_inflow;
mod couette;
pub mod dam_break;
mod drop;
mod obstacle;
mod open_channel;
mod speed;
mod still_water;
mod tilted_basin;
mod wall_impact;

use super::finer;
use crate::Case;
use crate::support::fluids::KICKS;

/// Every case, in the order of table and report.
pub fn all() -> Vec<Case> {
    vec![
        still_water::case(),
        basin::case(),
        drop::case(),
        couette::case(),
        between_plates::case(),
        dam_break::case(),
        wall_impact::case(),
        obstacle::case(),
        speed::case(),
        tilted_basin::case(),
        open_channel::case(),
        channel_with_inflow::case(),
        finer::collapsing_column(KICKS),
    ]
}
