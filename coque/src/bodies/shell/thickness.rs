//! Thicknesses that differ from cell to cell: linear in space, or from a table.

use std::fs;
use std::path::Path;

use sph_core::{CellList, Cloud, Vec3};

use super::arrays::{by_cell, by_particle};
use super::build::Builder;
use crate::scene::error::SceneError;
use crate::scene::scope::Scope;
use crate::scene::{Homogeneous, Taper, ThicknessTable};

const TABLE: &str = "section.homogeneous.table";
const VALUES: &str = "section.homogeneous.values";

/// Rows of a table: places and numbers.
struct Table {
    places: Vec<Vec3>,
    numbers: Vec<f64>,
}

impl Builder<'_> {
    /// Thickness of each of some cells of a cloud that is not turned yet.
    ///
    /// # Errors
    /// [`SceneError`] for a thickness that is not positive, a table that cannot be read, and one without a row near a cell.
    pub(super) fn thicknesses(
        &self,
        section: &Homogeneous,
        at: &Scope<'_>,
        cells: &[u32],
        cloud: &Cloud,
    ) -> Result<Vec<f64>, SceneError> {
        let own = section.thickness.get();
        let centre = |cell: u32| cloud.cells[cell as usize].geometry(&cloud.positions).centroid;
        let (key, repair, all) = match (&section.taper, &section.table, &section.values) {
            (_, _, Some(name)) => {
                let factors = by_particle(self.scene.scene, at, VALUES, name, cloud.len())?;
                let all = by_cell(factors, cells, cloud).into_iter().map(|factor| own * factor).collect();
                (VALUES, "correct the array", all)
            }
            (_, Some(table), None) => {
                let parts = self.table(table, at)?.parts(cells, cloud);
                let parts = parts.map_err(|place| {
                    let value = format!("no row near {}", shown(&place));
                    let bound = "one for every corner of a cell, no farther away than the cell is long";
                    let repair = "add rows there, or give the cells a part of their own";
                    SceneError::Mesh(at.fault(TABLE, &value, bound, repair))
                })?;
                let all: Vec<f64> = parts.into_iter().map(|part| own * part).collect();
                (TABLE, "correct the rows there", all)
            }
            (Some(taper), None, None) => {
                let all = cells.iter().map(|&cell| tapered(own, taper, &centre(cell))).collect();
                (
                    "section.homogeneous.taper",
                    "let the thickness grow slower, or take its point elsewhere",
                    all,
                )
            }
            (None, None, None) => ("section.homogeneous", "", vec![own; cells.len()]),
        };
        match cells.iter().zip(&all).find(|(_, t)| !(**t > 0.0 && t.is_finite())) {
            None => Ok(all),
            Some((&cell, t)) => {
                let value = format!("a thickness of {t:.4e} at {}", shown(&centre(cell)));
                Err(at.value(key, value, "positive in every cell", repair))
            }
        }
    }

    /// Reads a table.
    fn table(
        &self,
        ThicknessTable { file, column }: &ThicknessTable,
        at: &Scope<'_>,
    ) -> Result<Table, SceneError> {
        let refuse = |value: String, bound: &str, repair: &str| {
            SceneError::Mesh(at.fault(TABLE, &value, bound, repair))
        };
        let folder = Path::new(self.scene.source.origin()).parent().unwrap_or(Path::new(""));
        let text = fs::read_to_string(folder.join(file)).map_err(|error| {
            // Of the system the kind alone: its words differ from one to the other.
            refuse(format!("{file} cannot be read: {}", error.kind()), "a file", "check the path")
        })?;
        let mut lines = (1..).zip(text.lines()).filter(|(_, line)| {
            let line = line.trim();
            !line.is_empty() && !line.starts_with('#')
        });
        let names: Vec<&str> = lines.next().map_or(Vec::new(), |(_, line)| words(line).collect());
        let mut places = [0; 4];
        for (place, name) in places.iter_mut().zip(["x", "y", "z", column]) {
            *place = names.iter().position(|known| *known == name).ok_or_else(|| {
                let value =
                    format!("{file} has no column \"{name}\"; its first line names {}", names.join(", "));
                refuse(value, &format!("columns x, y, z and {column}"), "name the columns in the first line")
            })?;
        }
        let mut table = Table { places: Vec::new(), numbers: Vec::new() };
        for (number, line) in lines {
            let values: Vec<&str> = words(line).collect();
            let mut row = [0.0; 4];
            for (value, place) in row.iter_mut().zip(places) {
                let found = values.get(place).and_then(|word| word.parse::<f64>().ok());
                *value = found.filter(|value| value.is_finite()).ok_or_else(|| {
                    let value = format!("{file}, line {number}: no number in column {}", names[place]);
                    refuse(value, "a finite number", "give every column a number")
                })?;
            }
            if row[3] <= 0.0 {
                let value = format!("{file}, line {number}: {} in column {column}", row[3]);
                return Err(refuse(value, "a positive number", "correct the row"));
            }
            table.places.push(Vec3::new(row[0], row[1], row[2]));
            table.numbers.push(row[3]);
        }
        Ok(table)
    }
}

impl Table {
    /// The mean number over the corners of each cell; the place of a corner without a row.
    fn parts(&self, cells: &[u32], cloud: &Cloud) -> Result<Vec<f64>, Vec3> {
        let list = CellList::new(&self.places, cloud.spacing());
        let mut near = Vec::new();
        let mut part = |&cell: &u32| {
            let cell = &cloud.cells[cell as usize];
            let place = |a: u32| cloud.positions[a as usize];
            let long = cell.edges().map(|(a, b)| (place(b) - place(a)).norm()).fold(0.0, f64::max);
            let mut sum = 0.0;
            for &a in cell.particles() {
                let x = place(a);
                list.within(&x, long, &mut near);
                let distance = |row: u32| (self.places[row as usize] - x).norm_squared();
                // Of equally near rows the first, whatever order the list has.
                let order = |a: &u32, b: &u32| distance(*a).total_cmp(&distance(*b)).then(a.cmp(b));
                sum += self.numbers[near.iter().copied().min_by(order).ok_or(x)? as usize];
            }
            Ok(sum / f64::from(cell.count))
        };
        cells.iter().map(&mut part).collect()
    }
}

fn words(line: &str) -> impl Iterator<Item = &str> {
    line.split(',').map(|word| word.trim().trim_matches('"'))
}

fn tapered(thickness: f64, taper: &Taper, place: &Vec3) -> f64 {
    thickness + Vec3::from(taper.gradient).dot(&(place - Vec3::from(taper.point)))
}

fn shown(x: &Vec3) -> String {
    format!("[{:.4}, {:.4}, {:.4}]", x.x, x.y, x.z)
}
