//! Forces that a function of Python exerts in every step of a run.

use coque::Exert;
use numpy::{PyArray2, PyArrayMethods, PyReadonlyArray2};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// Works on a thread that Python knows from begin to end, and has no hold of the interpreter: each call back then finds the state that
/// Python keeps of a thread. A state made and dropped in each step costs time, and whoever forks meanwhile may find the lock of the list of
/// states taken in the child, for good.
pub fn known_to_python(work: &mut (dyn FnMut() + Send)) {
    if Python::try_attach(|py| py.detach(&mut *work)).is_none() {
        work();
    }
}

/// A function `f(t, x, v)` of Python as one that exerts forces, its `t` a time or, `by_level`, a load level; what it raises goes to `ends`,
/// and the forces of the step before stay.
pub fn exerted(function: Py<PyAny>, by_level: bool, ends: impl Fn(PyErr) + Send + Sync + 'static) -> Exert {
    let mut arrays: Option<[Py<PyArray2<f64>>; 2]> = None;
    let mut ended = false;
    Box::new(move |at, positions, velocities, forces| {
        if ended {
            return;
        }
        let along = if by_level { at.level } else { at.time };
        let call = |py: Python<'_>| -> PyResult<()> {
            let room = || PyArray2::zeros(py, [positions.len(), 3], false).unbind();
            let [x, v] = arrays.get_or_insert_with(|| [room(), room()]);
            for (array, rows) in [(&*x, positions), (&*v, velocities)] {
                array.bind(py).try_readwrite()?.as_slice_mut()?.copy_from_slice(rows.as_flattened());
            }
            let given = function.call1(py, (along, &*x, &*v))?;
            let given = given.extract::<PyReadonlyArray2<'_, f64>>(py)?;
            let rows = given.as_slice()?;
            if rows.len() != 3 * forces.len() {
                let count = forces.len();
                let message = format!("push gave {} numbers; it must give {count} rows of three", rows.len());
                return Err(PyValueError::new_err(message));
            }
            if let Some(at) = rows.iter().position(|force| !force.is_finite()) {
                let name = if by_level { "level" } else { "time" };
                let particle = at / 3;
                let message =
                    format!("push gave particle {particle} a force that is not finite, at {name} {along}");
                return Err(PyValueError::new_err(message));
            }
            forces.as_flattened_mut().copy_from_slice(rows);
            Ok(())
        };
        // Without an interpreter there is nobody to ask, and nobody left to run for.
        if let Some(Err(error)) = Python::try_attach(call) {
            ended = true;
            ends(error);
        }
    })
}
