//! Errors for people: the value underlined in the scene, with the repair below.

use std::fmt;

use miette::{
    Diagnostic, GraphicalReportHandler, GraphicalTheme, LabeledSpan, NamedSource, SourceCode, SourceSpan,
};

use super::error::SceneError;
use crate::plain::{plain_text, same_length};

/// How to draw.
#[derive(Clone, Copy, Debug)]
pub struct Rendering {
    /// Columns of the terminal.
    pub width: usize,
    /// Whether colours are wanted.
    pub colour: bool,
}

/// A refusal as miette wants it.
struct Report<'a> {
    error: &'a SceneError,
    source: NamedSource<String>,
}

/// Draws a refusal: message, the place in the scene, and what to do.
pub fn render(error: &SceneError, how: Rendering) -> String {
    let place = &error.fault().place;
    // What is underlined is found by its bytes.
    let source = NamedSource::new(plain_text(&place.origin), same_length(&place.text)).with_language("TOML");
    let theme = if how.colour { GraphicalTheme::unicode() } else { GraphicalTheme::unicode_nocolor() };
    let handler = GraphicalReportHandler::new_themed(theme).with_width(how.width).with_context_lines(1);
    let mut out = String::new();
    match handler.render_report(&mut out, &Report { error, source }) {
        Ok(()) => out,
        Err(_) => format!("{}\n", plain_text(&error.to_string())),
    }
}

impl fmt::Debug for Report<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(self.error, f)
    }
}

impl fmt::Display for Report<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&plain_text(&self.error.to_string()))
    }
}

impl std::error::Error for Report<'_> {}

impl Diagnostic for Report<'_> {
    fn code<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        Some(Box::new(self.error.code()))
    }

    fn help<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        Some(Box::new(plain_text(&self.error.fault().repair)))
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        self.error.fault().place.span.as_ref().map(|_| &self.source as &dyn SourceCode)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        let span = self.error.fault().place.span.clone()?;
        let label = match self.error {
            SceneError::Value(fault) => format!("must be {}", fault.bound),
            SceneError::Choice(fault) => format!("must give {}", fault.bound),
            _ => "here".into(),
        };
        Some(Box::new(std::iter::once(LabeledSpan::new_with_span(
            Some(plain_text(&label).into_owned()),
            SourceSpan::from(span),
        ))))
    }
}
