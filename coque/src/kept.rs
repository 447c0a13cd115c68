//! A run whose results go into a folder: its checkpoints and frames on the way, the rest once it has ended, then the errors of its numbers.

use mesh_io::FieldError;

use crate::analyses::RunOptions;
use crate::bodies::Model;
use crate::fields::{FieldFiles, FieldSink, Frame};
use crate::run::checkpoint::{Checkpoint, Checkpoints, Origin};
use crate::run::folder::ResultFolder;
use crate::run::outcome::{Ended, Failure, Outcome};
use crate::run::progress::Progress;

/// What became of a run whose results are in a folder.
#[derive(Debug)]
pub struct Kept {
    /// What it leaves behind.
    pub outcome: Outcome,
    /// What of it could not be written.
    pub written: Result<(), String>,
    /// Whether a checkpoint is left from which it can go on.
    pub resumable: bool,
}

impl Model {
    /// Runs and writes what the scene asks for into its folder. The rows of the curve on the way are those of `progress`; `also` sees the
    /// frames beside the files. Where the scene asks for errors, the results of the run are there before other lattices run, and are written
    /// again with the errors beside them.
    ///
    /// # Errors
    /// A checkpoint of another model, frames that cannot be begun, a checkpoint that cannot be removed.
    pub fn run_into(
        self,
        folder: &ResultFolder,
        origin: Origin,
        from: Option<Checkpoint>,
        progress: &mut dyn Progress,
        also: Option<&mut dyn FieldSink>,
    ) -> Result<Kept, String> {
        let (task, replaced) = (self.task.clone(), origin.replaced.clone());
        let (barred, threads) = (self.barred.clone(), self.threads);
        let mut checkpoints =
            task.output.checkpoint_every.map(|every| Checkpoints::new(folder.path(), origin, every.get()));
        let frames = from.as_ref().map_or(0, Checkpoint::frames);
        let refused = |error: FieldError| format!("{error}\n");
        let files = FieldFiles::of_run(&self, folder.path(), frames).map_err(refused)?;
        let mut both = Both { files, also };
        let shows = both.files.is_some() || both.also.is_some();
        let options = RunOptions {
            progress: &mut *progress,
            checkpoints: checkpoints.as_mut(),
            fields: shows.then_some(&mut both as &mut dyn FieldSink),
            from,
        };
        let mut outcome = self.run_with(options).map_err(|error| format!("{error}\n"))?;
        outcome.summary.replaced =
            replaced.into_iter().map(|(path, value)| format!("{path}={value}")).collect();
        let mut written = folder.write(&task, &outcome);
        // With more room on the disk a run can go on, or write its results, as well.
        let stopped =
            matches!(outcome.ended, Ended::Interrupted { .. } | Ended::Diverged(Failure::Fields(_)));
        let resumable = (stopped || written.is_err()) && checkpoints.is_some();
        if !resumable && let Some(checkpoints) = checkpoints {
            checkpoints.finish().map_err(|error| format!("{error}\n"))?;
        }
        if let Some(scene) = barred.filter(|_| !resumable) {
            outcome.summary.errors = Some(scene.errors(&outcome, threads, progress));
            written = folder.write(&task, &outcome);
        }
        Ok(Kept { outcome, written, resumable })
    }
}

/// The files of the frames, and who sees them beside.
struct Both<'a> {
    files: Option<FieldFiles>,
    also: Option<&'a mut dyn FieldSink>,
}

impl FieldSink for Both<'_> {
    fn frame(&mut self, frame: &Frame<'_>) -> Result<(), FieldError> {
        if let Some(files) = &mut self.files {
            files.frame(frame)?;
        }
        self.also.as_mut().map_or(Ok(()), |also| also.frame(frame))
    }
}
