//! Peridynamic solids and plates; a new case is a file, a line here, and one in the list.

mod bar;
mod branching;
mod double_cantilever;
mod drift;
mod falling_bar;
mod hole;
mod hollow_ball;
mod kalthoff;
mod measure;
mod mode_one;
mod moduli;
mod plate_branches;
mod plate_cracked;
mod plate_lattice;
mod plate_post_buckling;
mod plate_stability;
mod plate_tear;
mod smooth_box;
mod strip;
mod thin_plate;
mod torsion;
mod warm_strip;
mod wave;

use super::{family, finer};
use crate::Case;
use crate::methods::STATE;

/// Every case, in the order of table and report.
pub fn all() -> Vec<Case> {
    let mut cases = Vec::new();
    cases.extend(family(
        "Peridynamic solids",
        [
            moduli::case(),
            strip::case(),
            bar::case(),
            hole::case(),
            hollow_ball::case(),
            double_cantilever::case(),
            wave::case(),
            torsion::case(),
            warm_strip::case(),
            drift::case(),
            smooth_box::case(),
            falling_bar::case(),
            finer::stub_of_bonds(STATE),
            finer::pulled_hole(STATE),
        ],
    ));
    cases.extend(family(
        "Cracks in peridynamic solids",
        [mode_one::case(), branching::case(), kalthoff::case()],
    ));
    cases.extend(family(
        "Peridynamic plates",
        [
            plate_stability::case(),
            plate_branches::case(),
            plate_lattice::case(),
            plate_post_buckling::case(),
            plate_cracked::case(),
            plate_tear::case(),
        ],
    ));
    cases
}
