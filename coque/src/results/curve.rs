//! The curve of a run: columns with names and units, one row per record.

use std::io::{self, Write};
use std::str::FromStr;

/// A column of a [`Curve`].
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct Column {
    /// Name, such as `minus_U_tip`.
    pub name: String,
    /// Unit, such as `cm`; `-` without.
    pub unit: String,
}

/// Records of a run, one row each.
#[derive(Clone, Debug, Default, PartialEq, serde::Serialize)]
pub struct Curve {
    /// Columns.
    pub columns: Vec<Column>,
    /// Rows, each as long as `columns`.
    pub rows: Vec<Vec<f64>>,
}

impl Column {
    /// Name with unit, as in the first row of a file: `minus_U_tip [cm]`.
    pub fn title(&self) -> String {
        format!("{} [{}]", self.name, self.unit)
    }

    /// Its power by frequency, times being in such a unit.
    pub(crate) fn density(self, time: &str) -> Self {
        let unit = match (self.unit.as_str(), time) {
            ("-", time) => time.into(),
            (own, "-") => format!("({own})²"),
            (own, time) => format!("({own})² {time}"),
        };
        Self { unit, ..self }
    }
}

impl Curve {
    /// Values of one column; none if there is no such column.
    pub fn column(&self, name: &str) -> Option<Vec<f64>> {
        let at = self.columns.iter().position(|column| column.name == name)?;
        Some(self.rows.iter().map(|row| row[at]).collect())
    }

    /// Writes comma-separated values: names with units, then the shortest numbers that read back to the same bits.
    ///
    /// # Errors
    /// Those of the writer.
    pub fn write_csv(&self, to: &mut impl Write) -> io::Result<()> {
        let titles: Vec<String> = self.columns.iter().map(Column::title).collect();
        writeln!(to, "{}", titles.join(","))?;
        self.rows.iter().try_for_each(|row| Self::write_row(row, to))
    }

    /// Writes one row as it stands in such a file.
    pub(crate) fn write_row(row: &[f64], to: &mut impl Write) -> io::Result<()> {
        let numbers: Vec<String> = row.iter().map(|x| format!("{x:?}")).collect();
        writeln!(to, "{}", numbers.join(","))
    }
}

/// Text that is no curve.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("line {line} of the curve is {found}; it must be {bound}, as `coque run` writes it")]
pub struct NotACurve {
    /// Number of the line, from 1.
    pub line: usize,
    /// What stands there.
    pub found: String,
    /// What should.
    pub bound: &'static str,
}

impl FromStr for Curve {
    type Err = NotACurve;

    /// Reads what [`Curve::write_csv`] writes.
    fn from_str(text: &str) -> Result<Self, NotACurve> {
        let refused =
            |line: usize, found: &str, bound| NotACurve { line, found: format!("`{found}`"), bound };
        let mut lines = text.lines().enumerate();
        let titles = lines.next().map_or("", |(_, titles)| titles);
        let column = |title: &str| {
            let (name, unit) = title.strip_suffix(']')?.rsplit_once(" [")?;
            Some(Column { name: name.into(), unit: unit.into() })
        };
        let columns: Option<Vec<Column>> = titles.split(',').map(column).collect();
        let columns = columns.ok_or_else(|| refused(1, titles, "names with units, such as `time [s]`"))?;
        let rows = lines.map(|(i, line)| {
            let numbers: Result<Vec<f64>, _> = line.split(',').map(str::parse).collect();
            let fits = numbers.ok().filter(|row| row.len() == columns.len());
            fits.ok_or_else(|| refused(i + 1, line, "a number for each column"))
        });
        let rows = rows.collect::<Result<_, _>>()?;
        Ok(Self { columns, rows })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_read_back_to_the_same_bits() {
        let columns = ["time", "W"].map(|name| Column { name: name.into(), unit: "s".into() });
        let rows = vec![vec![0.1 + 0.2, 1e-300], vec![-0.0, 1.0 / 3.0], vec![2.5e21, f64::NAN]];
        let curve = Curve { columns: columns.into(), rows };
        let mut text = Vec::new();
        curve.write_csv(&mut text).unwrap();
        let text = String::from_utf8(text).unwrap();
        let read: Curve = text.parse().unwrap();
        assert_eq!((&read.columns, read.rows[0] == curve.rows[0]), (&curve.columns, true));
        let mut lines = text.lines();
        assert_eq!(lines.next(), Some("time [s],W [s]"));
        for (line, row) in lines.zip(&curve.rows) {
            let read: Vec<u64> = line.split(',').map(|x| x.parse::<f64>().unwrap().to_bits()).collect();
            assert_eq!(read, row.iter().map(|x| x.to_bits()).collect::<Vec<_>>());
        }
        assert_eq!(curve.column("W").unwrap()[1], 1.0 / 3.0);
        assert_eq!(curve.column("nothing"), None);
    }

    #[test]
    fn what_is_no_curve_is_refused_by_its_line() {
        for (text, line) in
            [("", 1), ("time,W", 1), ("time [s],W [s]\n1.0", 2), ("W [s]\n1.0\nx", 3), ("W [s]\n\n", 2)]
        {
            assert_eq!(text.parse::<Curve>().unwrap_err().line, line, "{text}");
        }
        let said = "W [s]\n1.0,2.0".parse::<Curve>().unwrap_err().to_string();
        assert!(
            said.starts_with("line 2 of the curve is `1.0,2.0`; it must be a number for each column"),
            "{said}"
        );
    }
}
