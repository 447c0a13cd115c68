//! Tests on the quick set, which is run once for all of them.

mod snapshots;
mod tolerances;

use std::sync::OnceLock;

use validation::{CaseResult, Selection, judge};

/// Results of the quick set.
fn quick() -> &'static [CaseResult] {
    static RESULTS: OnceLock<Vec<CaseResult>> = OnceLock::new();
    RESULTS.get_or_init(|| {
        let jobs = std::thread::available_parallelism().map_or(1, usize::from);
        match judge(&Selection { quick: true, hard: false, names: Vec::new(), jobs }, &|_| {}) {
            Ok(results) => results,
            Err(error) => panic!("{error}"),
        }
    })
}
