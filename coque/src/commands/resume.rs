//! `coque resume`: goes on with a run from the checkpoint in its folder.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::{Checkpoint, CheckpointError, Model, Origin, ResultFolder, Scene, read_text};
use clap::Args;

use super::company::Company;
use super::run::{build, launch, take};
use super::stderr::Refused;
use super::stop::Stop;

#[derive(Args)]
pub struct Resume {
    /// The folder of the run.
    folder: PathBuf,
    /// Threads [default: as before]; results are the same for any number.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
}

pub const HELP: &str = "\
A run whose scene asks for checkpoints can be stopped at any moment, by Ctrl-C, by the machine or by kill -9, and
ends in the same bits as one that never was:
  coque run scenes/ring.toml --set output.checkpoint_every=60
  coque resume out/ring

checkpoint_every is in seconds of wall time; a checkpoint is also kept at the start, after every settled level, and on
Ctrl-C. Explicit runs go on between two steps, static ones and relaxations after the last level found. An arc-length path carries
its step size and its search for critical points from point to point and keeps no checkpoint; linear answers and modes
are found at one stroke.

Exit codes: as `coque run`; 2 also for a checkpoint that is damaged, of another version or of a changed scene.";

/// Reads the checkpoint, builds its scene again and goes on.
pub fn carry_out(resume: &Resume, stop: &Arc<Stop>, company: &Company) -> Result<u8, Refused> {
    let (mut model, taken, origin, checkpoint) = company.all(prepare(resume, company))?;
    company.same(checkpoint.checksum(), "checkpoint")?;
    company.share(&mut model)?;
    stop.begin();
    launch(model, taken.as_ref(), origin, Some(checkpoint), stop, company).map(|(code, _)| code)
}

/// The model of the run, its folder, for the process that writes into it, and where it stood.
fn prepare(
    resume: &Resume,
    company: &Company,
) -> Result<(Model, Option<ResultFolder>, Origin, Checkpoint), Refused> {
    let folder = &resume.folder;
    // A folder that is not there is not made.
    let here = company.is_first() && folder.is_dir();
    let taken = here.then(|| take(folder)).transpose()?;
    let (checkpoint, text) = Checkpoint::read(folder).map_err(|error| match (&error, ended(folder)) {
        (CheckpointError::None(_), Some(how)) => format!(
            "the run in {} has ended already ({how}); to run it anew: coque run {}\n",
            folder.display(),
            folder.join(crate::SCENE_COPY).display()
        ),
        _ => format!("{error}\n"),
    })?;
    let mut origin = checkpoint.origin.clone();
    if let Some(threads) = resume.threads {
        origin.threads = threads.into();
    }
    let scene = Scene::with_overrides(&text, &origin.file, &origin.replaced);
    let scene = scene.map_err(|error| Refused::scene(&error))?;
    let model = build(&scene, origin.threads)?;
    Ok((model, taken, origin, checkpoint))
}

/// How the run in a folder ended, if it did.
fn ended(folder: &Path) -> Option<String> {
    let summary = read_text(&folder.join("summary.json")).ok()?;
    let summary: serde_json::Value = serde_json::from_str(&summary).ok()?;
    Some(summary["ended"].as_str()?.to_owned())
}
