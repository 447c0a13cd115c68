//! Shells that touch tools, themselves and each other; a new case is a file, a line here, and one in the list.

mod capstan;
mod collapsed_ring;
mod incline;
mod pressed_ring;
mod two_cantilevers;
mod wrapped_strip;

use crate::judge::Case;

/// Every case, in the order of table and report.
pub fn all() -> [Case; 6] {
    let [strips, rough] = [wrapped_strip::case(), capstan::case()];
    [pressed_ring::case(), strips, collapsed_ring::case(), two_cantilevers::case(), rough, incline::case()]
}
