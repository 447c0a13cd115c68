//! Frames read back: the files that [`super::FieldFiles`] writes, and no others.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use roxmltree::{Document, Node};

use crate::input::read_text;
use crate::xml;

use super::Frame;
use super::content::{Content, results};
use super::vtu::Vtu;

/// Numbers a row of any field.
const MOST_COMPONENTS: usize = 9;

/// A frame that cannot be read.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("cannot read {path}: {reason}; run the scene again with [output.fields]")]
pub struct ReadError {
    /// The file.
    pub path: String,
    /// What is wrong with it.
    pub reason: String,
}

/// Numbers in rows of equal length.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Array {
    /// Names of the components; empty for x, y, z and for a single number.
    pub components: Vec<String>,
    /// Unit of the numbers, such as `N/mm²`; none for ratios, and where the scene has no units.
    pub unit: Option<String>,
    /// Numbers a row, at least one.
    pub width: usize,
    /// All numbers, row by row.
    pub numbers: Vec<f64>,
}

/// One frame of a sheet.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sheet {
    /// Present positions \[L\].
    pub points: Vec<[f64; 3]>,
    /// Points of each cell, in order round it.
    pub cells: Vec<Vec<usize>>,
    /// Fields at the points.
    pub point_data: BTreeMap<String, Array>,
    /// Fields at the cells.
    pub cell_data: BTreeMap<String, Array>,
}

/// The frames that a list names: what they run along, and their files.
///
/// # Errors
/// [`ReadError`] for a list that is missing or no list.
pub fn listed(list: &Path) -> Result<Vec<(f64, PathBuf)>, ReadError> {
    within(list, |document| {
        let sets = document.descendants().filter(|node| node.has_tag_name("DataSet"));
        sets.map(|set| {
            let along = set.attribute("timestep").and_then(|text| text.parse().ok());
            let along = along.ok_or("a frame has no timestep")?;
            let file = set.attribute("file").ok_or("a frame has no file")?;
            Ok((along, list.with_file_name(file)))
        })
        .collect()
    })
}

impl Sheet {
    /// What [`super::FieldFiles`] writes of a frame, without a file.
    ///
    /// # Errors
    /// [`ReadError`]; none is known for a frame of a run.
    pub fn of(frame: &Frame<'_>, stresses: bool) -> Result<Self, ReadError> {
        let refused = |reason: String| ReadError { path: "the frame".into(), reason };
        let mut room = Vec::new();
        let stresses = stresses && frame.has_forces();
        let content = Content { frame, results: stresses.then(|| results(frame, &mut room)) };
        let written = Vtu::begin(Vec::new()).and_then(|mut file| {
            content.sheet(&mut file)?;
            file.end()
        });
        let text = written.map_err(|error| error.to_string());
        let text = text.and_then(|bytes| String::from_utf8(bytes).map_err(|error| error.to_string()));
        text.and_then(|text| parsed(&text, Self::from_document)).map_err(refused)
    }

    /// Reads a frame.
    ///
    /// # Errors
    /// [`ReadError`] for a file that is missing or not as this library writes it.
    pub fn read(path: &Path) -> Result<Self, ReadError> {
        within(path, Self::from_document)
    }

    fn from_document(document: &Document<'_>) -> Result<Self, String> {
        let section = |name: &str| {
            let found = document.descendants().find(|node| node.has_tag_name(name));
            found.map_or_else(|| Ok(BTreeMap::new()), arrays)
        };
        let (mut places, cells) = (section("Points")?, section("Cells")?);
        let places = places.remove("Points").filter(|array| array.width == 3).ok_or("it has no points")?;
        let points: Vec<[f64; 3]> =
            places.numbers.chunks_exact(3).map(|row| [row[0], row[1], row[2]]).collect();
        let cells = polygons(&cells, points.len())?;
        let sheet =
            Self { points, cells, point_data: section("PointData")?, cell_data: section("CellData")? };
        let fits = |data: &BTreeMap<String, Array>, rows: usize| {
            data.values().all(|array| array.numbers.len() == rows * array.width)
        };
        if fits(&sheet.point_data, sheet.points.len()) && fits(&sheet.cell_data, sheet.cells.len()) {
            Ok(sheet)
        } else {
            Err("a field has not as many rows as there are points or cells".into())
        }
    }
}

/// Opens a file as XML and names it in whatever goes wrong.
fn within<T>(path: &Path, read: impl FnOnce(&Document<'_>) -> Result<T, String>) -> Result<T, ReadError> {
    let text = read_text(path).map_err(|error| error.to_string());
    text.and_then(|text| parsed(&text, read))
        .map_err(|reason| ReadError { path: path.display().to_string(), reason })
}

fn parsed<T>(text: &str, read: impl FnOnce(&Document<'_>) -> Result<T, String>) -> Result<T, String> {
    xml::parsed(text).map_err(|error| error.what).and_then(|document| read(&document))
}

fn arrays(section: Node<'_, '_>) -> Result<BTreeMap<String, Array>, String> {
    let arrays = section.children().filter(|node| node.has_tag_name("DataArray"));
    arrays
        .map(|node| {
            let name = node.attribute("Name").ok_or("an array has no name")?;
            Ok((name.to_string(), array(node).ok_or_else(|| format!("the array {name} is damaged"))?))
        })
        .collect()
}

fn array(node: Node<'_, '_>) -> Option<Array> {
    let bytes = STANDARD.decode(node.text()?.trim()).ok()?;
    let (length, data) = bytes.split_first_chunk::<8>()?;
    if u64::from_le_bytes(*length) != data.len() as u64 {
        return None;
    }
    let numbers: Vec<f64> = match node.attribute("type")? {
        "Float64" => data.as_chunks().0.iter().map(|&bytes| f64::from_le_bytes(bytes)).collect(),
        "Float32" => data.as_chunks().0.iter().map(|&bytes| f32::from_le_bytes(bytes).into()).collect(),
        "Int32" => data.as_chunks().0.iter().map(|&bytes| i32::from_le_bytes(bytes).into()).collect(),
        "UInt8" => data.iter().map(|&byte| byte.into()).collect(),
        _ => return None,
    };
    let width = node.attribute("NumberOfComponents").map_or(Some(1), |text| text.parse().ok())?;
    let components = (0..MOST_COMPONENTS)
        .map_while(|i| node.attribute(&*format!("ComponentName{i}")).map(String::from))
        .collect();
    ((1..=MOST_COMPONENTS).contains(&width) && numbers.len().is_multiple_of(width)).then_some(Array {
        components,
        unit: node.attribute("unit").map(String::from),
        width,
        numbers,
    })
}

/// Cells from the corners in a row and their ends; every corner is a point.
fn polygons(cells: &BTreeMap<String, Array>, points: usize) -> Result<Vec<Vec<usize>>, String> {
    let list = |name: &str| cells.get(name).map(|array| &array.numbers[..]).ok_or("it has no cells");
    let (corners, ends) = (list("connectivity")?, list("offsets")?);
    let mut first = 0;
    ends.iter()
        .map(|&end| {
            let own = corners.get(first..end as usize).ok_or("a cell has no corners")?;
            first = end as usize;
            if own.iter().any(|&corner| corner < 0.0 || corner as usize >= points) {
                return Err("a cell has a corner that is no point".to_string());
            }
            Ok(own.iter().map(|&corner| corner as usize).collect())
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use std::fs;

    use proptest::prelude::*;

    use super::*;

    /// A triangle and a quadrangle, as the writer puts them.
    fn text() -> String {
        let mut file = Vtu::begin(Vec::new()).unwrap();
        let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.5], [0.0, 1.0, 0.5], [0.5, 2.0, 0.0]];
        file.line("<Piece NumberOfPoints=\"5\" NumberOfCells=\"2\">\n<Points>").unwrap();
        file.rows("Points", "mm", [""; 3], points.into_iter()).unwrap();
        file.line("</Points>\n<Cells>").unwrap();
        file.list("connectivity", "-", [0, 1, 2, 3, 3, 2, 4].into_iter()).unwrap();
        file.list("offsets", "-", [4, 7].into_iter()).unwrap();
        file.list("types", "-", [9_u8, 5].into_iter()).unwrap();
        file.line("</Cells>\n<PointData>\n</PointData>\n<CellData>").unwrap();
        file.rows("moment", "N mm/mm", ["11", "22"], [[1.0, 2.0], [3.0, 4.0]].into_iter()).unwrap();
        file.line("</CellData>\n</Piece>").unwrap();
        String::from_utf8(file.end().unwrap()).unwrap()
    }

    fn read(name: &str, text: &str) -> Result<Sheet, ReadError> {
        let path = std::env::temp_dir().join(format!("coque-read-{name}-{}.vtu", std::process::id()));
        fs::write(&path, text).unwrap();
        let sheet = Sheet::read(&path);
        fs::remove_file(&path).unwrap();
        sheet
    }

    #[test]
    fn what_was_written_is_read() {
        let sheet = read("whole", &text()).unwrap();
        assert_eq!(sheet.points[2], [1.0, 1.0, 0.5]);
        assert_eq!(sheet.cells, [vec![0, 1, 2, 3], vec![3, 2, 4]]);
        let moment = &sheet.cell_data["moment"];
        assert_eq!((moment.width, &moment.components[..]), (2, &["11".to_string(), "22".into()][..]));
        assert_eq!(moment.numbers, [1.0, 2.0, 3.0, 4.0]);
        assert_eq!(moment.unit.as_deref(), Some("N mm/mm"));
        let missing = Sheet::read(Path::new("no-such-frame.vtu")).unwrap_err().to_string();
        assert!(missing.starts_with("cannot read no-such-frame.vtu") && missing.contains("[output.fields]"));
    }

    proptest! {
        // The same damage on every run.
        #![proptest_config(ProptestConfig {
            cases: 512,
            rng_seed: proptest::test_runner::RngSeed::Fixed(1),
            failure_persistence: None,
            ..ProptestConfig::default()
        })]

        #[test]
        fn damaged_frames_are_refused_or_sound(at in any::<usize>(), with in "[0-9A-Za-z<>=\"/ -]{0,3}", cut in 0..4_usize) {
            let mut letters: Vec<char> = text().chars().collect();
            let at = at % letters.len();
            letters.splice(at..(at + cut).min(letters.len()), with.chars());
            let damaged: String = letters.into_iter().collect();
            if let Ok(sheet) = read("damaged", &damaged) {
                prop_assert!(sheet.cells.iter().flatten().all(|&a| a < sheet.points.len()));
                let _ = crate::picture_svg(&sheet, &crate::Picture::new(""));
            }
        }
    }
}
