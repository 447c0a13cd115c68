//! The page of a review: a section for each case that changed, its numbers first, then its curves.

use super::change::Change;
use super::curves::{Changed, changed, charts};
use super::reviewed::Reviewed;
use crate::figures::{Figure, Numbers, escape};
use crate::format::short;
use crate::report::{Page, show};
use crate::{JudgeError, Record};

/// The page `review.html`.
///
/// # Errors
/// [`JudgeError`] from the drawing of a chart.
pub fn page(changes: &[Change<'_>]) -> Result<Page, JudgeError> {
    let mut text = format!(
        "<h1>coque: results to review</h1><p>{} not as {} reviewed. Read each difference; <code>cargo insta review</code> \
         accepts or refuses it, and the commit says why it is right.</p>",
        if changes.len() == 1 { "One case is".into() } else { format!("{} cases are", changes.len()) },
        if changes.len() == 1 { "it was" } else { "they were" },
    );
    for change in changes {
        text.push_str(&section(change)?);
    }
    Ok(Page::new("review.html", "coque: results to review", &text))
}

fn section(change: &Change<'_>) -> Result<String, JudgeError> {
    let case = &change.result.case;
    let mut text =
        format!("<h2 id='{}'>{}</h2><p>{}</p>", escape(case.name), escape(case.title), escape(case.about));
    let mut columns = Vec::new();
    for (run, record) in change.result.runs.iter().zip(&change.result.records) {
        let old = change.reviewed(&record.method, &run.variant.grid);
        let of = format!("{} {}", record.method, run.variant.grid);
        if let Some(old) = old {
            columns.extend(changed(&run.outcome.curve, old).into_iter().map(|column| (of.clone(), column)));
        }
    }
    text.push_str(&show(&Figure::Numbers(numbers(change, &columns)))?);
    text.push_str("<div class='pairs'>");
    for chart in charts(change) {
        text.push_str(&show(&Figure::Chart(chart))?);
    }
    text.push_str("</div>");
    if !columns.is_empty() {
        text.push_str("<details><summary>Columns that changed</summary><div class='pairs'>");
        for (of, column) in columns {
            let mut chart = column.chart;
            chart.title = format!("{of}: {}", chart.title);
            text.push_str(&show(&Figure::Chart(chart))?);
        }
        text.push_str("</div></details>");
    }
    Ok(text)
}

/// What changed, in numbers: a line for each metric and each column, run by run.
fn numbers(change: &Change<'_>, columns: &[(String, Changed)]) -> Numbers {
    let mut rows = Vec::new();
    let mut row = |cells: [&str; 5]| rows.push(cells.map(str::to_owned).to_vec());
    for (run, record) in change.result.runs.iter().zip(&change.result.records) {
        let (method, grid) = (&record.method, &run.variant.grid);
        let of = format!("{method} {grid}");
        let Some(old) = change.reviewed(method, grid) else {
            row([&of, "the whole run", "", "new", ""]);
            continue;
        };
        let new = Reviewed::of(run, record);
        let names: std::collections::BTreeSet<_> = old.metrics.keys().chain(new.metrics.keys()).collect();
        for name in names {
            let [was, is] = [&old.metrics, &new.metrics].map(|of| of.get(name).map_or("", String::as_str));
            if was != is {
                row([&of, name, was, is, &reference(record, name)]);
            }
        }
        for title in new.curve.keys().filter(|title| !old.curve.contains_key(*title)) {
            row([&of, &format!("column {title}"), "", "new", ""]);
        }
        for title in old.curve.keys().filter(|title| !new.curve.contains_key(*title)) {
            row([&of, &format!("column {title}"), "was there", "gone", ""]);
        }
        let counts = |run: &Reviewed| {
            format!("{} particles, {} degrees of freedom, {}", run.particles, run.dof, run.spacing)
        };
        if counts(old) != counts(&new) {
            row([&of, "particles, degrees of freedom, spacing", &counts(old), &counts(&new), ""]);
        }
        for (_, column) in columns.iter().filter(|(name, _)| *name == of) {
            let part = column
                .part
                .map_or("another number of rows".into(), |part| format!("off by {} %", short(100.0 * part)));
            row([&of, &format!("column {}", column.title), "", &part, ""]);
        }
    }
    let gone = |old: &&Reviewed| {
        !change
            .result
            .records
            .iter()
            .zip(change.result.runs.iter())
            .any(|(record, run)| record.method == old.method && run.variant.grid == old.grid)
    };
    for old in change.stored.iter().filter(gone) {
        row([&format!("{} {}", old.method, old.grid), "the whole run", "was there", "gone", ""]);
    }
    Numbers {
        title: "What changed".into(),
        caption: "Columns: the largest difference at the rows that a snapshot keeps, over the largest value."
            .into(),
        head: ["run", "what", "as reviewed", "now", "reference"].map(String::from).to_vec(),
        rows,
    }
}

fn reference(record: &Record, metric: &str) -> String {
    record.metric(metric).and_then(|metric| metric.reference).map(short).unwrap_or_default()
}
