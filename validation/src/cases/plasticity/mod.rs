//! Shells and solids that yield; a new case is a file, a line here, and one in the list.

mod bricks;
mod cylinder_bursting;
mod cylinder_yielding;
mod hemisphere_yielding;
mod plate_yielding;
mod roof_collapsing;
mod strip_necking;
mod strip_springback;

use crate::judge::Case;

/// Every case, in the order of table and report.
pub fn all() -> [Case; 7] {
    [
        strip_necking::case(),
        strip_springback::case(),
        hemisphere_yielding::case(),
        plate_yielding::case(),
        roof_collapsing::case(),
        cylinder_yielding::case(),
        cylinder_bursting::case(),
    ]
}
