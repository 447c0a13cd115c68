//! VTU: an unstructured grid of triangles and quadrangles in one piece, ASCII or inline base64, uncompressed.

use crate::surface::MeshError;
use crate::surface::raw::Raw;
use crate::vtu::read::{Grid, Numbers};
use crate::vtu::xml::{XmlError, parsed};

impl From<XmlError> for MeshError {
    fn from(error: XmlError) -> Self {
        Self::at(error.line, error.what, error.repair)
    }
}

/// Reads a text.
pub(super) fn parse(text: &str) -> Result<Raw, MeshError> {
    let document = parsed(text)?;
    let grid = Grid::open(&document, f64::is_finite)?;
    let geometry = grid.geometry()?;
    let mut raw = Raw::default();
    for (label, &position) in (0..).zip(geometry.points()) {
        raw.node(0, label, position)?;
    }
    let mut other = 0;
    for (label, (kind, corners)) in (0..).zip(geometry.cells()) {
        match (kind, corners.len()) {
            (5, 3) | (9, 4) => {
                let mut nodes = Vec::new();
                for &corner in corners {
                    // A negative number names no point either.
                    let corner = u64::try_from(corner).unwrap_or(u64::MAX);
                    nodes.push(raw.find(0, &format!("cell {label}"), corner)?);
                }
                raw.face(0, label, &nodes)?;
            }
            (1..=4, _) => other += 1,
            (kind, points) => {
                let what = format!("cell {label} is of type {kind} with {points} points");
                let repair = "keep triangles (5) and quadrangles (9) only, such as with Extract Surface";
                return Err(MeshError::whole(what, repair));
            }
        }
    }
    if other > 0 {
        raw.notes.push(format!("points and lines, left out: {other}"));
    }
    point_data(&grid, &mut raw)?;
    Ok(raw)
}

/// Three reals called Normals are the normals; whole numbers that are all 0 or 1 mark a set.
fn point_data(grid: &Grid<'_, '_>, raw: &mut Raw) -> Result<(), MeshError> {
    for array in grid.arrays("PointData") {
        let name = array.attribute("Name").unwrap_or_default();
        let components = array.attribute("NumberOfComponents").unwrap_or("1");
        let whole = array.attribute("type").is_some_and(|kind| kind.contains("Int"));
        let normals = ["normals", "normal"].contains(&name.to_lowercase().as_str()) && components == "3";
        let mark = whole && components == "1" && !name.is_empty();
        if !(normals || mark) {
            continue;
        }
        let count = raw.positions.len();
        match grid.numbers(array)? {
            Numbers::Real(values) if normals && values.len() == 3 * count => {
                let vectors = values.as_chunks::<3>().0.iter().map(|&normal| normal.into());
                raw.normals = (0..).zip(vectors).collect();
            }
            Numbers::Whole(marks) if marks.len() == count && marks.iter().all(|m| [0, 1].contains(m)) => {
                let marked = (0..).zip(marks).filter(|(_, mark)| *mark == 1);
                raw.add_to_set(name, &marked.map(|(node, _)| node).collect::<Vec<u32>>());
            }
            _ => {}
        }
    }
    Ok(())
}
