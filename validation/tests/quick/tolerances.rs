//! The verdict on a quick set: every tolerance is kept, and every metric says why it has the tolerance or none.

use validation::{CaseResult, Record, Selection, Verdict};

use crate::Faults;

/// Metrics judged in a quick set, less a margin: one that judges fewer has lost cases.
const FEWEST_JUDGED: usize = 300;
/// A shorter reason is none.
const SHORTEST_REASON: usize = 20;

fn records(results: &[CaseResult]) -> impl Iterator<Item = &Record> {
    results.iter().flat_map(|result| &result.records)
}

/// Every metric that is off by more than it may be, and an exit code that does not say so.
pub fn missed(results: &[CaseResult]) -> Faults {
    let mut missed = Faults::new();
    for record in records(results) {
        for metric in record.metrics.iter().filter(|metric| !metric.pass) {
            missed.push(format!(
                "{}, {}: {} = {:?} {}, tolerance {:?}: {}",
                record.case,
                record.method,
                metric.name,
                metric.value,
                metric.unit,
                metric.tolerance,
                metric.reason
            ));
        }
    }
    let code = validation::exit_code(results);
    if code != 0 {
        missed.push(format!("the program would end with exit code {code}"));
    }
    missed
}

/// Every metric that does not say why it has its tolerance or none, and a set that judges too little.
pub fn without_reason(results: &[CaseResult]) -> Faults {
    let mut faults = Faults::new();
    let mut judged = 0;
    for record in records(results) {
        for metric in &record.metrics {
            judged += usize::from(metric.tolerance.is_some());
            let agree = metric.tolerance.is_none() == (metric.verdict == Verdict::Shown);
            if !agree || metric.reason.len() <= SHORTEST_REASON {
                faults.push(format!("{}, {}: {metric:?}", record.case, record.method));
            }
        }
    }
    if judged <= FEWEST_JUDGED {
        faults.push(format!("only {judged} metrics are judged at all"));
    }
    faults
}

/// Cases that the printed table or the HTML report do not show, and a report that is not whole or runs scripts.
pub fn left_out(selection: &Selection, results: &[CaseResult]) -> Faults {
    let table = validation::tables::table(results);
    let pages = match validation::report::pages(results, selection) {
        Ok(pages) => pages,
        Err(error) => return vec![format!("there is no report: {error}")],
    };
    let report: String = pages.iter().map(|page| page.html.as_str()).collect();
    let mut faults = Faults::new();
    for case in results.iter().map(|result| result.case.name) {
        if !table.contains(case) {
            faults.push(format!("{case} is not in the table\n{table}"));
        }
        if !report.contains(&format!("id='{case}'")) {
            faults.push(format!("{case} is not in the report"));
        }
    }
    if !report.ends_with("</html>\n") {
        faults.push("the report has no end".to_owned());
    }
    if report.contains("<script") {
        faults.push("the report holds a script".to_owned());
    }
    faults
}
