//! The report: a page that shows every case, and pages of their own for survival and for what options cost.

mod cost;
mod list;
mod page;
mod runs;
mod section;

pub use page::Page;
pub(crate) use page::show;

use crate::JudgeError;
use crate::cases::option_cost;
use crate::figures::Figure;
use crate::judge::{CaseResult, Effort, Record, Selection};
use crate::tables::{counts, overview, survival};
use cost::family_charts;
use list::list;
use runs::every_run;
use section::section;

/// File of the first page.
pub const FIRST: &str = "report.html";
const SURVIVAL: &str = "survival.html";
const OPTIONS: &str = "option-cost.html";

/// The pages of the report, the first one first.
///
/// # Errors
/// [`JudgeError`] from the figures of a case.
pub fn pages(results: &[CaseResult], selection: &Selection) -> Result<Vec<Page>, JudgeError> {
    let mut further = Vec::new();
    if selection.hard {
        further.push(aside(SURVIVAL, "Survival of hard cases", &show(&Figure::Numbers(survival(results)))?));
    }
    let mut sections = Vec::new();
    let (mut listed, mut drawn) = (Vec::new(), Vec::new());
    for result in results {
        let own = section(result)?;
        if result.case.name == option_cost::NAME {
            further.push(aside(
                OPTIONS,
                "What each option of a scene costs",
                &own.html.replacen("<details>", "<details open>", 1),
            ));
            continue;
        }
        listed.push(result);
        drawn.push(own.drawn);
        sections.push(own.html);
    }
    let mut text = head(results, selection);
    for Page { file, title, .. } in &further {
        text.push_str(&format!("<p><a href='{file}'>{title}</a></p>"));
    }
    text.push_str(&list(&listed, &drawn));
    let charts = family_charts(&listed)?;
    if !charts.is_empty() {
        text.push_str("<h2>Error against cost</h2><div class='pairs'>");
        for chart in charts {
            text.push_str(&show(&Figure::Chart(chart))?);
        }
        text.push_str("</div>");
    }
    text.push_str("<h2>Cases</h2>");
    text.extend(sections);
    text.push_str("<h2>Tables</h2>");
    let answers = overview(results)?;
    if !answers.rows.is_empty() {
        let table = show(&Figure::Numbers(answers))?;
        text.push_str(&format!("<details><summary>Four answers to each problem</summary>{table}</details>"));
    }
    text.push_str(&every_run(results));
    let mut pages = vec![Page::new(FIRST, "coque: validation", &text)];
    pages.extend(further);
    Ok(pages)
}

/// Pages that show the pictured runs in a browser, by the file they go into; none where they are not wanted.
///
/// # Errors
/// [`JudgeError`] for what cannot be encoded.
pub fn shapes(results: &[CaseResult]) -> Result<Vec<(String, String)>, JudgeError> {
    let mut pages = Vec::new();
    for CaseResult { case, picture, .. } in results {
        let Some(picture) = picture else { continue };
        let refused = |cause| JudgeError::Study { case: case.name, method: picture.run.clone(), cause };
        let page = picture.page(case.title).map_err(refused)?;
        pages.extend(page.map(|html| (shape_file(case.name), html)));
    }
    Ok(pages)
}

/// Where the page of a case stands, from the folder of the report.
fn shape_file(case: &str) -> String {
    format!("shapes/{case}.html")
}

/// A page beside the first one.
fn aside(file: &'static str, title: &'static str, text: &str) -> Page {
    Page::new(file, title, &format!("<p><a href='{FIRST}'>All cases</a></p><h1>{title}</h1>{text}"))
}

fn head(results: &[CaseResult], selection: &Selection) -> String {
    let records: Vec<&Record> = results.iter().flat_map(|result| &result.records).collect();
    let missed = records.iter().any(|record| !record.passes());
    let seconds: f64 = records.iter().map(|record| record.wall_seconds).sum();
    let (class, outcome) = (if missed { "bad" } else { "good" }, counts(results));
    format!(
        "<h1>coque: validation</h1><p class='{class} outcome'>{outcome}.</p>\
         <p>{} set: {} runs, {seconds:.0} s of marching, {} at a time, one thread each. Every number was measured in this run. \
         A line shows the run of usual fineness, the worst where there are several; a click opens the case with its curves, and \
         with every tolerance and its reason. Compare times of one page with each other only, and run with one job \
         (--jobs 1) where cost is the question.</p>",
        match (selection.hard, selection.set) {
            (false, Effort::Quick) => "Quick",
            (false, Effort::Usual) => "Usual",
            (false, Effort::Full) => "Full",
            (false, Effort::Heavy) => "Heavy",
            (true, Effort::Quick) => "Quick hard",
            (true, Effort::Usual) => "Hard",
            (true, Effort::Full) => "Full hard",
            (true, Effort::Heavy) => "Heavy hard",
        },
        records.len(),
        selection.jobs
    )
}
