//! The page of a run, from its frames as arrays or from its folder.

use std::path::PathBuf;

use coque::{Array, Column, Curve, RunPage, Sheet};
use numpy::{PyReadonlyArray1, PyReadonlyArray2, PyReadonlyArrayDyn};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::errors::failed;
use crate::leaving::UnderWay;

/// Points, corners, offsets, fields at the points, fields at the cells.
type Body<'py> = (
    PyReadonlyArray2<'py, f64>,
    PyReadonlyArray1<'py, u32>,
    PyReadonlyArray1<'py, u32>,
    Vec<Field<'py>>,
    Vec<Field<'py>>,
);
/// Name, unit, names of the components, rows.
type Field<'py> = (String, Option<String>, Vec<String>, PyReadonlyArrayDyn<'py, f64>);

/// Columns of a curve with their units, and the rows.
type Rows<'py> = (Vec<(String, String)>, PyReadonlyArray2<'py, f64>);

/// Takes frames, one after the other, and makes a page of them.
#[pyclass]
#[derive(Default)]
pub struct Page {
    page: RunPage,
}

#[pymethods]
impl Page {
    #[new]
    fn new() -> Self {
        Self::default()
    }

    /// Begins a frame.
    fn begin(&mut self, along: f64) {
        self.page.begin(along);
    }

    /// Adds a body to the frame that was begun last.
    fn add(&mut self, py: Python<'_>, name: &str, body: Body<'_>) -> PyResult<()> {
        self.page.add(name, &sheet(&body)?).map_err(|error| failed(py, &error))
    }

    /// Names a set of points of a body.
    fn name_set(&mut self, body: &str, name: &str, points: PyReadonlyArray1<'_, u32>) -> PyResult<()> {
        self.page.name_set(body, name, points.as_slice()?.to_vec());
        Ok(())
    }

    /// The text of the page, of at most so many bytes; the page is empty afterwards.
    fn html(
        &mut self,
        py: Python<'_>,
        scene: &str,
        summary: &str,
        curve: Rows<'_>,
        most: usize,
    ) -> PyResult<String> {
        let (columns, rows) = curve;
        let column = |(name, unit)| Column { name, unit };
        let curve = Curve {
            columns: columns.into_iter().map(column).collect(),
            rows: rows.as_array().rows().into_iter().map(|row| row.to_vec()).collect(),
        };
        let summary: serde_json::Value =
            serde_json::from_str(summary).map_err(|error| failed(py, &error.to_string()))?;
        let title = summary["title"].as_str().unwrap_or_default().to_owned();
        let page = std::mem::take(&mut self.page);
        let _under_way = UnderWay::begin(py)?;
        let made = py.detach(|| page.html((scene, &title), curve, Some(&summary), most, 1, None));
        made.map_err(|error| failed(py, &error))
    }
}

/// The page of the run in a folder, of at most so many bytes.
#[pyfunction]
pub fn page_of(py: Python<'_>, folder: PathBuf, most: usize) -> PyResult<String> {
    let _under_way = UnderWay::begin(py)?;
    py.detach(|| coque::page_of(&folder, most, 1, None)).map_err(|error| failed(py, &error))
}

fn sheet((points, corners, offsets, of_points, of_cells): &Body<'_>) -> PyResult<Sheet> {
    let points = points.as_slice()?.as_chunks().0.to_vec();
    let (corners, offsets) = (corners.as_slice()?, offsets.as_slice()?);
    let cell = |ends: &[u32]| -> Option<Vec<usize>> {
        let corners = corners.get(ends[0] as usize..ends[1] as usize)?;
        let point = |&corner: &u32| Some(corner as usize).filter(|&corner| corner < points.len());
        corners.iter().map(point).collect()
    };
    let cells: Option<Vec<Vec<usize>>> = offsets.windows(2).map(cell).collect();
    let cells = cells.ok_or_else(|| PyValueError::new_err("a cell has a corner that is no point"))?;
    let array = |(name, unit, components, rows): &Field<'_>, count: usize| {
        let numbers = rows.as_slice()?;
        let width = numbers.len() / count.max(1);
        if numbers.len() != width * count {
            return Err(PyValueError::new_err(format!(
                "the field {name} has not a row for each point or cell"
            )));
        }
        let array =
            Array { components: components.clone(), unit: unit.clone(), width, numbers: numbers.to_vec() };
        Ok((name.clone(), array))
    };
    let point_data = of_points.iter().map(|field| array(field, points.len())).collect::<PyResult<_>>()?;
    let cell_data = of_cells.iter().map(|field| array(field, cells.len())).collect::<PyResult<_>>()?;
    Ok(Sheet { points, cells, point_data, cell_data, ..Sheet::default() })
}
