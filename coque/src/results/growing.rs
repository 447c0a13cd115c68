//! The curve of a run under way, on disk row by row: what kills the run leaves the rows so far.

use std::fs::{File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use mesh_io::write_whole;

use crate::results::curve::Curve;

/// A file that holds a curve and grows with it.
///
/// It is written whole at first, then appended to a row at a time, each by one call of the system: whoever reads it finds
/// whole rows. A row that finds no room is taken out again, and tried anew with the next one.
#[derive(Debug)]
pub struct GrowingCurve {
    path: PathBuf,
    /// The file, once it is written.
    file: Option<File>,
    /// Its rows, and its length in bytes.
    rows: usize,
    length: u64,
}

impl GrowingCurve {
    /// A file that is not there yet, or holds another curve.
    pub fn new(path: &Path) -> Self {
        Self { path: path.into(), file: None, rows: 0, length: 0 }
    }

    /// Takes over the rows that came since the last call; at the first call the whole curve.
    ///
    /// # Errors
    /// Those of the system; the file holds whole rows still.
    pub fn take(&mut self, curve: &Curve) -> io::Result<()> {
        let Some(file) = &mut self.file else {
            write_whole(&self.path, |to| curve.write_csv(to))?;
            let file = OpenOptions::new().append(true).open(&self.path)?;
            self.length = file.metadata()?.len();
            self.rows = curve.rows.len();
            self.file = Some(file);
            return Ok(());
        };
        let mut text = Vec::new();
        for row in curve.rows.iter().skip(self.rows) {
            Curve::write_row(row, &mut text)?;
        }
        if let Err(error) = file.write_all(&text) {
            // Part of a row may have found room. Where it cannot be taken out, the file is written anew.
            if file.set_len(self.length).is_err() {
                self.file = None;
            }
            return Err(error);
        }
        (self.rows, self.length) = (curve.rows.len(), self.length + text.len() as u64);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::results::curve::Column;

    #[test]
    fn at_any_moment_it_reads_as_the_curve_so_far() {
        let path = std::env::temp_dir().join(format!("coque-growing-{}.csv", std::process::id()));
        let mut growing = GrowingCurve::new(&path);
        let columns = vec![Column { name: "level".into(), unit: "-".into() }];
        let mut curve = Curve { columns, rows: vec![vec![0.0]] };
        let read = || std::fs::read_to_string(&path).unwrap().parse::<Curve>().unwrap();
        growing.take(&curve).unwrap();
        assert_eq!(read(), curve);
        for row in 1..5 {
            curve.rows.push(vec![0.1 * f64::from(row)]);
            if row % 2 == 0 {
                growing.take(&curve).unwrap();
                assert_eq!(read(), curve);
            }
        }
        let mut whole = Vec::new();
        curve.write_csv(&mut whole).unwrap();
        assert_eq!(std::fs::read(&path).unwrap(), whole);
        std::fs::remove_file(&path).unwrap();
    }
}
