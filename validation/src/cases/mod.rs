//! The list of cases; a new one is a file and two lines here.

mod buckling;
mod cantilever_end_shear;
mod clamped_cap;
pub(crate) mod dial;
mod external_pressure;
mod hard;
mod hemisphere;
mod hemisphere_large;
mod linear;
mod open_cylinder;
mod option_cost;
mod panel;
mod panel_figures;
mod panel_laminated;
mod panel_snap_back;
mod patch_test;
mod path;
mod pinched_cylinder;
mod pinched_cylinder_large;
mod plate;
mod plate_frequencies;
mod point_load_smoothness;
mod ring;
mod ring_green_lagrange;
mod scordelis_lo;
mod strip;
mod thin_ring;
mod turned;
mod twisted_beam;

use crate::Case;
pub use hard::ERROR;

/// Every case, in the order of table and report.
pub fn all() -> Vec<Case> {
    vec![
        ring::case(),
        ring_green_lagrange::case(),
        thin_ring::case(),
        cantilever_end_shear::case(),
        panel::case(),
        panel_snap_back::case(),
        panel_laminated::case(),
        scordelis_lo::case(),
        pinched_cylinder::case(),
        hemisphere::case(),
        twisted_beam::case(),
        plate::case(),
        plate_frequencies::case(),
        buckling::case(),
        clamped_cap::case(),
        external_pressure::case(),
        hemisphere_large::case(),
        open_cylinder::case(),
        pinched_cylinder_large::case(),
        point_load_smoothness::case(),
        turned::case(),
        patch_test::case(),
        option_cost::case(),
    ]
}

/// The hard cases, in the order of the survival table.
pub fn hard() -> Vec<Case> {
    hard::all()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn cases_and_their_runs_can_be_told_apart() {
        let mut names = BTreeSet::new();
        for case in all().into_iter().chain(hard()) {
            assert!(names.insert(case.name), "two cases are called {}", case.name);
            let mut runs = BTreeSet::new();
            for variant in &case.variants {
                assert!(
                    runs.insert((variant.method.clone(), variant.grid.clone())),
                    "{}: two runs are called {} {}",
                    case.name,
                    variant.method,
                    variant.grid
                );
            }
        }
    }
}
