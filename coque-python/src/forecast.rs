//! Which lattice, method and analysis reach an accuracy.

use std::time::Duration;

use coque::accuracy::{Asked, ClimbError, Forecast};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

use crate::errors::{failed, refused};
use crate::scene::Scene;
use crate::watched::watched;

/// Most lattices of a method.
const LATTICES: usize = 14;

/// A row per method: what it needs, none where that cannot be estimated, and the runs that tell.
#[pyfunction]
pub fn forecast<'py>(
    py: Python<'py>,
    scene: &Scene,
    accuracy: f64,
    within: f64,
    threads: usize,
) -> PyResult<Bound<'py, PyList>> {
    let asked = Asked { accuracy, within: Duration::from_secs_f64(within), lattices: LATTICES, threads };
    let scene = scene.scene.clone();
    let (found, raised) =
        watched(py, None, move |watch| scene.forecast(&asked, &mut |_, _| watch.goes_on()))?;
    if let Some(raised) = raised {
        return Err(raised);
    }
    let found = found.map_err(|error| match error {
        ClimbError::Refused(error) => refused(py, &error),
        ClimbError::Silent(why) => failed(py, &format!("no accuracy can be estimated: {why}")),
    })?;
    let rows = PyList::empty(py);
    for forecast in &found {
        rows.append(row(py, forecast)?)?;
    }
    Ok(rows)
}

fn row<'py>(py: Python<'py>, forecast: &Forecast) -> PyResult<Bound<'py, PyDict>> {
    let Forecast { method, ladder, needed } = forecast;
    let row = PyDict::new(py);
    row.set_item("method", method)?;
    if let Some(needed) = needed {
        row.set_item("lattice", &needed.lattice)?;
        row.set_item("particles", needed.particles)?;
        row.set_item("spacing", needed.spacing)?;
        row.set_item("error", needed.error)?;
        row.set_item("seconds", needed.seconds)?;
        row.set_item("bytes", needed.memory)?;
        row.set_item("ran", needed.ran)?;
    }
    let runs = PyList::empty(py);
    for rung in &ladder.rungs {
        let run = PyDict::new(py);
        run.set_item("lattice", &rung.lattice)?;
        run.set_item("particles", rung.particles)?;
        run.set_item("error", rung.error)?;
        run.set_item("seconds", rung.seconds)?;
        runs.append(run)?;
    }
    row.set_item("runs", runs)?;
    Ok(row)
}
