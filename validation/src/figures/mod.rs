//! What a case may show: curves, deformed shapes, numbers, words.

mod charts;
mod instants;
mod legend;
mod shapes;

pub use charts::{Axis, Chart, Series};
pub use instants::{Instant, Instants};
pub use legend::{BLACK, BLUE, Colour, GREEN, GREY, Line, Mark, ORANGE, PURPLE, SKY, VERMILION, shade};
pub use shapes::{Shapes, Sheet};

/// Something that the report shows.
#[derive(Clone, Debug)]
pub enum Figure {
    /// Curves.
    Chart(Chart),
    /// Deformed shapes.
    Shapes(Shapes),
    /// Particles at several instants.
    Instants(Instants),
    /// Numbers.
    Numbers(Numbers),
    /// A heading with paragraphs.
    Note(Note),
}

/// A small table.
#[derive(Clone, Debug)]
pub struct Numbers {
    /// What the table holds.
    pub title: String,
    /// What to see in it.
    pub caption: String,
    /// Names of the columns, with units.
    pub head: Vec<String>,
    /// Cells, ready to print.
    pub rows: Vec<Vec<String>>,
}

/// Words.
#[derive(Clone, Debug)]
pub struct Note {
    /// Heading.
    pub title: String,
    /// Paragraphs, plain text.
    pub paragraphs: Vec<String>,
}

/// Text made safe for HTML.
pub fn escape(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('\'', "&#39;")
        .replace('"', "&quot;")
}
