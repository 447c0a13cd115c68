//! Which numbers colour the cells: a field by its name, a component of it, the length of a vector.

use mesh_io::{Array, Sheet};

use crate::scene::source::suggest;

/// A field that a frame does not hold.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the frame has no field `{wanted}`; {repair}")]
pub struct FieldNotThere {
    /// What was asked for.
    pub wanted: String,
    /// What there is.
    pub repair: String,
}

/// One number a cell.
pub(super) struct Values {
    pub name: String,
    pub unit: Option<String>,
    pub of_cells: Vec<f64>,
}

impl Values {
    /// Of what has no size: shares of the greatest size of a value.
    pub fn as_shares(&mut self) {
        let sizes = self.of_cells.iter().map(|value| value.abs()).filter(|size| size.is_finite());
        let greatest = sizes.fold(0.0, f64::max);
        if greatest > 0.0 {
            self.of_cells.iter_mut().for_each(|value| *value /= greatest);
        }
        self.unit = Some("of the greatest".into());
    }
}

const AXES: [&str; 3] = ["x", "y", "z"];

/// The field that says most of a sheet: the temperature of what conducts heat, of a fluid the pressure, damage if there is any, the von Mises stress on top if there
/// is one, else the displacement.
pub fn usual_field(sheet: &Sheet) -> &'static str {
    let broken =
        || sheet.point_data.get("damage").is_some_and(|damage| damage.numbers.iter().any(|&x| x.abs() > 0.0));
    match () {
        () if find(sheet, "temperature").is_some() => "temperature",
        () if find(sheet, "pressure").is_some() => "pressure",
        () if broken() => "damage",
        () if find(sheet, "von_mises_top").is_some() => "von_mises_top",
        () => "displacement",
    }
}

/// The numbers of a field, or of the one that says most.
pub(super) fn values(sheet: &Sheet, wanted: Option<&str>) -> Result<Values, FieldNotThere> {
    let name = wanted.unwrap_or_else(|| usual_field(sheet));
    let (base, component) = name.split_once('.').map_or((name, None), |(base, c)| (base, Some(c)));
    let found = find(sheet, base);
    let found = found.and_then(|(array, at_cells)| Some((array, scalar(array, component)?, at_cells)));
    let Some((array, numbers, at_cells)) = found else {
        let known: Vec<&str> =
            sheet.point_data.keys().chain(sheet.cell_data.keys()).map(String::as_str).collect();
        let mut known = known;
        known.sort_unstable();
        let repair = format!("{}, or a component such as displacement.z or moment.11", suggest(base, &known));
        return Err(FieldNotThere { wanted: name.into(), repair });
    };
    let mean = |cell: &Vec<usize>| cell.iter().map(|&a| numbers[a]).sum::<f64>() / cell.len() as f64;
    let of_cells = if at_cells { numbers } else { sheet.cells.iter().map(mean).collect() };
    Ok(Values { name: name.into(), unit: array.unit.clone(), of_cells })
}

/// A field of the cells, else of the points.
fn find<'a>(sheet: &'a Sheet, name: &str) -> Option<(&'a Array, bool)> {
    let of_cells = sheet.cell_data.get(name).map(|array| (array, true));
    of_cells.or_else(|| sheet.point_data.get(name).map(|array| (array, false)))
}

/// One number a row: the named component, the number itself, or the length of a vector.
fn scalar(array: &Array, component: Option<&str>) -> Option<Vec<f64>> {
    let rows = array.numbers.chunks_exact(array.width);
    let Some(component) = component else {
        let length =
            |row: &[f64]| if let [one] = row { *one } else { row.iter().map(|x| x * x).sum::<f64>().sqrt() };
        return Some(rows.map(length).collect());
    };
    let at = match array.components.is_empty() {
        true if array.width == 3 => AXES.iter().position(|axis| *axis == component)?,
        _ => array.components.iter().position(|name| name == component)?,
    };
    Some(rows.map(|row| row[at]).collect())
}
