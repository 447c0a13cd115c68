//! The cases, one file each, in a folder for each kind of body.

pub mod option_cost;

mod contact;
mod coupled;
mod finer;
mod fluid;
mod forecast;
mod forecast_solids;
mod galerkin;
mod growth;
mod hard;
mod plasticity;
mod shell;
mod solid;

use crate::Case;

/// Every usual case, in the order of table and report.
pub fn usual() -> Vec<Case> {
    let mut cases = shell::all();
    cases.extend(family("Contact", contact::all()));
    cases.extend(family("Plasticity", plasticity::all()));
    cases.extend(solid::all());
    cases.extend(family("Galerkin solids", galerkin::all()));
    cases.extend(family("Fluids", fluid::all()));
    cases.extend(family("Fluids and structures", coupled::all()));
    cases.extend(family(
        "Cost",
        [forecast::case(), forecast_solids::case(), growth::case(), option_cost::case()],
    ));
    cases
}

/// Cases of one family, whose errors are drawn against their costs in one figure.
fn family(name: &'static str, cases: impl IntoIterator<Item = Case>) -> impl Iterator<Item = Case> {
    cases.into_iter().map(move |case| Case { family: name, ..case })
}

/// The hard cases, in the order of the survival table.
pub fn hard() -> Vec<Case> {
    family("Hard cases", hard::all()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    use crate::Variant;

    #[test]
    fn cases_and_their_runs_can_be_distinguished_apart() {
        let mut names = BTreeSet::new();
        for case in usual().into_iter().chain(hard()) {
            assert!(names.insert(case.name), "two cases are called {}", case.name);
            let mut runs = BTreeSet::new();
            for Variant { method, grid, .. } in &case.variants {
                let fresh = runs.insert((method.clone(), grid.clone()));
                assert!(fresh, "{}: two runs are called {method} {grid}", case.name);
            }
        }
    }

    #[test]
    fn the_list_says_in_a_line_what_each_case_proves() {
        let cases: Vec<Case> = usual().into_iter().chain(hard()).collect();
        let list = crate::tables::list(&cases);
        assert_eq!(list.lines().count(), cases.len(), "{list}");
        for (line, Case { name, title, citation, headline, .. }) in list.lines().zip(&cases) {
            let said = [Some(*title), Some(*citation), headline.map(|headline| headline.metric)];
            let whole = said.into_iter().flatten().all(|word| !word.trim().is_empty() && line.contains(word));
            assert!(whole && line.starts_with(name), "{name} does not say what it proves: {line}");
        }
    }

    #[test]
    fn what_is_asked_is_measured_and_what_is_known_is_asked() {
        for case in usual().into_iter().chain(hard()) {
            for Variant { method, grid, off, asked, known, .. } in &case.variants {
                let whole = off.is_some() == asked.is_some() && (known.is_none() || asked.is_some());
                assert!(whole, "{}: {method} {grid}", case.name);
            }
        }
    }
}
