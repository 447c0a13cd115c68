//! The quick set, run once and held against everything that is asked of it.
//!
//! One test, since a runner that gives each test a process of its own would run the set once for each. All that is
//! wrong is told at the end: missed tolerances, changed snapshots, and the rest.

mod snapshots;
mod tolerances;

use validation::{CaseResult, Effort, Selection, cases, judge};

/// What is wrong with the results, one line or paragraph each.
type Faults = Vec<String>;
/// Looks for one kind of fault.
type Check = fn(&[CaseResult]) -> Faults;

#[test]
fn the_quick_set_keeps_its_tolerances_and_stays_as_it_was_reviewed() {
    let jobs = std::thread::available_parallelism().map_or(1, usize::from);
    let selection = Selection { set: Effort::Quick, hard: false, names: Vec::new(), jobs };
    let results = match judge(cases::usual(), &selection, &|_| {}) {
        Ok(results) => results,
        Err(error) => panic!("{error}"),
    };
    let checks: [(&str, Check); 4] = [
        ("a metric misses its tolerance", tolerances::missed),
        ("a metric does not say why it has its tolerance or none", tolerances::without_reason),
        ("table or report leave something out", tolerances::left_out),
        ("results are not as they were reviewed", snapshots::changed),
    ];
    let mut told = String::new();
    for (what, check) in checks {
        for fault in check(&results) {
            told += &format!("{what}: {fault}\n");
        }
    }
    assert!(told.is_empty(), "{told}");
}
