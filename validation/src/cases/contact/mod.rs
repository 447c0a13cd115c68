//! Shells that touch tools; a new case is a file, a line here, and one in the list.

mod capstan;
mod incline;
mod pressed_ring;
mod wrapped_strip;

use crate::judge::Case;

/// Every case, in the order of table and report.
pub fn all() -> [Case; 4] {
    [pressed_ring::case(), wrapped_strip::case(), capstan::case(), incline::case()]
}
