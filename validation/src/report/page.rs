//! A page: one file, no scripts, drawings inline.

use crate::JudgeError;
use crate::figures::{Figure, escape};

const STYLE: &str = include_str!("style.css");

/// A file of the report.
#[derive(Clone, Debug)]
pub struct Page {
    /// Name of the file.
    pub file: &'static str,
    /// Its title.
    pub title: &'static str,
    /// Its text.
    pub html: String,
}

impl Page {
    /// A page around a text.
    pub fn new(file: &'static str, title: &'static str, text: &str) -> Self {
        let html = format!(
            "<!doctype html>\n<html lang='en'><head><meta charset='utf-8'>\
             <meta name='viewport' content='width=device-width, initial-scale=1'>\
             <title>{}</title><style>{STYLE}</style></head><body><main>{text}</main></body></html>\n",
            escape(title)
        );
        Self { file, title, html }
    }
}

/// A drawing or table with its title and what to see in it.
pub fn framed(title: &str, caption: &str, inner: &str) -> String {
    let (title, caption) = (escape(title), escape(caption));
    format!("<figure><h3>{title}</h3>{inner}<figcaption>{caption}</figcaption></figure>")
}

/// A figure, framed.
///
/// # Errors
/// [`JudgeError`] from the drawing of a chart.
pub fn show(figure: &Figure) -> Result<String, JudgeError> {
    Ok(match figure {
        Figure::Chart(chart) => framed(&chart.title, &chart.caption, &chart.html()?),
        Figure::Shapes(shapes) => framed(&shapes.title, &shapes.caption, &shapes.html()),
        Figure::Instants(instants) => framed(&instants.title, &instants.caption, &instants.html()),
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
