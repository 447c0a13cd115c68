//! Runs: with results in memory, into a folder, on from the checkpoint in one.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use coque::{
    Checked, Checkpoint, CheckpointError, FieldSink, GrowingCurve, Kept, Model, Origin, Outcome,
    ResultFolder, RunOptions, SceneError,
};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

use crate::brought::Brought;
use crate::drawn::{Gather, Shown, array};
use crate::errors::{failed, refused};
use crate::outcome::found;
use crate::push::known_to_python;
use crate::watched::{Watch, watched};

/// Values that are replaced in a scene, with their paths.
pub type Replaced = Vec<(String, String)>;

type Sets = BTreeMap<String, BTreeMap<String, Vec<u32>>>;

/// Why there is no outcome.
pub enum Refusal {
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
pub struct Wanted {
    pub threads: usize,
    /// Whether frames are kept; as the scene asks, where nothing is said.
    pub fields: Option<bool>,
    /// Where its results go.
    pub out: Option<PathBuf>,
    /// A function that exerts forces.
    pub push: Option<Py<PyAny>>,
}

/// What a run gives.
pub struct Ran {
    outcome: Outcome,
    frames: Vec<Shown>,
    /// Sets of particles by body and name.
    sets: Sets,
    /// What is said beside the warnings of the scene.
    said: Vec<String>,
}

/// Builds and runs; results go into a folder if there is one.
pub fn ran(
    scene: &Checked,
    text: String,
    origin: &str,
    replaced: Replaced,
    wanted: Wanted,
    watch: &mut Watch,
) -> Result<Ran, Refusal> {
    let Wanted { threads, fields, out, push } = wanted;
    let mut model = shown(scene, fields == Some(true))?.build(threads)?;
    model.task.output.fields = scene.output.fields;
    if let Some(function) = push {
        let by_level = !model.task.analysis.kind().passes_time;
        model.push(watch.exert(function, by_level)).map_err(|error| error.to_string())?;
        model.surround(known_to_python);
    }
    watch.said.extend(model.memory.warning());
    let asked = model.task.output.fields;
    let sets = chosen(&model.sets);
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
            if scene.error.is_some() {
                outcome.summary.errors = Some(scene.errors(&outcome, threads, watch));
            }
            outcome
        }
    };
    let frames = gather.map_or_else(Vec::new, |gather| gather.frames);
    Ok(Ran { outcome, frames, sets, said: std::mem::take(&mut watch.said) })
}

/// The scene as it is built where frames are kept: with its sets beside them.
fn shown(scene: &Checked, keep: bool) -> Result<Cow<'_, Checked>, SceneError> {
    if !keep || scene.output.fields.is_some() {
        return Ok(Cow::Borrowed(scene));
    }
    let mut scene = scene.clone().into_scene();
    scene.output.fields = Some(coque::scene::Fields::MOTION);
    Ok(Cow::Owned(scene.check()?))
}

/// Sets other than that of all particles, as they stand beside the frames of a folder.
fn chosen(sets: &Sets) -> Sets {
    let mut sets = sets.clone();
    sets.values_mut().for_each(|own| drop(own.remove("all")));
    sets
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
    kept(model, &folder, origin, None, sink, watch)
}

/// What became of a run, for Python; what was raised on the way is an entry of it.
///
/// # Errors
/// What was raised, and why there is no outcome, where nothing was found that could be kept.
pub fn reported(
    py: Python<'_>,
    ran: Result<Ran, Refusal>,
    raised: Option<PyErr>,
) -> PyResult<Bound<'_, PyDict>> {
    let ran = match (ran, raised.as_ref()) {
        (Ok(ran), _) => ran,
        (Err(_), Some(raised)) => return Err(raised.clone_ref(py)),
        (Err(refusal), None) => return Err(refusal.raised(py)),
    };
    let found = found(py, &ran.outcome)?;
    let frames = PyList::empty(py);
    for frame in ran.frames {
        frames.append(frame.into_python(py)?)?;
    }
    found.set_item("frames", frames)?;
    found.set_item("sets", sets_of(py, ran.sets)?)?;
    found.set_item("said", ran.said)?;
    found.set_item("raised", raised.map(|raised| raised.into_value(py)))?;
    Ok(found)
}

/// `{body: {set: array}}`.
fn sets_of(py: Python<'_>, sets: Sets) -> PyResult<Bound<'_, PyDict>> {
    let bodies = PyDict::new(py);
    for (body, own) in sets {
        let arrays = PyDict::new(py);
        for (name, particles) in own {
            arrays.set_item(name, array(py, particles, 1)?)?;
        }
        bodies.set_item(body, arrays)?;
    }
    Ok(bodies)
}

/// Goes on with the run in a folder from its checkpoint; threads as before where no number is given.
#[pyfunction]
#[pyo3(signature = (folder, brought, threads, listener))]
pub fn resume<'py>(
    py: Python<'py>,
    folder: PathBuf,
    brought: Brought<'_>,
    threads: Option<usize>,
    listener: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyDict>> {
    let brought = brought.copied()?;
    let work = move |watch: &mut Watch| -> Result<Ran, Refusal> {
        if !folder.is_dir() {
            return Err(CheckpointError::None(folder.display().to_string()).to_string().into());
        }
        let taken = ResultFolder::take(&folder)?;
        watch.said.extend(taken.warning().map(String::from));
        let (checkpoint, text) = Checkpoint::read(&folder).map_err(|error| error.to_string())?;
        let mut origin = checkpoint.origin.clone();
        origin.threads = threads.unwrap_or(origin.threads);
        let scene = coque::Scene::with_overrides(&text, &origin.file, &origin.replaced)?;
        let model = brought.into_scene(scene)?.build(origin.threads)?;
        watch.said.extend(model.memory.warning());
        let sets = chosen(&model.sets);
        let outcome = kept(model, &taken, origin, Some(checkpoint), None, watch)?;
        Ok(Ran { outcome, frames: Vec::new(), sets, said: std::mem::take(&mut watch.said) })
    };
    let (ran, raised) = watched(py, listener, work)?;
    reported(py, ran, raised)
}

/// Runs into a folder that is taken.
fn kept(
    model: Model,
    folder: &ResultFolder,
    origin: Origin,
    from: Option<Checkpoint>,
    sink: Option<&mut dyn FieldSink>,
    watch: &mut Watch,
) -> Result<Outcome, Refusal> {
    watch.curve = Some(GrowingCurve::new(&folder.path().join(ResultFolder::CURVE)));
    let Kept { outcome, written, .. } = model.run_into(folder, origin, from, watch, sink)?;
    written?;
    Ok(outcome)
}
