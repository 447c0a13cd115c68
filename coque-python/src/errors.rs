//! Refusals of the core as the exceptions of the package.

use coque::{Rendering, SceneError, render};
use pyo3::prelude::*;

/// Columns of the drawing of a refusal.
const WIDTH: usize = 100;

/// `coque.SceneError` with key, value, bound, repair, place and drawing.
pub fn refused(py: Python<'_>, error: &SceneError) -> PyErr {
    let fault = error.fault();
    let (line, column) = match &fault.place.span {
        Some(span) => {
            let before = fault.place.text.get(..span.start).unwrap_or_default();
            let start = before.rfind('\n').map_or(0, |at| at + 1);
            (Some(before.matches('\n').count() + 1), Some(before[start..].chars().count() + 1))
        }
        None => (None, None),
    };
    let drawn = render(error, Rendering { width: WIDTH, colour: false });
    let of_fault = (&fault.key, &fault.value, &fault.bound, &fault.repair);
    let place = (&*fault.place.origin, line, column);
    raised(py, "SceneError", (error.to_string(), error.code(), of_fault, place, drawn))
}

/// `coque.CoqueError` with a message.
pub fn failed(py: Python<'_>, message: &str) -> PyErr {
    raised(py, "CoqueError", (message.trim_end(),))
}

/// An exception of the package; what keeps it from being made is raised in its place.
fn raised<'py>(py: Python<'py>, class: &str, arguments: impl pyo3::call::PyCallArgs<'py>) -> PyErr {
    let made = || py.import("coque._errors")?.getattr(class)?.call1(arguments);
    made().map_or_else(|error| error, PyErr::from_value)
}
