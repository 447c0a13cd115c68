//! A checked scene: what may be asked of it, and its run.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use coque::mesh::Arrays;
use coque::{
    Checked, FieldSink, GrowingCurve, Kept, Model, Origin, Outcome, ResultFolder, RunOptions, SceneError,
    listed, schema_text,
};
use numpy::{PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

use crate::drawn::{Gather, Shown};
use crate::errors::{failed, refused};
use crate::outcome::{found, warnings};
use crate::steps::Simulation;
use crate::watched::{Watch, watched};

type Replaced = Vec<(String, String)>;
type Sets<'py> = BTreeMap<String, PyReadonlyArray1<'py, u32>>;
/// Points, faces, sets of points, sets of faces.
type Mesh<'py> = (PyReadonlyArray2<'py, f64>, PyReadonlyArray2<'py, u32>, Sets<'py>, Sets<'py>);

/// A scene that has passed every check that needs no particles.
#[pyclass(frozen)]
pub struct Scene {
    scene: Checked,
    text: String,
    origin: String,
    replaced: Replaced,
}

/// Why there is no outcome.
enum Refusal {
    Scene(Box<SceneError>),
    Else(String),
}

impl From<String> for Refusal {
    fn from(message: String) -> Self {
        Self::Else(message)
    }
}

impl From<SceneError> for Refusal {
    fn from(error: SceneError) -> Self {
        Self::Scene(Box::new(error))
    }
}

impl Refusal {
    fn raised(&self, py: Python<'_>) -> PyErr {
        match self {
            Self::Scene(error) => refused(py, error),
            Self::Else(message) => failed(py, message),
        }
    }
}

/// What a run is given beside its scene.
struct Wanted {
    threads: usize,
    /// Whether frames are kept; as the scene asks, where nothing is said.
    fields: Option<bool>,
    out: Option<PathBuf>,
}

/// What a run gives.
struct Ran {
    outcome: Outcome,
    frames: Vec<Shown>,
    /// What is said beside the warnings of the scene.
    said: Vec<String>,
}

#[pymethods]
impl Scene {
    /// Reads and checks a text in which some values are replaced; `meshes` are those that it calls by name.
    #[new]
    fn new(
        py: Python<'_>,
        text: String,
        origin: String,
        replaced: Replaced,
        meshes: BTreeMap<String, Mesh<'_>>,
    ) -> PyResult<Self> {
        let named = |(name, mesh)| Ok((name, Arc::new(arrays(&mesh)?)));
        let surfaces = meshes.into_iter().map(named).collect::<PyResult<_>>()?;
        let scene = py.detach(|| {
            let scene = coque::Scene::with_overrides(&text, &origin, &replaced)?.into_scene();
            coque::Scene { surfaces, ..scene }.check()
        });
        let scene = scene.map_err(|error| refused(py, &error))?;
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

    /// Runs it: curve, summary, warnings, how it ended; `frames`, `said`, and `raised`, what ended it from outside.
    #[pyo3(signature = (threads, listener, fields, out))]
    fn run<'py>(
        &self,
        py: Python<'py>,
        threads: usize,
        listener: Option<&Bound<'py, PyAny>>,
        fields: Option<bool>,
        out: Option<PathBuf>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let Self { scene, text, origin, replaced } = self;
        let (scene, text, origin, replaced) = (scene.clone(), text.clone(), origin.clone(), replaced.clone());
        let wanted = Wanted { threads, fields, out };
        let work = move |watch: &mut Watch| ran(&scene, text, &origin, replaced, wanted, watch);
        let (ran, raised) = watched(py, listener, work)?;
        let ran = match (ran, raised.as_ref()) {
            (Ok(ran), _) => ran,
            // Nothing was found that could be kept.
            (Err(_), Some(raised)) => return Err(raised.clone_ref(py)),
            (Err(refusal), None) => return Err(refusal.raised(py)),
        };
        let found = found(py, &ran.outcome)?;
        let frames = PyList::empty(py);
        for frame in ran.frames {
            frames.append(frame.into_python(py)?)?;
        }
        found.set_item("frames", frames)?;
        found.set_item("said", ran.said)?;
        found.set_item("raised", raised.map(|raised| raised.into_value(py)))?;
        Ok(found)
    }

    /// Builds it, to be led event by event.
    fn simulation(&self, py: Python<'_>, threads: usize) -> PyResult<Simulation> {
        let begun = py.detach(|| {
            let model = self.scene.build(threads)?;
            let lone = model.description.kind.to_owned();
            Ok(Simulation::new(coque::Simulation::new(model), lone))
        });
        begun.map_err(|error: SceneError| refused(py, &error))
    }
}

/// A mesh of NumPy's arrays.
fn arrays((points, faces, sets, face_sets): &Mesh<'_>) -> PyResult<Arrays> {
    let lists = |sets: &Sets<'_>| {
        let list = |(name, numbers): (&String, &PyReadonlyArray1<'_, u32>)| {
            Ok((name.clone(), numbers.as_slice()?.to_vec()))
        };
        sets.iter().map(list).collect::<PyResult<_>>()
    };
    Ok(Arrays {
        points: points.as_slice()?.as_chunks().0.to_vec(),
        faces: faces.as_slice()?.as_chunks().0.to_vec(),
        sets: lists(sets)?,
        face_sets: lists(face_sets)?,
    })
}

/// Builds and runs; results go into a folder if there is one.
fn ran(
    scene: &Checked,
    text: String,
    origin: &str,
    replaced: Replaced,
    wanted: Wanted,
    watch: &mut Watch,
) -> Result<Ran, Refusal> {
    let Wanted { threads, fields, out } = wanted;
    let model = scene.build(threads)?;
    watch.said.extend(model.memory.warning());
    let asked = model.task.output.fields;
    let keep = fields.unwrap_or(asked.is_some());
    let stresses = asked.is_some_and(|asked| asked.stresses);
    let mut gather =
        keep.then(|| Gather { lone: model.description.kind.into(), stresses, frames: Vec::new() });
    let sink = gather.as_mut().map(|gather| gather as &mut dyn FieldSink);
    let outcome = match out {
        Some(out) => into_folder(model, &out, (text, origin, replaced, threads), sink, watch)?,
        None => {
            let options = RunOptions { progress: watch, checkpoints: None, fields: sink, from: None };
            let mut outcome = model.run_with(options).map_err(|error| error.to_string())?;
            outcome.summary.replaced =
                replaced.iter().map(|(path, value)| format!("{path}={value}")).collect();
            outcome
        }
    };
    let frames = gather.map_or_else(Vec::new, |gather| gather.frames);
    Ok(Ran { outcome, frames, said: std::mem::take(&mut watch.said) })
}

/// The same as `coque run` does with a folder.
fn into_folder(
    model: Model,
    out: &Path,
    (text, origin, replaced, threads): (String, &str, Replaced, usize),
    sink: Option<&mut dyn FieldSink>,
    watch: &mut Watch,
) -> Result<Outcome, Refusal> {
    let folder = ResultFolder::take(out)?;
    watch.said.extend(folder.warning().map(String::from));
    let text = folder.begin(Path::new(origin), text, &replaced)?;
    // Another folder may be the present one when the run goes on.
    let file = std::path::absolute(origin).unwrap_or_else(|_| origin.into());
    let origin = Origin::new(&text, file.display().to_string(), replaced, threads);
    watch.curve = Some(GrowingCurve::new(&out.join(ResultFolder::CURVE)));
    let Kept { outcome, written, .. } = model.run_into(&folder, origin, None, watch, sink)?;
    written?;
    Ok(outcome)
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
