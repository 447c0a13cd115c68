//! The list of cases; a new one is a file and two lines here.

mod cantilever_end_shear;
pub(crate) mod dial;
mod panel;
mod panel_figures;
mod patch_test;
mod point_load_smoothness;
mod ring;
mod ring_green_lagrange;
mod strip;
mod thin_ring;
mod turned;

use crate::Case;

/// Every case, in the order of table and report.
pub fn all() -> Vec<Case> {
    vec![
        ring::case(),
        ring_green_lagrange::case(),
        thin_ring::case(),
        cantilever_end_shear::case(),
        panel::case(),
        point_load_smoothness::case(),
        turned::case(),
        patch_test::case(),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn cases_and_their_runs_can_be_told_apart() {
        let mut names = BTreeSet::new();
        for case in all() {
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
