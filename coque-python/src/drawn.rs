//! Frames as flat arrays, moved into NumPy without a copy.

use std::io;
use std::path::PathBuf;

use coque::{
    Array, At, Connectivity, FieldError, FieldSink, FieldWriter, Frame, FrameFields, Part, Rows, Sheet,
    Values,
};
use numpy::{Element, PyArray1, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

use crate::errors::failed;
use crate::leaving::UnderWay;

/// The numbers of a field, as wide as its body wrote them.
enum Numbers {
    Double(Vec<f64>),
    Single(Vec<f32>),
}

/// A field with its rows.
struct Field {
    at: At,
    name: String,
    unit: Option<String>,
    components: Vec<String>,
    width: usize,
    numbers: Numbers,
}

/// The surface of one body: points, cells end to end, fields.
#[derive(Default)]
pub struct Drawn {
    points: Vec<f64>,
    corners: Vec<u32>,
    /// Where each cell begins among the corners, and where the last one ends.
    offsets: Vec<u32>,
    /// Kinds of the cells, by their numbers in VTK.
    kinds: Vec<u8>,
    fields: Vec<Field>,
}

impl FieldWriter for Drawn {
    fn geometry(&mut self, points: &dyn Rows<f64>, cells: Connectivity<'_>) -> io::Result<()> {
        self.points = filled(points);
        self.offsets = vec![0];
        for number in 0..cells.count {
            let (kind, corners) = (cells.cell)(number);
            self.corners.extend(&corners[..kind.corners()]);
            self.offsets.push(self.corners.len() as u32);
            self.kinds.push(kind as u8);
        }
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
        // Where a frame stands is known to whoever asked for it.
        if at == At::Frame {
            return Ok(());
        }
        let (width, numbers) = match values {
            Values::Double(rows) => (rows.width(), Numbers::Double(filled(rows))),
            Values::Single(rows) => (rows.width(), Numbers::Single(filled(rows))),
        };
        let unit = Some(unit).filter(|&unit| unit != "-").map(String::from);
        let components = components.iter().map(|&component| component.into()).collect();
        self.fields.push(Field { at, name: name.into(), unit, components, width, numbers });
        Ok(())
    }
}

impl From<Sheet> for Drawn {
    fn from(sheet: Sheet) -> Self {
        let Sheet { points, cells, point_data, cell_data, .. } = sheet;
        let mut drawn = Self { points: points.into_flattened(), offsets: vec![0], ..Self::default() };
        for cell in cells {
            drawn.corners.extend(cell.iter().map(|&corner| corner as u32));
            drawn.offsets.push(drawn.corners.len() as u32);
            drawn.kinds.push(kind(cell.len()));
        }
        let field = |at: At| {
            move |(name, array): (String, Array)| {
                let Array { components, unit, width, numbers } = array;
                Field { at, name, unit, components, width, numbers: Numbers::Double(numbers) }
            }
        };
        drawn.fields.extend(point_data.into_iter().map(field(At::Points)));
        drawn.fields.extend(cell_data.into_iter().map(field(At::Cells)));
        drawn
    }
}

/// The kind of cell that has so many corners, by its number in VTK: each that is written has a number of its own.
fn kind(corners: usize) -> u8 {
    use coque::Kind::{Hexahedron, Line, Quadrangle, Triangle, Vertex, Wedge};
    let known = [Vertex, Line, Triangle, Quadrangle, Hexahedron, Wedge];
    known.into_iter().find(|kind| kind.corners() == corners).map_or(0, |kind| kind as u8)
}

/// All numbers, row by row.
fn filled<T: Copy + Default>(rows: &dyn Rows<T>) -> Vec<T> {
    let mut numbers = vec![T::default(); rows.count() * rows.width()];
    rows.fill(0, &mut numbers);
    numbers
}

impl Drawn {
    fn of(fields: &FrameFields<'_>) -> Result<Self, FieldError> {
        let mut drawn = Self::default();
        let written = fields.write(Part::Surface, &mut drawn);
        written.map_err(|error| FieldError { path: "the frame".into(), reason: error.to_string() })?;
        Ok(drawn)
    }

    /// `{"points", "corners", "offsets", "types", "fields": [(at, name, unit, components, numbers)]}`.
    fn into_python(self, py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
        let body = PyDict::new(py);
        body.set_item("points", array(py, self.points, 3)?)?;
        body.set_item("corners", array(py, self.corners, 1)?)?;
        body.set_item("offsets", array(py, self.offsets, 1)?)?;
        body.set_item("types", array(py, self.kinds, 1)?)?;
        let fields = PyList::empty(py);
        for Field { at, name, unit, components, width, numbers } in self.fields {
            let at = if at == At::Cells { "cells" } else { "points" };
            let numbers = match numbers {
                Numbers::Double(numbers) => array(py, numbers, width)?,
                Numbers::Single(numbers) => array(py, numbers, width)?,
            };
            fields.append((at, name, unit, components, numbers))?;
        }
        body.set_item("fields", fields)?;
        Ok(body)
    }
}

/// An array of so many numbers a row; of one number it has one axis.
pub fn array<T: Element>(py: Python<'_>, numbers: Vec<T>, width: usize) -> PyResult<Bound<'_, PyAny>> {
    let count = numbers.len() / width.max(1);
    let flat = PyArray1::from_vec(py, numbers);
    Ok(if width == 1 { flat.into_any() } else { flat.reshape([count, width])?.into_any() })
}

/// A state worth showing, body by body.
pub struct Shown {
    along: f64,
    level: f64,
    time: f64,
    bodies: Vec<(String, Drawn)>,
}

impl Shown {
    /// Evaluates a frame; a body that is alone has the name `lone`.
    ///
    /// # Errors
    /// [`FieldError`] for a body that writes its fields out of their order; none is known.
    pub fn of(frame: &Frame<'_>, lone: &str, stresses: bool) -> Result<Self, FieldError> {
        let Frame { along, level, time, .. } = *frame;
        let names = frame.body.bodies();
        let one = |(number, name): (usize, &&str)| {
            Ok(((*name).to_owned(), Drawn::of(&frame.evaluate_one(number, stresses))?))
        };
        let bodies = match names.is_empty() {
            true => vec![(lone.to_owned(), Drawn::of(&frame.evaluate(stresses))?)],
            false => names.iter().enumerate().map(one).collect::<Result<_, FieldError>>()?,
        };
        Ok(Self { along, level, time, bodies })
    }

    /// `(along, level, time, {name: body})`.
    pub fn into_python(self, py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
        let bodies = PyDict::new(py);
        for (name, drawn) in self.bodies {
            bodies.set_item(name, drawn.into_python(py)?)?;
        }
        Ok((self.along, self.level, self.time, bodies).into_pyobject(py)?.into_any())
    }
}

/// Keeps the frames of a run in memory.
pub struct Gather {
    /// Name of a body that is alone.
    pub lone: String,
    /// Whether stresses are wanted.
    pub stresses: bool,
    /// What was shown so far.
    pub frames: Vec<Shown>,
}

impl FieldSink for Gather {
    fn frame(&mut self, frame: &Frame<'_>) -> Result<(), FieldError> {
        self.frames.push(Shown::of(frame, &self.lone, self.stresses)?);
        Ok(())
    }
}

/// A body in a frame of a file, with level and time.
type Read<'py> = (Option<f64>, Option<f64>, Bound<'py, PyDict>);

/// Reads the file of a frame: level and time, none where an older version wrote it, and the body.
#[pyfunction]
pub fn read_frame(py: Python<'_>, path: PathBuf) -> PyResult<Read<'_>> {
    let _under_way = UnderWay::begin(py)?;
    let sheet = py.detach(|| Sheet::read(&path)).map_err(|error| failed(py, &error.to_string()))?;
    let of_frame = |name: &str| sheet.frame_data.get(name).copied();
    let (level, time) = (of_frame("level"), of_frame("time"));
    Ok((level, time, Drawn::from(sheet).into_python(py)?))
}
