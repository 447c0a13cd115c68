//! A course in time that a file has, as a scene names it.

use std::borrow::Cow;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Deserialize;

/// A course in time from a file: numbers by time in two columns of a CSV file, or an acceleration as PEER keeps it (`.AT2`). Between its times it goes along
/// straight lines; before the first and after the last it stays, an `.AT2` and what has a `baseline` are zero after their end.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Record {
    /// The file, from the folder of the scene; one that ends in `.AT2` is read as PEER writes it, any other as CSV: numbers between commas, semicolons, tabs or
    /// blanks, lines after `#` left out, names of columns in a first line without numbers, or none.
    pub file: String,
    /// Columns of time and of the numbers, by name or by number from 1; left out, the first two. None of an `.AT2`.
    pub columns: Option<[ColumnOfFile; 2]>,
    /// Units of time and of the numbers, such as `["s", "g"]`, g being 9.80665 m/s²: they are converted to those of the scene. Numbers may be in a unit of what
    /// the course multiplies, of a base an acceleration, of a `force` a force. `"-"` takes them as they are, and so does leaving it out, but of an `.AT2`, which is
    /// in s and g.
    pub units: Option<[String; 2]>,
    /// Factor on the numbers \[–\].
    #[serde(default = "one")]
    pub factor: f64,
    /// What is taken off an acceleration, so that what it moves ends at rest where it began.
    #[serde(default)]
    pub baseline: Baseline,
}

/// A column of a file.
#[derive(Clone, Debug, Deserialize)]
#[serde(untagged)]
pub enum ColumnOfFile {
    /// Its number, from 1.
    Number(usize),
    /// Its name, with or without a unit in brackets behind it.
    Name(String),
}

impl JsonSchema for ColumnOfFile {
    fn schema_name() -> Cow<'static, str> {
        "ColumnOfFile".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "A column of a file: its name, with or without a unit in brackets behind it, or its number from 1.",
            "type": ["string", "integer"]
        })
    }
}

/// What is taken off an acceleration.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Baseline {
    /// Nothing.
    #[default]
    None,
    /// A straight line, taken off all points but the zero at its end, by which velocity and displacement, integrated from rest, are zero there. A record that ends
    /// otherwise goes to zero in one more step.
    Linear,
}

fn one() -> f64 {
    1.0
}
