//! What was found for load cases and combinations, and the envelope of each column over them.

use std::io::{self, Write};

use serde::Serialize;

use crate::bodies::Resultant;
use crate::results::curve::{Column, Curve};
use crate::scene::LoadSet;

/// Answers to load cases and combinations, in the order of the rows of the curve.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct CasesSummary {
    /// Each case, then each combination.
    pub cases: Vec<CaseSummary>,
    /// Least and greatest of each measured column, over the combinations if there are any, else over the cases.
    pub envelope: Vec<Envelope>,
    /// Whether the envelope is over combinations.
    #[serde(skip)]
    combined: bool,
}

/// The answer to a load case or a combination; what its columns measure is a row of the curve.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CaseSummary {
    /// Which it is.
    #[serde(flatten)]
    pub set: LoadSet,
    /// Internal energy \[F L\].
    pub internal: f64,
    /// What the supports exert, reduced to the centroid; none of a body that does not tell.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub supports: Option<Resultant>,
}

/// Least and greatest of a column, and which case or combination has each.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Envelope {
    /// The column.
    #[serde(flatten)]
    pub column: Column,
    /// Its least number.
    pub least: f64,
    /// Where it is met; the first of several.
    pub least_in: String,
    /// Its greatest number.
    pub greatest: f64,
    /// Where it is met; the first of several.
    pub greatest_in: String,
}

impl CasesSummary {
    /// Of nothing yet, over such sets, whose columns are measured.
    pub(crate) fn over(sets: &[LoadSet], columns: Vec<Column>) -> Self {
        let (none, combined) = (String::new, sets.iter().any(|set| set.combines));
        let empty = |column| Envelope {
            column,
            least: f64::INFINITY,
            least_in: none(),
            greatest: f64::NEG_INFINITY,
            greatest_in: none(),
        };
        Self { cases: Vec::new(), envelope: columns.into_iter().map(empty).collect(), combined }
    }

    /// Takes in an answer with the numbers of its columns.
    pub(crate) fn take(&mut self, case: CaseSummary, columns: &[f64]) {
        for (own, &x) in self.envelope.iter_mut().zip(columns).filter(|_| case.set.combines == self.combined)
        {
            if x < own.least {
                (own.least, own.least_in) = (x, case.set.name.clone());
            }
            if x > own.greatest {
                (own.greatest, own.greatest_in) = (x, case.set.name.clone());
            }
        }
        self.cases.push(case);
    }

    /// Writes a table: a row for each case and combination with its name, then the least and greatest of each measured column and, below each, where it
    /// is met.
    ///
    /// # Errors
    /// Those of the writer.
    pub fn write_csv(&self, curve: &Curve, to: &mut impl Write) -> io::Result<()> {
        let first = curve.columns.len() - self.envelope.len();
        let titles: Vec<String> = curve.columns[first..].iter().map(Column::title).collect();
        let mut row = |name: &str, cells: Vec<String>| {
            writeln!(to, "{}", [vec![name.into()], cells].concat().join(","))
        };
        row("case", titles)?;
        for (case, numbers) in self.cases.iter().zip(&curve.rows) {
            row(&case.set.name, numbers[first..].iter().map(|x| format!("{x:?}")).collect())?;
        }
        let of = |cell: fn(&Envelope) -> String| self.envelope.iter().map(cell).collect();
        row("(least)", of(|own| format!("{:?}", own.least)))?;
        row("(least in)", of(|own| own.least_in.clone()))?;
        row("(greatest)", of(|own| format!("{:?}", own.greatest)))?;
        row("(greatest in)", of(|own| own.greatest_in.clone()))
    }
}
