//! Shells that touch tools, themselves and each other; a new case is a file, a line here, and one in the list.

mod capstan;
mod incline;
mod pressed_ring;
mod two_cantilevers;
mod wrapped_strip;

use crate::judge::Case;

/// Every case, in the order of table and report.
pub fn all() -> [Case; 5] {
    [pressed_ring::case(), wrapped_strip::case(), two_cantilevers::case(), capstan::case(), incline::case()]
}
