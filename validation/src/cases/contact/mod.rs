//! Shells that touch tools or themselves; a new case is a file, a line here, and one in the list.

mod collapsed_ring;
mod pressed_ring;
mod wrapped_strip;

use crate::judge::Case;

/// Every case, in the order of table and report.
pub fn all() -> [Case; 3] {
    [pressed_ring::case(), wrapped_strip::case(), collapsed_ring::case()]
}
