//! The quick sets, usual and hard, run once each and held against everything that is asked of them.
//!
//! One test a set, since a runner that gives each test a process of its own would run the set once for each. All that
//! is wrong is reported at the end: missed tolerances, changed snapshots, and the rest.

mod snapshots;
mod tolerances;

use std::error::Error;
use std::fs;
use std::path::Path;

use validation::{Case, CaseResult, Effort, Selection, cases, judge, report};

/// What is wrong with the results, one line or paragraph each.
type Faults = Vec<String>;
/// Looks for one kind of fault.
type Check = fn(&[CaseResult]) -> Faults;

const MISSED: (&str, Check) = ("a metric misses its tolerance", tolerances::missed);
const WITHOUT_REASON: (&str, Check) =
    ("a metric does not say why it has its tolerance or none", tolerances::without_reason);
const CHANGED: (&str, Check) = ("results are not as they were reviewed", snapshots::changed);

#[test]
fn the_quick_set_keeps_its_tolerances_and_stays_as_it_was_reviewed() {
    held_against(cases::usual(), false, &[MISSED, WITHOUT_REASON, CHANGED]);
}

/// Hard cases have no snapshots: what they find is often how a method fails, and the last digits of that are noise.
#[test]
fn the_quick_hard_set_keeps_its_tolerances() {
    held_against(cases::hard(), true, &[MISSED, WITHOUT_REASON]);
}

fn held_against(cases: Vec<Case>, hard: bool, checks: &[(&str, Check)]) {
    let jobs = std::thread::available_parallelism().map_or(1, usize::from);
    let selection = Selection { set: Effort::Quick, hard, names: Vec::new(), jobs, pages: false };
    let results = match judge(cases, &selection, &|_| {}) {
        Ok(results) => results,
        Err(error) => panic!("{error}"),
    };
    let mut reported = String::new();
    if let Err(error) = keep_report(&results, &selection) {
        reported += &format!("the report could not be kept: {error}\n");
    }
    for (what, check) in checks {
        for fault in check(&results) {
            reported += &format!("{what}: {fault}\n");
        }
    }
    for fault in tolerances::left_out(&selection, &results) {
        reported += &format!("table or report leave something out: {fault}\n");
    }
    assert!(reported.is_empty(), "{reported}");
}

/// Leaves the report of a set in target/quick-report or target/quick-hard-report, where a failure can be looked at.
fn keep_report(results: &[CaseResult], selection: &Selection) -> Result<(), Box<dyn Error>> {
    let name = if selection.hard { "quick-hard-report" } else { "quick-report" };
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../target").join(name);
    fs::create_dir_all(&folder)?;
    for page in report::pages(results, selection)? {
        fs::write(folder.join(page.file), page.html)?;
    }
    Ok(())
}
