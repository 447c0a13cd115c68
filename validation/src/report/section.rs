//! The section of a case: folded, with its figures, its comparison of answers, and every metric of every run.

use super::cost::cost_chart;
use super::page::{framed, show};
use crate::JudgeError;
use crate::figures::{Figure, escape};
use crate::format::short;
use crate::judge::{CaseResult, Pictured, Record};
use crate::tables::side_by_side;

/// A section, and whether it holds a drawing that its line in the list can show small.
pub struct Section {
    /// The section.
    pub html: String,
    /// Whether the first drawing has the name of [`drawing`].
    pub drawn: bool,
}

/// The name under which the first drawing of a case can be shown again.
pub fn drawing(case: &str) -> String {
    format!("drawing-{case}")
}

/// The section of a case; open where a tolerance is missed, which should be seen without a click.
///
/// # Errors
/// [`JudgeError`] from the figures of the case.
pub fn section(result: &CaseResult) -> Result<Section, JudgeError> {
    let case = &result.case;
    let mut figures = String::new();
    if let Some(picture) = &result.picture {
        figures.push_str(&shape(case.name, picture)?);
    }
    for figure in (case.figures)(&result.runs)? {
        figures.push_str(&show(&figure)?);
    }
    for figure in cost_chart(result)?.into_iter().chain(side_by_side(result)?.map(Figure::Numbers)) {
        figures.push_str(&show(&figure)?);
    }
    let drawn = figures.contains("<svg ");
    let figures = figures.replacen("<svg ", &format!("<svg id='{}' ", drawing(case.name)), 1);
    let html = format!(
        "<details{}><summary>{}</summary><section id='{}'><p>{}</p><p class='source'>{}</p>{figures}{}</section></details>",
        if missed(result) { " open" } else { "" },
        escape(case.title),
        escape(case.name),
        escape(case.about),
        escape(case.citation),
        metrics(result)
    );
    Ok(Section { html, drawn })
}

/// Whether a run of the case misses a tolerance.
pub fn missed(result: &CaseResult) -> bool {
    !result.records.iter().all(Record::passes)
}

/// The deformed shape.
fn shape(case: &'static str, picture: &Pictured) -> Result<String, JudgeError> {
    let refused = |cause| JudgeError::Study { case, method: picture.run.clone(), cause };
    let (svg, caption) = picture.drawn().map_err(refused)?;
    let link = match picture.has_page() {
        true => format!("<p><a href='{}'>Turn and play it</a></p>", super::shape_file(case)),
        false => String::new(),
    };
    Ok(framed("Deformed shape", &caption, &svg) + &link)
}

fn metrics(result: &CaseResult) -> String {
    let mut rows = String::new();
    for (run, record) in result.runs.iter().zip(&result.records) {
        for (number, metric) in record.metrics.iter().enumerate() {
            let first = if number == 0 {
                format!(
                    "<th rowspan='{}' scope='rowgroup'>{}<br>{}</th>",
                    record.metrics.len(),
                    escape(&record.method),
                    run.variant.grid
                )
            } else {
                String::new()
            };
            let number = |value: Option<f64>| value.map(short).unwrap_or_default();
            let word = metric.verdict.word();
            rows.push_str(&format!(
                "<tr>{first}<td>{}</td><td class='n'>{}</td><td class='n'>{}</td><td class='n'>{}</td><td>{}</td>\
                 <td class='{word}'>{word}</td><td class='why'>{}</td></tr>",
                escape(&metric.name),
                metric.value.map_or_else(|| "not reached".into(), short),
                number(metric.reference),
                number(metric.tolerance),
                if metric.unit == "-" { "" } else { &metric.unit },
                escape(&metric.reason),
            ));
        }
    }
    format!(
        "<details{}><summary>All metrics of this case</summary><table><thead><tr><th>run</th><th>metric</th>\
         <th class='n'>value</th><th class='n'>reference</th><th class='n'>may be off by</th><th>unit</th>\
         <th>verdict</th><th>where the tolerance comes from, or why there is none</th></tr></thead><tbody>{rows}</tbody></table></details>",
        if missed(result) { " open" } else { "" },
    )
}
