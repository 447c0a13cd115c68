//! A checked scene: what may be asked of it, and its run.

use std::path::PathBuf;

use coque::{Checked, SceneError, listed, schema_text};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::brought::Brought;
use crate::drawn::array;
use crate::errors::{failed, refused};
use crate::leaving::UnderWay;
use crate::outcome::warnings;
use crate::running::{Replaced, Wanted, ran, reported};
use crate::steps::Simulation;
use crate::watched::watched;

/// A scene that has passed every check that needs no particles.
#[pyclass(frozen)]
pub struct Scene {
    pub(crate) scene: Checked,
    text: String,
    origin: String,
    replaced: Replaced,
}

#[pymethods]
impl Scene {
    /// Reads and checks a text in which some values are replaced; `brought` is what it calls by name.
    #[new]
    fn new(
        py: Python<'_>,
        text: String,
        origin: String,
        replaced: Replaced,
        brought: Brought<'_>,
    ) -> PyResult<Self> {
        let brought = brought.copied()?;
        let _under_way = UnderWay::begin(py)?;
        let scene =
            py.detach(|| brought.into_scene(coque::Scene::with_overrides(&text, &origin, &replaced)?));
        let scene = scene.map_err(|error| refused(py, &error))?;
        let text =
            coque::Scene::whole_text(&text, &origin, &replaced).map_err(|error| refused(py, &error))?;
        Ok(Self { scene, text, origin, replaced })
    }

    /// Its title.
    #[getter]
    fn title(&self) -> &str {
        &self.scene.title
    }

    /// Its analysis, as scenes call it.
    #[getter]
    fn analysis(&self) -> &'static str {
        self.scene.analysis.word()
    }

    /// Builds it: `{"model": text, "warnings": [(word, message)], "cost": {…}}`.
    fn check<'py>(&self, py: Python<'py>, cost: bool, threads: usize) -> PyResult<Bound<'py, PyDict>> {
        let _under_way = UnderWay::begin(py)?;
        let built = py.detach(|| {
            let model = self.scene.build(threads)?;
            let (described, warned) = (model.describe(), model.warnings().to_vec());
            Ok((described, warned, cost.then(|| model.estimate())))
        });
        let (described, warned, estimate) = built.map_err(|error: SceneError| refused(py, &error))?;
        let found = PyDict::new(py);
        let text = serde_json::to_string(&described).map_err(|error| failed(py, &error.to_string()))?;
        found.set_item("model", text)?;
        found.set_item("warnings", warnings(&warned))?;
        if let Some(estimate) = estimate {
            let cost = PyDict::new(py);
            cost.set_item("stable_step", estimate.stable_step)?;
            cost.set_item("steps", estimate.steps)?;
            cost.set_item("seconds_a_step", estimate.seconds_a_step)?;
            cost.set_item("solves", estimate.solves)?;
            cost.set_item("seconds", estimate.seconds)?;
            cost.set_item("bytes", estimate.bytes)?;
            found.set_item("cost", cost)?;
        }
        Ok(found)
    }

    /// Builds it: the places of all particles at rest.
    fn points<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let under_way = UnderWay::begin(py)?;
        let built = py.detach(|| {
            let model = self.scene.build(1)?;
            let rest = model.body.body().configuration().rest;
            Ok(rest.iter().flat_map(|x| <[f64; 3]>::from(*x)).collect())
        });
        drop(under_way);
        array(py, built.map_err(|error: SceneError| refused(py, &error))?, 3)
    }

    /// Runs it: curve, summary, warnings, how it ended; `frames`, `said`, and `raised`, what ended it from outside.
    #[pyo3(signature = (threads, listener, fields, out, push))]
    fn run<'py>(
        &self,
        py: Python<'py>,
        threads: usize,
        listener: Option<&Bound<'py, PyAny>>,
        fields: Option<bool>,
        out: Option<PathBuf>,
        push: Option<Py<PyAny>>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let Self { scene, text, origin, replaced } = self;
        let (scene, text, origin, replaced) = (scene.clone(), text.clone(), origin.clone(), replaced.clone());
        let wanted = Wanted { threads, fields, out, push };
        let (ran, raised) =
            watched(py, listener, move |watch| ran(&scene, text, &origin, replaced, wanted, watch))?;
        reported(py, ran, raised)
    }

    /// Builds it, to be led event by event.
    fn simulation(&self, py: Python<'_>, threads: usize) -> PyResult<Simulation> {
        let _under_way = UnderWay::begin(py)?;
        let begun = py.detach(|| {
            let model = self.scene.build(threads)?;
            let lone = model.description.kind.to_owned();
            Ok(Simulation::new(coque::Simulation::new(model), lone))
        });
        begun.map_err(|error: SceneError| refused(py, &error))
    }
}

/// The JSON schema of scenes.
#[pyfunction]
pub fn schema() -> String {
    schema_text()
}

/// The frames that a list names: where each stands, and its file.
#[pyfunction]
pub fn frames_listed(py: Python<'_>, path: PathBuf) -> PyResult<Vec<(f64, PathBuf)>> {
    listed(&path).map_err(|error| failed(py, &error.to_string()))
}
