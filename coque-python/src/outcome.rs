//! What a run leaves behind, as text and arrays.

use coque::{Curve, Ended, Outcome, Warning};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::drawn::array;
use crate::errors::failed;

/// Columns with their units, and the rows.
pub fn curve<'py>(py: Python<'py>, curve: &Curve) -> PyResult<Bound<'py, PyAny>> {
    let columns: Vec<(&str, &str)> =
        curve.columns.iter().map(|column| (column.name.as_str(), column.unit.as_str())).collect();
    let rows = array(py, curve.rows.concat(), curve.columns.len())?;
    Ok((columns, rows).into_pyobject(py)?.into_any())
}

/// Words with their messages.
pub fn warnings(warnings: &[Warning]) -> Vec<(&'static str, &str)> {
    warnings.iter().map(|warning| (warning.kind.word(), warning.message.as_str())).collect()
}

/// Curve, summary, warnings and how it ended.
pub fn found<'py>(py: Python<'py>, outcome: &Outcome) -> PyResult<Bound<'py, PyDict>> {
    let found = PyDict::new(py);
    let summary = serde_json::to_string(&outcome.summary);
    found.set_item("curve", curve(py, &outcome.curve)?)?;
    found.set_item("summary", summary.map_err(|error| failed(py, &error.to_string()))?)?;
    found.set_item("warnings", warnings(&outcome.summary.record.warnings))?;
    let ended = match &outcome.ended {
        Ended::Done => "done",
        Ended::Diverged(failure) if failure.is_input() => "refused",
        Ended::Diverged(_) => "diverged",
        Ended::Interrupted { .. } => "interrupted",
    };
    found.set_item("ended", ended)?;
    found.set_item("message", outcome.ended.to_string())?;
    Ok(found)
}
