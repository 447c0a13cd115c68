//! Peridynamic solids and plates; a new case is a file, a line here, and one in the list.

mod bar;
mod double_cantilever;
mod hole;
mod moduli;
mod plate_post_buckling;
mod plate_stability;

use crate::Case;

/// Every case, in the order of table and report.
pub fn all() -> Vec<Case> {
    vec![
        moduli::case(),
        bar::case(),
        hole::case(),
        double_cantilever::case(),
        plate_stability::case(),
        plate_post_buckling::case(),
    ]
}
