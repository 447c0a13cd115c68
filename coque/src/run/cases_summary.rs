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
    /// Least and greatest of each measured column, over the combinations if there are any, else over the cases; empty before the first of them.
    pub envelope: Vec<Envelope>,
    /// The measured columns.
    #[serde(skip)]
    columns: Vec<Column>,
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
        let combined = sets.iter().any(|set| set.combines);
        Self { cases: Vec::new(), envelope: Vec::new(), columns, combined }
    }

    /// Takes in an answer with the numbers of its columns.
    pub(crate) fn take(&mut self, case: CaseSummary, columns: &[f64]) {
        if case.set.combines == self.combined {
            let name = &case.set.name;
            if self.envelope.is_empty() {
                let first = self.columns.iter().zip(columns);
                self.envelope = first.map(|(column, &x)| Envelope::at(column.clone(), x, name)).collect();
            }
            self.envelope.iter_mut().zip(columns).for_each(|(own, &x)| own.take(x, name));
        }
        self.cases.push(case);
    }

    /// Writes a table: a row for each case and combination with its name, then the least and greatest of each measured column and, below each, where it
    /// is met; nothing of an envelope that has not begun.
    ///
    /// # Errors
    /// Those of the writer.
    pub fn write_csv(&self, curve: &Curve, to: &mut impl Write) -> io::Result<()> {
        let first = curve.columns.len() - self.columns.len();
        let titles: Vec<String> = curve.columns[first..].iter().map(Column::title).collect();
        let mut row = |name: &str, cells: Vec<String>| {
            writeln!(to, "{}", [vec![name.into()], cells].concat().join(","))
        };
        row("case", titles)?;
        for (case, numbers) in self.cases.iter().zip(&curve.rows) {
            row(&case.set.name, numbers[first..].iter().map(|x| format!("{x:?}")).collect())?;
        }
        if self.envelope.is_empty() {
            return Ok(());
        }
        let of = |cell: fn(&Envelope) -> String| self.envelope.iter().map(cell).collect();
        row("(least)", of(|own| format!("{:?}", own.least)))?;
        row("(least in)", of(|own| own.least_in.clone()))?;
        row("(greatest)", of(|own| format!("{:?}", own.greatest)))?;
        row("(greatest in)", of(|own| own.greatest_in.clone()))
    }
}

impl Envelope {
    /// Of one number.
    fn at(column: Column, x: f64, name: &str) -> Self {
        Self { column, least: x, least_in: name.into(), greatest: x, greatest_in: name.into() }
    }

    /// Takes in one more.
    fn take(&mut self, x: f64, name: &str) {
        if x < self.least || self.least.is_nan() {
            (self.least, self.least_in) = (x, name.into());
        }
        if x > self.greatest || self.greatest.is_nan() {
            (self.greatest, self.greatest_in) = (x, name.into());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn set(name: &str, combines: bool) -> LoadSet {
        LoadSet { name: name.into(), combines, of: [("a".to_string(), 1.0)].into(), phases: [].into() }
    }

    /// Interrupted before the first combination there is nothing to be least or greatest.
    #[test]
    fn an_envelope_begins_with_the_first_that_counts() {
        let column = Column { name: "w".into(), unit: "m".into() };
        let curve = |rows: &[f64]| Curve {
            columns: vec![column.clone()],
            rows: rows.iter().map(|&x| vec![x]).collect(),
        };
        let mut all = CasesSummary::over(&[set("a", false), set("c", true)], vec![column.clone()]);
        let table = |all: &CasesSummary, rows: &[f64]| {
            let mut text = Vec::new();
            all.write_csv(&curve(rows), &mut text).unwrap();
            String::from_utf8(text).unwrap()
        };
        let answer = |set| CaseSummary { set, internal: 1.0, supports: None };
        all.take(answer(set("a", false)), &[2.0]);
        assert!(all.envelope.is_empty());
        assert_eq!(table(&all, &[2.0]), "case,w [m]\na,2.0\n");
        all.take(answer(set("c", true)), &[3.0]);
        let whole = "case,w [m]\na,2.0\nc,3.0\n(least),3.0\n(least in),c\n(greatest),3.0\n(greatest in),c\n";
        assert_eq!(table(&all, &[2.0, 3.0]), whole);
    }
}
