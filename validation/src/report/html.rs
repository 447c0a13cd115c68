//! The page: one file, no scripts, drawings inline.

use super::cost::cost_chart;
use crate::JudgeError;
use crate::figures::{Figure, escape};
use crate::format::short;
use crate::judge::{CaseResult, Effort, Metric, Pictured, Record, Run, Selection};
use crate::metric_names::REST;
use crate::tables::{counts, overview, side_by_side, survival, unit, words};

const STYLE: &str = include_str!("style.css");

/// The whole report.
///
/// # Errors
/// [`JudgeError`] from the figures of a case.
pub fn html(results: &[CaseResult], selection: &Selection) -> Result<String, JudgeError> {
    let mut page = format!(
        "<!doctype html>\n<html lang='en'><head><meta charset='utf-8'>\
         <meta name='viewport' content='width=device-width, initial-scale=1'>\
         <title>coque: validation</title><style>{STYLE}</style></head><body><main>"
    );
    page.push_str(&head(results, selection));
    if selection.hard {
        page.push_str(&format!("<h2>Hard cases</h2>{}", show(&Figure::Numbers(survival(results)))?));
    }
    let answers = overview(results)?;
    if !answers.rows.is_empty() {
        page.push_str(&show(&Figure::Numbers(answers))?);
    }
    page.push_str(&summary(results));
    for result in results {
        page.push_str(&case(result)?);
    }
    page.push_str("</main></body></html>\n");
    Ok(page)
}

fn head(results: &[CaseResult], selection: &Selection) -> String {
    let records: Vec<&Record> = results.iter().flat_map(|result| &result.records).collect();
    let missed = records.iter().any(|record| !record.passes());
    let seconds: f64 = records.iter().map(|record| record.wall_seconds).sum();
    let (class, outcome) = (if missed { "bad" } else { "good" }, counts(results));
    format!(
        "<h1>coque: validation</h1><p class='{class} outcome'>{outcome}.</p>\
         <p>{} set: {} runs, {seconds:.0} s of marching, {} at a time, one thread each. Every number on this page \
         was measured in this run; a tolerance and where it comes from stand in the table of its case, and so does why there is \
         none where a number is only shown. Wall times are \
         those of the machine that made the page: compare them with each other only, and run with one job (--jobs 1) where cost is the question. A step of one particle counts \
         as one particle-step (p·step).</p>",
        match (selection.hard, selection.set) {
            (false, Effort::Quick) => "Quick",
            (false, Effort::Full) => "Full",
            (false, Effort::Heavy) => "Heavy",
            (true, Effort::Quick) => "Quick hard",
            (true, Effort::Full) => "Hard",
            (true, Effort::Heavy) => "Heavy hard",
        },
        records.len(),
        selection.jobs
    )
}

fn summary(results: &[CaseResult]) -> String {
    let mut rows = String::new();
    for result in results {
        for (number, (run, record)) in result.runs.iter().zip(&result.records).enumerate() {
            let first = if number == 0 {
                let name = escape(&record.case);
                let height = result.records.len();
                format!("<th rowspan='{height}' scope='rowgroup'><a href='#{name}'>{name}</a></th>")
            } else {
                String::new()
            };
            let verdict = record.verdict().word();
            rows.push_str(&format!(
                "<tr>{first}<td class='m'>{}</td><td>{}</td><td class='n'>{}</td><td>{}</td><td class='n'>{:.2}</td>\
                 <td class='n'>{:.2}</td><td class='{verdict}'>{verdict}</td></tr>",
                escape(&record.method),
                run.variant.grid,
                record.particles,
                worst(run, record),
                record.wall_seconds,
                record.particle_steps_per_second / 1e6,
            ));
        }
    }
    format!(
        "<h2>Summary</h2><table class='summary'><thead><tr><th>case</th><th>method</th><th>grid</th>\
         <th class='n'>particles</th><th>nearest to its tolerance</th><th class='n'>wall s</th>\
         <th class='n'>10⁶ p·steps/s</th><th>verdict</th></tr></thead><tbody>{rows}</tbody></table>"
    )
}

/// The metric that uses most of its tolerance; the first one where nothing is asked.
fn worst(run: &Run, record: &Record) -> String {
    let use_of = |metric: &&Metric| match (metric.error, metric.tolerance) {
        _ if metric.name == REST && metric.pass => -2.0,
        (_, None) => -1.0,
        (Some(error), Some(tolerance)) if tolerance > 0.0 => error / tolerance,
        (_, Some(_)) => f64::INFINITY,
    };
    let worst = record.metrics.iter().rev().max_by(|a, b| use_of(a).total_cmp(&use_of(b)));
    let ended = if run.done() { String::new() } else { "diverged; ".into() };
    let text = worst.map(|metric| format!("{}: {}{}", metric.name, words(metric), unit(metric)));
    escape(&format!("{ended}{}", text.unwrap_or_default()))
}

fn case(result: &CaseResult) -> Result<String, JudgeError> {
    let case = &result.case;
    let mut text = format!(
        "<section id='{}'><h2>{}</h2><p>{}</p><p class='source'>{}</p>",
        escape(case.name),
        escape(case.title),
        escape(case.about),
        escape(case.citation)
    );
    for figure in (case.figures)(&result.runs)? {
        text.push_str(&show(&figure)?);
    }
    if let Some(picture) = &result.picture {
        text.push_str(&drawing(case.name, picture)?);
    }
    for figure in cost_chart(result).into_iter().chain(side_by_side(result)?.map(Figure::Numbers)) {
        text.push_str(&show(&figure)?);
    }
    text.push_str(&metrics(result));
    text.push_str("</section>");
    Ok(text)
}

/// The deformed shape.
fn drawing(case: &'static str, picture: &Pictured) -> Result<String, JudgeError> {
    let refused = |cause| JudgeError::Study { case, method: picture.run.clone(), cause };
    let (svg, caption) = picture.drawn().map_err(refused)?;
    Ok(framed("Deformed shape", &caption, &svg))
}

fn framed(title: &str, caption: &str, inner: &str) -> String {
    let (title, caption) = (escape(title), escape(caption));
    format!("<figure><h3>{title}</h3>{inner}<figcaption>{caption}</figcaption></figure>")
}

fn show(figure: &Figure) -> Result<String, JudgeError> {
    Ok(match figure {
        Figure::Chart(chart) => framed(&chart.title, &chart.caption, &chart.html()?),
        Figure::Shapes(shapes) => framed(&shapes.title, &shapes.caption, &shapes.html()),
        Figure::Numbers(numbers) => {
            let row = |cells: &[String], tag: &str| {
                let cells: String =
                    cells.iter().map(|cell| format!("<{tag} class='n'>{}</{tag}>", escape(cell))).collect();
                format!("<tr>{cells}</tr>")
            };
            let body: String = numbers.rows.iter().map(|cells| row(cells, "td")).collect();
            let head = row(&numbers.head, "th");
            let table = format!("<table><thead>{head}</thead><tbody>{body}</tbody></table>");
            framed(&numbers.title, &numbers.caption, &table)
        }
        Figure::Note(note) => {
            let body: String = note.paragraphs.iter().map(|p| format!("<p>{}</p>", escape(p))).collect();
            format!("<div class='note'><h3>{}</h3>{body}</div>", escape(&note.title))
        }
    })
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
        // What is missed should be seen without a click.
        if result.records.iter().all(Record::passes) { "" } else { " open" },
    )
}
