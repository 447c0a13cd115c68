//! Frames in memory: [`Sheet`] takes what a [`FieldWriter`] is given, and reads files of frames back.

use std::collections::BTreeMap;
use std::io;
use std::path::Path;

use roxmltree::Node;

use crate::input::read_text;
use crate::vtu::read::Grid;
use crate::vtu::xml::{XmlError, parsed};
use crate::writer::{At, Connectivity, FieldWriter, MOST_COMPONENTS, Rows, Values, in_space, misused};

/// A frame, or a list of frames, that cannot be read.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("cannot read {path}: {reason}")]
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
    /// Numbers of the whole frame, such as its time.
    pub frame_data: BTreeMap<String, f64>,
}

impl Sheet {
    /// Reads a file of a frame.
    ///
    /// # Errors
    /// [`ReadError`] for a file that is missing or no sound frame.
    pub fn read(path: &Path) -> Result<Self, ReadError> {
        let text = read_text(path).map_err(|error| error.to_string());
        text.and_then(|text| Self::parse(&text))
            .map_err(|reason| ReadError { path: path.display().to_string(), reason })
    }

    fn parse(text: &str) -> Result<Self, String> {
        let what = |error: XmlError| error.what;
        let document = parsed(text).map_err(what)?;
        // Where a field is no number it has no colour.
        let grid = Grid::open(&document, |_| true).map_err(what)?;
        let geometry = grid.geometry().map_err(what)?;
        let points = geometry.points().to_vec();
        let point = |&corner: &i64| usize::try_from(corner).ok().filter(|&corner| corner < points.len());
        let cell = |(_, corners): (i64, &[i64])| corners.iter().map(point).collect::<Option<Vec<usize>>>();
        let cells = geometry.cells().map(cell).collect::<Option<Vec<_>>>();
        let cells = cells.ok_or("a cell has a corner that is no point")?;
        let fields = |section: &str, rows: usize| -> Result<BTreeMap<String, Array>, String> {
            grid.arrays(section).map(|node| field(&grid, node, rows)).collect()
        };
        let (point_data, cell_data) = (fields("PointData", points.len())?, fields("CellData", cells.len())?);
        let of_frame = |node| Ok((name_of(node)?, grid.numbers(node).map_err(what)?.real()));
        let of_frame: Vec<(String, Vec<f64>)> =
            grid.arrays_of_frame().map(of_frame).collect::<Result<_, String>>()?;
        let single = |(name, numbers): (String, Vec<f64>)| {
            <[f64; 1]>::try_from(numbers).ok().map(|[number]| (name, number))
        };
        let frame_data = of_frame.into_iter().filter_map(single).collect();
        Ok(Self { points, cells, point_data, cell_data, frame_data })
    }
}

/// A field with its name; as many rows as there are points or cells.
fn field(grid: &Grid<'_, '_>, node: Node<'_, '_>, rows: usize) -> Result<(String, Array), String> {
    let name = name_of(node)?;
    let numbers = grid.numbers(node).map_err(|error| error.what)?.real();
    let width = node.attribute("NumberOfComponents").map_or(Some(1), |text| text.parse().ok());
    let width = width.filter(|width| (1..=MOST_COMPONENTS).contains(width));
    let width = width.ok_or_else(|| format!("the array {name} has no known number of components"))?;
    if numbers.len() != rows * width {
        return Err(format!("the array {name} has not as many rows as there are points or cells"));
    }
    let named = |i: usize| node.attribute(&*format!("ComponentName{i}")).map(String::from);
    let components = (0..width).map_while(named).collect();
    let unit = node.attribute("unit").map(String::from);
    Ok((name, Array { components, unit, width, numbers }))
}

fn name_of(node: Node<'_, '_>) -> Result<String, String> {
    node.attribute("Name").map(String::from).ok_or_else(|| "an array has no name".into())
}

impl FieldWriter for Sheet {
    fn geometry(&mut self, points: &dyn Rows<f64>, cells: Connectivity<'_>) -> io::Result<()> {
        in_space(points)?;
        if !self.points.is_empty() {
            return Err(misused("a frame has one geometry".into()));
        }
        self.points = vec![[0.0; 3]; points.count()];
        points.fill(0, self.points.as_flattened_mut());
        let cell = |number: usize| {
            let (kind, corners) = (cells.cell)(number);
            corners[..kind.corners()].iter().map(|&corner| corner as usize).collect()
        };
        self.cells = (0..cells.count).map(cell).collect();
        Ok(())
    }

    fn numbers(
        &mut self,
        at: At,
        name: &str,
        unit: &str,
        components: &[&str],
        values: Values<'_>,
    ) -> io::Result<()> {
        let (fields, needed) = match at {
            At::Frame => {
                values.check(name, 1)?;
                if let Values::Double(rows) = values
                    && rows.width() == 1
                {
                    self.frame_data.extend(filled(rows).first().map(|&number| (name.into(), number)));
                }
                return Ok(());
            }
            At::Points => (&mut self.point_data, self.points.len()),
            At::Cells => (&mut self.cell_data, self.cells.len()),
        };
        values.check(name, needed)?;
        let width = values.shape().1;
        let array = Array {
            components: components.iter().map(|&component| component.into()).collect(),
            unit: Some(unit).filter(|&unit| unit != "-").map(String::from),
            width,
            numbers: match values {
                Values::Double(rows) => filled(rows),
                Values::Single(rows) => filled(rows).into_iter().map(f64::from).collect(),
            },
        };
        fields.insert(name.into(), array);
        Ok(())
    }
}

/// All numbers, row by row.
fn filled<T: Copy + Default>(rows: &dyn Rows<T>) -> Vec<T> {
    let mut numbers = vec![T::default(); rows.count() * rows.width()];
    rows.fill(0, &mut numbers);
    numbers
}

#[cfg(test)]
mod tests {
    use std::fs;

    use proptest::prelude::*;

    use super::*;
    use crate::Vtu;
    use crate::writer::{Kind, rows};

    /// A quadrangle and a triangle.
    fn write(to: &mut dyn FieldWriter) -> io::Result<()> {
        let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.5], [0.0, 1.0, 0.5], [0.5, 2.0, 0.0]];
        let cells =
            [(Kind::Quadrangle, [0, 1, 2, 3, 0, 0, 0, 0]), (Kind::Triangle, [3, 2, 4, 0, 0, 0, 0, 0])];
        to.numbers(At::Frame, "level", "-", &[], Values::Double(&rows(1, |_| [0.5])))?;
        to.geometry(&rows(5, |i| points[i]), Connectivity { count: 2, cell: &|i| cells[i] })?;
        to.numbers(At::Points, "thickness", "mm", &[], Values::Double(&rows(5, |i| [0.1 * i as f64])))?;
        let moments = rows(2, |i| [1.0 + i as f32, 0.1]);
        to.numbers(At::Cells, "moment", "N mm/mm", &["11", "22"], Values::Single(&moments))
    }

    fn text() -> String {
        let mut file = Vtu::begin(Vec::new()).unwrap();
        write(&mut file).unwrap();
        String::from_utf8(file.end().unwrap()).unwrap()
    }

    #[test]
    fn a_file_reads_as_what_memory_was_given() {
        let mut sheet = Sheet::default();
        write(&mut sheet).unwrap();
        assert_eq!(Sheet::parse(&text()).unwrap(), sheet);
        assert_eq!(sheet.points[2], [1.0, 1.0, 0.5]);
        assert_eq!(sheet.frame_data, [("level".to_string(), 0.5)].into());
        assert_eq!(sheet.cells, [vec![0, 1, 2, 3], vec![3, 2, 4]]);
        let moment = &sheet.cell_data["moment"];
        assert_eq!((moment.width, &moment.components[..]), (2, &["11".to_string(), "22".into()][..]));
        assert_eq!(moment.numbers, [1.0, 0.1_f32.into(), 2.0, 0.1_f32.into()]);
        assert_eq!(moment.unit.as_deref(), Some("N mm/mm"));
        let path = std::env::temp_dir().join(format!("mesh-io-sheet-{}.vtu", std::process::id()));
        fs::write(&path, text()).unwrap();
        assert_eq!(Sheet::read(&path).unwrap(), sheet);
        fs::remove_file(&path).unwrap();
        let missing = Sheet::read(Path::new("no-such-frame.vtu")).unwrap_err().to_string();
        assert!(missing.starts_with("cannot read no-such-frame.vtu"));
    }

    #[test]
    fn both_writers_refuse_the_same() {
        let mut sheet = Sheet::default();
        write(&mut sheet).unwrap();
        assert!(write(&mut sheet).is_err());
        let two = rows(2, |_| [1.0]);
        assert!(sheet.numbers(At::Points, "a", "-", &[], Values::Double(&two)).is_err());
        assert!(sheet.numbers(At::Cells, "a", "-", &[], Values::Double(&two)).is_ok());
        assert!(sheet.numbers(At::Cells, "a", "-", &[], Values::Double(&rows(2, |_| [1.0; 10]))).is_err());
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
            if let Ok(sheet) = Sheet::parse(&letters.into_iter().collect::<String>()) {
                prop_assert!(sheet.cells.iter().flatten().all(|&a| a < sheet.points.len()));
                let fits = |fields: &BTreeMap<String, Array>, rows: usize| {
                    fields.values().all(|field| field.numbers.len() == rows * field.width)
                };
                prop_assert!(fits(&sheet.point_data, sheet.points.len()) && fits(&sheet.cell_data, sheet.cells.len()));
            }
        }
    }
}
