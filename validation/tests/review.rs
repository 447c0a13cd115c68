//! The page of what changed since it was reviewed: it shows each difference once, and nothing where there is none.

use std::error::Error;

use validation::review::{Change, Reviewed, page};
use validation::{CaseResult, Effort, Selection, cases, judge};

/// A case of less than a second with curves, a reference in closed form and several methods.
const CASE: &str = "cantilever-end-shear";

fn result() -> Result<CaseResult, Box<dyn Error>> {
    let selection =
        Selection { set: Effort::Quick, hard: false, names: vec![CASE.into()], jobs: 2, pages: false };
    Ok(judge(cases::usual(), &selection, &|_| {})?.remove(0))
}

fn stored(result: &CaseResult) -> Vec<Reviewed> {
    result.runs.iter().zip(&result.records).map(|(run, record)| Reviewed::of(run, record)).collect()
}

#[test]
fn what_did_not_change_is_not_shown() -> Result<(), Box<dyn Error>> {
    let result = result()?;
    let html = page(&[Change { result: &result, stored: stored(&result) }])?.html;
    assert_eq!(html.matches("<svg ").count(), 0);
    assert_eq!(html.matches("<td ").count(), 0, "a line of the table for nothing");
    Ok(())
}

#[test]
fn each_difference_has_its_line_and_its_curve_beside_the_reference() -> Result<(), Box<dyn Error>> {
    let result = result()?;
    let mut stored = stored(&result);
    let gone = Reviewed { method: "a method of before".into(), ..stored[0].clone() };
    let new = stored.pop().map(|run| format!("{} {}", run.method, run.grid)).unwrap_or_default();
    stored.push(gone);
    let (title, values) =
        stored[0].curve.iter().find(|(title, _)| title.starts_with("W")).ok_or("no deflection")?;
    let (title, mut numbers) = (title.clone(), values.split("  ").map(String::from).collect::<Vec<_>>());
    let middle = numbers.len() / 2;
    numbers[middle] = (1.1 * numbers[middle].parse::<f64>()?).to_string();
    stored[0].curve.insert(title.clone(), numbers.join("  "));
    let name = stored[0].metrics.keys().next().ok_or("no metric")?.clone();
    stored[0].metrics.insert(name.clone(), "what it was".into());
    let column = "internal [N m]";
    stored[0].curve.remove(column).ok_or("no energy")?;
    let html = page(&[Change { result: &result, stored }])?.html;
    for reported in [
        ">what it was<",
        &format!(">{name}<"),
        &format!(">column {title}<"),
        &format!(">column {column}<"),
        &format!(">{new}<"),
        ">gone<",
        "as reviewed: ",
        "exact",
    ] {
        assert!(html.contains(reported), "{reported} is not on the page");
    }
    Ok(())
}
