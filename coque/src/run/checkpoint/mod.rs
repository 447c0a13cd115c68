//! Checkpoints: all that a run needs to go on as if it had never stopped, bit for bit.
//!
//! A run that does not ask for them copies nothing and looks at no clock. With `output.checkpoint_every` a marched run
//! writes one at its start, after every settled level, when the interval is over and when it is interrupted; a static
//! run after levels. What a kind of run keeps beside the state of its body is its [`Stage`]; whatever else begins to
//! change while a body moves belongs into [`Body::state`].
//!
//! Two files: [`CHECKPOINT`] is replaced as a whole, rows and shapes are appended to [`CHECKPOINT_ROWS`], and how
//! much of that counts stands in the first.

mod file;
mod log;

use std::borrow::Cow;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use explicit_dynamics::MarchState;
use implicit_statics::RelaxationMemory;
use serde::{Deserialize, Serialize};
use sph_core::Vec3;

pub use file::CheckpointError;
use log::GrowingLog;
pub(crate) use log::Grown;

use super::impulses::Impulses;
use super::record::RunRecord;
use crate::bodies::{Body, Configuration, Identity, Resultant, Shape, StateArray};

/// Name of the file in the folder of a run.
pub const CHECKPOINT: &str = "checkpoint.bin";
/// Name of the file of rows and shapes beside it.
pub const CHECKPOINT_ROWS: &str = "checkpoint.rows";
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
    pub(crate) kept: Contents<'static>,
    pub(crate) grown: Grown,
}

/// All that changes while a run goes on, rows and shapes apart, and the checksum of what does not.
#[derive(Serialize, Deserialize)]
pub(crate) struct Contents<'a> {
    /// Of the body at rest, as [`checksum`] finds it.
    pub(crate) body: u32,
    pub(crate) particles: usize,
    pub(crate) stage: Cow<'a, Stage>,
    pub(crate) state: Vec<StateArray<'a>>,
    /// Directors and angles of each probe.
    pub(crate) turns: Vec<Cow<'a, [(Vec3, f64)]>>,
    pub(crate) impulses: Cow<'a, Impulses>,
    /// What the supports exerted at the last record.
    pub(crate) supports: Option<Resultant>,
    /// Steps done when contact was last looked for.
    pub(crate) looked: u64,
    pub(crate) record: Cow<'a, RunRecord>,
    pub(crate) latest: Option<Cow<'a, Shape>>,
    /// Frames of fields that were offered.
    pub(crate) offered: u64,
    /// Bytes of the file of rows and shapes that count.
    pub(crate) rows: u64,
}

/// Where on its way a run is.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) enum Stage {
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
        /// Stiffness that each unknown first had on the path.
        stiffness: Option<Vec<f64>>,
    },
    /// Between two levels of a relaxation.
    Relaxation {
        /// Levels found.
        found: usize,
        /// What it knows there.
        memory: Box<RelaxationMemory>,
    },
    /// Before a preload, which is applied anew.
    Preload,
}

impl Checkpoint {
    /// Reads the checkpoint in the folder of a run, and the copy of its scene beside it.
    ///
    /// # Errors
    /// [`CheckpointError`]: no such file, damaged, of another version, of another scene.
    pub fn read(folder: &Path) -> Result<(Self, String), CheckpointError> {
        let (origin, kept, text) = file::read(folder)?;
        let grown = log::read(&folder.join(CHECKPOINT_ROWS), kept.rows)?;
        Ok((Self { origin, kept, grown }, text))
    }

    /// Checksum of where it stands, for those who go on from copies of it.
    pub(crate) fn checksum(&self) -> u32 {
        let bytes = postcard::to_stdvec(&(&self.kept.state, &self.kept.stage));
        bytes.map_or(0, |bytes| crc32fast::hash(&bytes))
    }

    /// Frames of fields written up to here.
    pub fn frames(&self) -> u64 {
        self.kept.record.frames
    }
}

/// Checksum of where the particles are and how they are joined at rest, and of the file that tells it, if one does:
/// sets, and so supports and loads, stand there too.
pub(crate) fn checksum(body: &dyn Body, identity: &Identity) -> u32 {
    let mut sum = crc32fast::Hasher::new();
    let Configuration { rest, cells, .. } = body.configuration();
    for x in rest.iter().flat_map(|position| position.iter()) {
        sum.update(&x.to_le_bytes());
    }
    for corner in cells.iter().flat_map(|cell| cell.particles()) {
        sum.update(&corner.to_le_bytes());
    }
    if let Some(file) = identity.checksum {
        sum.update(&file.to_le_bytes());
    }
    sum.finalize()
}

/// Writes the checkpoints of a run into its folder.
pub struct Checkpoints {
    file: PathBuf,
    origin: Origin,
    /// Checksum of the body that runs.
    body: u32,
    every: Duration,
    begun: Instant,
    last: Option<Instant>,
    log: GrowingLog,
}

impl Checkpoints {
    /// One at least every so many seconds of wall time.
    pub fn new(folder: &Path, origin: Origin, every: f64) -> Self {
        // Beyond the range of durations there is no second checkpoint.
        let every = Duration::try_from_secs_f64(every).unwrap_or(Duration::MAX);
        let log = GrowingLog::new(folder.join(CHECKPOINT_ROWS));
        Self { file: folder.join(CHECKPOINT), origin, body: 0, every, begun: Instant::now(), last: None, log }
    }

    /// Takes note of the body that is about to run.
    pub(crate) fn of(&mut self, body: &dyn Body, identity: &Identity) {
        self.body = checksum(body, identity);
    }

    /// Whether one is to be written now; `asked` where one is wanted at any rate.
    pub(crate) fn due(&self, asked: bool) -> bool {
        asked || self.last.is_none_or(|last| last.elapsed() >= self.every)
    }

    /// Goes on where a checkpoint stood that had so many rows and shapes.
    pub(crate) fn go_on(&mut self, length: u64, written: [usize; 2]) {
        self.log.go_on(length, written);
    }

    /// Writes one, in the place of the last: what is kept beside the rows and shapes, and those.
    pub(crate) fn write(
        &mut self,
        mut kept: Contents<'_>,
        rows: &[Vec<f64>],
        shapes: &[Shape],
    ) -> Result<(), CheckpointError> {
        kept.rows = self.log.take(rows, shapes)?;
        kept.body = self.body;
        kept.record.to_mut().wall_seconds += self.begun.elapsed().as_secs_f64();
        file::write(&self.file, &self.origin, &kept)?;
        self.last = Some(Instant::now());
        Ok(())
    }

    /// Takes the files away once the run has come to its end.
    ///
    /// # Errors
    /// [`CheckpointError::Write`].
    pub fn finish(self) -> Result<(), CheckpointError> {
        file::remove(&self.file)?;
        file::remove(self.log.path())
    }
}
