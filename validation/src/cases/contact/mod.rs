//! Shells, solids and rigid bodies that touch tools, themselves and each other; a new case is a file, a line here, and one in the list.

mod cantilever_on_flat;
mod capstan;
mod collapsed_ring;
mod dropped;
mod flap_on_sill;
mod fold_pressed;
mod hemisphere_on_flat;
mod incline;
mod let_go;
mod linked;
mod pressed_blocks;
mod pressed_ring;
mod strip_lifted;
mod touched_modes;
mod two_cantilevers;
mod wrapped_strip;

use crate::judge::Case;

/// Every case, in the order of table and report.
pub fn all() -> [Case; 16] {
    [
        pressed_ring::case(),
        fold_pressed::case(),
        cantilever_on_flat::case(),
        strip_lifted::case(),
        hemisphere_on_flat::case(),
        wrapped_strip::case(),
        collapsed_ring::case(),
        two_cantilevers::case(),
        capstan::case(),
        incline::case(),
        let_go::case(),
        touched_modes::case(),
        flap_on_sill::case(),
        pressed_blocks::case(),
        dropped::case(),
        linked::case(),
    ]
}
