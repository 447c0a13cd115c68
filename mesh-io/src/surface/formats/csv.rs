//! Points in CSV: columns x, y, z, nx, ny, nz, area and perhaps thickness; particles without faces.

use super::words::float;
use crate::input::shortened;
use crate::surface::MeshError;
use crate::surface::raw::Raw;

/// Columns in the order in which they are used; all but the last are needed.
const COLUMNS: [&str; 8] = ["x", "y", "z", "nx", "ny", "nz", "area", "thickness"];

/// Reads a text.
pub(super) fn parse(text: &str) -> Result<Raw, MeshError> {
    let mut raw = Raw::default();
    let mut lines = (1..).zip(text.lines()).filter(|(_, line)| {
        let line = line.trim();
        !line.is_empty() && !line.starts_with('#')
    });
    let heading = "begin with the line x,y,z,nx,ny,nz,area or x,y,z,nx,ny,nz,area,thickness";
    let Some((line, header)) = lines.next() else {
        return Err(MeshError::whole("the file is empty", heading));
    };
    let names: Vec<String> =
        header.split(',').map(|name| name.trim().trim_matches('"').to_lowercase()).collect();
    let mut places = [None; 8];
    for (place, name) in names.iter().enumerate() {
        match COLUMNS.iter().position(|known| known == name) {
            Some(column) if places[column].is_none() => places[column] = Some(place),
            Some(_) => {
                let what = format!("column {name} is there twice");
                return Err(MeshError::at(line, what, "name every column once"));
            }
            None => {
                let what = format!("column \"{}\" is none of {}", shortened(name), COLUMNS.join(", "));
                return Err(MeshError::at(line, what, heading));
            }
        }
    }
    if let Some(missing) = (0..7).find(|&column| places[column].is_none()) {
        let what = format!("column {} is missing", COLUMNS[missing]);
        return Err(MeshError::at(line, what, heading));
    }
    for (line, row) in lines {
        let words: Vec<&str> = row.split(',').map(str::trim).collect();
        if words.len() != names.len() {
            let what = format!("{} values stand in a row of {} columns", words.len(), names.len());
            return Err(MeshError::at(line, what, "give every column a value"));
        }
        let mut values = [0.0; 8];
        for ((value, place), name) in values.iter_mut().zip(places).zip(COLUMNS) {
            if let Some(place) = place {
                *value = float(line, name, words[place])?;
            }
        }
        let [x, y, z, nx, ny, nz, area, thickness] = values;
        let point = raw.push(line, [x, y, z])?;
        if [nx, ny, nz] == [0.0; 3] {
            return Err(MeshError::at(
                line,
                "the normal is [0, 0, 0]",
                "give it a direction; its length does not matter",
            ));
        }
        raw.normals.insert(point, [nx, ny, nz].into());
        let has_thickness = places[7].is_some();
        for (name, value, given) in [("area", area, true), ("thickness", thickness, has_thickness)] {
            if given && value <= 0.0 {
                let what = format!("{name} is {value}; it must be positive");
                return Err(MeshError::at(line, what, "give a number above zero"));
            }
        }
        raw.areas.push(area);
        if has_thickness {
            raw.thicknesses.push(thickness);
        }
    }
    Ok(raw)
}
