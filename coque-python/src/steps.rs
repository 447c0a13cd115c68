//! A run that Python leads event by event.

use std::sync::{Mutex, PoisonError};
use std::time::Instant;

use coque::{Event, Failure};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::drawn::Shown;
use crate::errors::failed;
use crate::leaving::UnderWay;
use crate::outcome::{curve, found};
use crate::watched::INTERVAL;

/// A run under way; none once it is finished.
#[pyclass(frozen)]
pub struct Simulation {
    inner: Mutex<Option<coque::Simulation<'static>>>,
    lone: String,
}

impl Simulation {
    pub(crate) fn new(simulation: coque::Simulation<'static>, lone: String) -> Self {
        Self { inner: Mutex::new(Some(simulation)), lone }
    }

    /// Works on the run without the interpreter.
    fn with<T: Send>(
        &self,
        py: Python<'_>,
        work: impl FnOnce(&mut coque::Simulation<'static>) -> T + Send,
    ) -> PyResult<T> {
        let _under_way = UnderWay::begin(py)?;
        let worked = py.detach(|| {
            let mut inner = self.inner.lock().unwrap_or_else(PoisonError::into_inner);
            inner.as_mut().map(work)
        });
        worked.ok_or_else(|| failed(py, "the run is over"))
    }
}

#[pymethods]
impl Simulation {
    /// Goes on to the next event, with `records` to the next record: `(event, time, level)`.
    fn advance(&self, py: Python<'_>, records: bool) -> PyResult<(&'static str, f64, f64)> {
        loop {
            let on = |simulation: &mut coque::Simulation<'static>| -> Result<_, Box<Failure>> {
                let begun = Instant::now();
                loop {
                    let event = simulation.advance()?;
                    if !records || event != Event::Step || begun.elapsed() >= INTERVAL {
                        return Ok((event, simulation.stands_at()));
                    }
                }
            };
            let event = self.with(py, on)?;
            py.check_signals()?;
            let (event, at) = match event {
                Ok(event) => event,
                Err(_) => return Ok(("failed", 0.0, 0.0)),
            };
            let word = match event {
                Event::Step if records => continue,
                Event::Step => "step",
                Event::Record => "record",
                Event::End => "end",
            };
            return Ok((word, at.time, at.level));
        }
    }

    /// The body as it is now: `(along, level, time, {name: body})`.
    fn frame<'py>(&self, py: Python<'py>, stresses: bool) -> PyResult<Bound<'py, PyAny>> {
        let shown = self.with(py, |simulation| Shown::of(&simulation.frame(), &self.lone, stresses))?;
        shown.map_err(|error| failed(py, &error.to_string()))?.into_python(py)
    }

    /// The curve so far.
    fn curve<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let so_far = self.with(py, |simulation| simulation.curve().clone())?;
        curve(py, &so_far)
    }

    /// Ends it where it stands.
    fn finish<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let _under_way = UnderWay::begin(py)?;
        let taken = py.detach(|| {
            let taken = self.inner.lock().unwrap_or_else(PoisonError::into_inner).take();
            taken.map(coque::Simulation::finish)
        });
        found(py, &taken.ok_or_else(|| failed(py, "the run is over"))?)
    }
}
