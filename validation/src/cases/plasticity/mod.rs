//! Shells and solids that yield; a new case is a file, a line here, and one in the list.

mod balloon_inflating;
mod balloon_pumped;
mod bar_bonds_yielding;
mod bricks;
mod column_yielding;
mod cook_yielding;
mod cylinder_bursting;
mod cylinder_yielding;
mod disc_yielding;
mod hemisphere_yielding;
mod plate_yielding;
mod ring_struck;
mod roof_collapsing;
mod strip_cycled;
mod strip_fibre_metal;
mod strip_necking;
mod strip_springback;
mod tube_crushed;

use crate::judge::Case;

/// Every case, in the order of table and report.
pub fn all() -> [Case; 17] {
    [
        strip_necking::case(),
        strip_fibre_metal::case(),
        strip_springback::case(),
        strip_cycled::case(),
        tube_crushed::case(),
        hemisphere_yielding::case(),
        plate_yielding::case(),
        roof_collapsing::case(),
        cylinder_yielding::case(),
        column_yielding::case(),
        ring_struck::case(),
        cook_yielding::case(),
        disc_yielding::case(),
        balloon_inflating::case(),
        balloon_pumped::case(),
        cylinder_bursting::case(),
        bar_bonds_yielding::case(),
    ]
}
