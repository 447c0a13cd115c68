//! The verdict on the quick set: every metric that has a tolerance keeps to it, and every tolerance has a reason.

#[test]
fn every_quick_metric_keeps_to_its_tolerance() {
    let mut missed = Vec::new();
    for record in crate::quick().iter().flat_map(|result| &result.records) {
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
    assert!(missed.is_empty(), "{}", missed.join("\n"));
    assert_eq!(validation::run::exit_code(crate::quick()), 0);
}

#[test]
fn every_tolerance_says_where_it_comes_from() {
    let metrics = crate::quick().iter().flat_map(|result| &result.records).flat_map(|record| &record.metrics);
    let judged: Vec<_> = metrics.filter(|metric| metric.tolerance.is_some()).collect();
    assert!(judged.len() > 30, "only {} metrics are judged", judged.len());
    for metric in judged {
        assert!(metric.reason.len() > 20, "{}: {}", metric.name, metric.reason);
    }
}

#[test]
fn the_table_and_the_report_hold_every_case() {
    let results = crate::quick();
    let table = validation::table::table(results);
    let selection = validation::Selection { quick: true, hard: false, names: Vec::new(), jobs: 1 };
    let report = validation::report::html(results, &selection).unwrap_or_default();
    for result in results {
        assert!(table.contains(result.case.name), "{table}");
        assert!(report.contains(&format!("id='{}'", result.case.name)));
    }
    assert!(report.ends_with("</html>\n") && !report.contains("<script"));
}
