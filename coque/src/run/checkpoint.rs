//! Checkpoints: all that a run needs to go on as if it had never stopped, bit for bit, in one file.
//!
//! A run that does not ask for them copies nothing and looks at no clock. With `output.checkpoint_every` a marched run
//! writes one at its start, after every settled level, when the interval is over and when it is interrupted; a static
//! run after levels. What a kind of run keeps beside its motion is its [`Place`]; whatever else begins to change while a
//! shell moves belongs into `sph_shell::Shell::motion`.

use std::borrow::Cow;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use explicit_dynamics::MarchState;
use serde::{Deserialize, Serialize};
use sph_core::Vec3;

pub use super::file::CheckpointError;

use crate::Warning;
use crate::bodies::probe::Gauge;
use crate::bodies::shell::build::Model;
use crate::results::summary::{CriticalSummary, Energies, LevelSummary};
use crate::run::{Findings, Shape};

/// Name of the file in the folder of a run.
pub const CHECKPOINT: &str = "checkpoint.bin";
/// Name of the copy of the scene there.
pub const SCENE_COPY: &str = "scene.toml";

/// Where a scene came from and how it is run: what it takes to build the same model again.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Origin {
    /// Version of the program: another one may round differently.
    pub(super) program: String,
    /// Checksum of the text of the scene, without replaced values.
    pub(super) scene: u32,
    /// File of the scene.
    pub file: String,
    /// Values replaced in it, as for [`crate::Scene::with_overrides`].
    pub replaced: Vec<(String, String)>,
    /// Threads.
    pub threads: usize,
}

impl Origin {
    /// Of a scene with this text.
    pub fn new(text: &str, file: String, replaced: Vec<(String, String)>, threads: usize) -> Self {
        let program = env!("CARGO_PKG_VERSION").into();
        Self { program, scene: crc32fast::hash(text.as_bytes()), file, replaced, threads }
    }
}

/// A checkpoint that was read.
pub struct Checkpoint {
    /// What it takes to build the model.
    pub origin: Origin,
    kept: Kept<'static>,
}

/// All that changes while a run goes on, and the checksum of what does not.
#[derive(Serialize, Deserialize)]
pub(super) struct Kept<'a> {
    /// Of the particles at rest, as [`checksum`] finds it.
    model: u32,
    place: Cow<'a, Place>,
    motion: [Cow<'a, [[f64; 6]]>; 2],
    /// Directors and angles of each gauge.
    turned: Vec<Cow<'a, [(Vec3, f64)]>>,
    rows: Cow<'a, [Vec<f64>]>,
    shapes: Cow<'a, [Shape]>,
    levels: Cow<'a, [LevelSummary]>,
    critical: Cow<'a, [CriticalSummary]>,
    warnings: Cow<'a, [Warning]>,
    energies: Energies,
    steps: u64,
    newton_iterations: u64,
    stable_step: f64,
    safety: f64,
    seconds: f64,
    /// Frames of fields that were offered, and those that were taken.
    frames: [u64; 2],
}

/// Where on its way a run is.
#[derive(Clone, Serialize, Deserialize)]
pub(crate) enum Place {
    /// Between two steps in time.
    March(MarchState),
    /// Between two levels without time.
    Levels {
        /// Levels found.
        found: usize,
        /// Level of the path at the last one: the force, for a motion that a force brings about.
        level: f64,
        /// Increment that led there: motion of the unknowns, and level.
        heading: Option<(Vec<f64>, f64)>,
    },
}

impl Checkpoint {
    /// Reads the checkpoint in the folder of a run, and the copy of its scene beside it.
    ///
    /// # Errors
    /// [`CheckpointError`]: no such file, damaged, of another version, of another scene.
    pub fn read(folder: &Path) -> Result<(Self, String), CheckpointError> {
        let (origin, kept, text) = super::file::read(folder)?;
        Ok((Self { origin, kept }, text))
    }

    /// Frames of fields written up to here.
    pub fn frames(&self) -> u64 {
        self.kept.frames[1]
    }

    /// Puts a model where the run stood; gives the place and what had been found.
    pub(crate) fn put_into(
        self,
        model: &mut Model,
        found: &mut Findings<'_>,
    ) -> Result<Place, CheckpointError> {
        let kept = self.kept;
        let width = found.curve.columns.len();
        let [state, rates] = &kept.motion;
        if state.len() == model.shell.len() && kept.model != checksum(model) {
            let surface = model.surface.as_ref().map_or("the mid-surface", |surface| &surface.file);
            return Err(CheckpointError::Surface(surface.into()));
        }
        let fits = kept.turned.len() == model.gauges.len()
            && kept.rows.iter().all(|row| row.len() == width)
            && kept.shapes.iter().all(|shape| shape.positions.len() == model.shell.len())
            && model.shell.take_up([state, rates]);
        if !fits {
            return Err(CheckpointError::Model { particles: state.len(), here: model.shell.len() });
        }
        for (gauge, turned) in model.gauges.iter_mut().zip(kept.turned) {
            gauge.turned = turned.into_owned();
        }
        found.curve.rows = kept.rows.into_owned();
        found.shapes = kept.shapes.into_owned();
        found.levels = kept.levels.into_owned();
        found.critical = kept.critical.into_owned();
        found.warnings = kept.warnings.into_owned();
        (found.energies, found.steps, found.newton_iterations) =
            (kept.energies, kept.steps, kept.newton_iterations);
        (found.stable_step, found.safety, found.seconds) = (kept.stable_step, kept.safety, kept.seconds);
        if let Some(frames) = &mut found.frames {
            [frames.offered, frames.taken] = kept.frames;
        }
        Ok(kept.place.into_owned())
    }
}

/// Checksum of where the particles are and how they are joined at rest, and of the file that tells it, if one does:
/// sets, and so supports and loads, stand there too.
fn checksum(model: &Model) -> u32 {
    let mut sum = crc32fast::Hasher::new();
    let cloud = &model.shell.reference().cloud;
    for x in cloud.positions.iter().flat_map(|position| position.iter()) {
        sum.update(&x.to_le_bytes());
    }
    for corner in cloud.cells.iter().flat_map(|cell| cell.particles()) {
        sum.update(&corner.to_le_bytes());
    }
    if let Some(surface) = &model.surface {
        sum.update(&surface.checksum.to_le_bytes());
    }
    sum.finalize()
}

/// Writes the checkpoints of a run into its folder.
pub struct Checkpoints {
    file: PathBuf,
    origin: Origin,
    /// Checksum of the model that runs.
    model: u32,
    every: Duration,
    begun: Instant,
    last: Option<Instant>,
}

impl Checkpoints {
    /// One at least every so many seconds of wall time.
    pub fn new(folder: &Path, origin: Origin, every: f64) -> Self {
        // Beyond the range of durations there is no second checkpoint.
        let every = Duration::try_from_secs_f64(every).unwrap_or(Duration::MAX);
        Self { file: folder.join(CHECKPOINT), origin, model: 0, every, begun: Instant::now(), last: None }
    }

    /// Takes note of the model that is about to run.
    pub(crate) fn of(&mut self, model: &Model) {
        self.model = checksum(model);
    }

    /// Whether one is to be written now; `asked` where one is wanted at any rate.
    pub(crate) fn due(&self, asked: bool) -> bool {
        asked || self.last.is_none_or(|last| last.elapsed() >= self.every)
    }

    /// Writes one, in the place of the last.
    pub(crate) fn write(
        &mut self,
        place: &Place,
        motion: [&[[f64; 6]]; 2],
        gauges: &[Gauge],
        found: &Findings<'_>,
    ) -> Result<(), CheckpointError> {
        let kept = Kept {
            model: self.model,
            place: Cow::Borrowed(place),
            motion: motion.map(Cow::Borrowed),
            turned: gauges.iter().map(|gauge| Cow::Borrowed(&gauge.turned[..])).collect(),
            rows: Cow::Borrowed(&found.curve.rows),
            shapes: Cow::Borrowed(&found.shapes),
            levels: Cow::Borrowed(&found.levels),
            critical: Cow::Borrowed(&found.critical),
            warnings: Cow::Borrowed(&found.warnings),
            energies: found.energies,
            steps: found.steps,
            newton_iterations: found.newton_iterations,
            stable_step: found.stable_step,
            safety: found.safety,
            seconds: found.seconds + self.begun.elapsed().as_secs_f64(),
            frames: found.frames.as_ref().map_or([0; 2], |frames| [frames.offered, frames.taken]),
        };
        super::file::write(&self.file, &self.origin, &kept)?;
        self.last = Some(Instant::now());
        Ok(())
    }

    /// Takes the file away once the run has come to its end.
    ///
    /// # Errors
    /// [`CheckpointError::Write`].
    pub fn finish(self) -> Result<(), CheckpointError> {
        super::file::remove(&self.file)
    }
}
