//! `coque view`: the frames of a run as a page that a browser opens by itself, once or again and again while the run goes on.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread::{JoinHandle, available_parallelism, sleep, spawn};
use std::time::{Duration, Instant};

use crate::{ResultFolder, page_of, write_whole};
use clap::Args;

use super::stderr::{Refused, say};
use super::stop::Stop;
use crate::shown::folder::has_frames;

#[derive(Args)]
pub struct View {
    /// Folder of a run; shapes are there if its scene had [output.fields], or if it ran with --view.
    folder: PathBuf,
    /// Write the page only; print where it is.
    #[arg(long)]
    no_open: bool,
    /// While the run goes on, write the page anew every so many seconds; it loads itself again and stays as it was left.
    #[arg(long, value_name = "SECONDS", num_args = 0..=1, require_equals = true, default_missing_value = "5", value_parser = clap::value_parser!(u16).range(1..=3600))]
    follow: Option<u16>,
    /// Most megabytes of the page; beyond them it holds fewer frames, then fewer fields, and says so.
    #[arg(long, value_name = "MB", default_value_t = 30, value_parser = clap::value_parser!(u16).range(1..=1000))]
    size: u16,
}

pub const HELP: &str = "\
Examples:
  coque view out/ring               writes out/ring/view.html and opens it
  coque view out/ring --no-open     writes it only
  coque view out/gate --follow      while the run goes on: written anew every 5 s (--follow=20), the page loads itself again
  coque run scenes/ring.toml --view     runs, with frames even if the scene asks for none, and shows them on the way

The page is one file, without a server and without anything fetched: it can be sent as it is. It shows shells with their thickness and
each face with its own stress, solids, particles of fluids as spheres or discs; any field or component in colour, over the range of all frames, of
one, of most numbers (2 to 98 in a hundred) or one set by hand; the curve with a mark at the frame; sets; warnings; the scene. Drag
turns (moves a plane scene), shift-drag the other of both, the wheel zooms, a click asks for a particle, space plays,
arrow keys step. Motions are drawn to scale unless another one is chosen; modes have no size and swing.

Browsers: Chrome 103, Firefox 113, Safari 16.4 or later.";

/// Seconds between two pages of `coque run --view`.
const FOLLOW: u16 = 5;
/// Megabytes of its page.
const SIZE: u16 = 30;

/// Writes the page and opens it; follows the run if that is wanted.
pub fn carry_out(view: &View, stop: &Arc<Stop>) -> Result<(), Refused> {
    if !view.folder.is_dir() {
        let repair = "run a scene first, such as coque run scenes/ring.toml --view";
        return Err(format!("{} is no folder; {repair}\n", view.folder.display()).into());
    }
    let threads = available_parallelism().map_or(1, usize::from);
    let write = |reload: Option<u16>| write(&view.folder, view.size, threads, reload);
    let Some(every) = view.follow else {
        let page = write(None)?;
        say(&page.display().to_string());
        if !view.no_open {
            open(&page);
        }
        return Ok(());
    };
    stop.begin();
    let mut opened = false;
    loop {
        let live = ResultFolder::is_held(&view.folder) && !stop.asked();
        let page = write(live.then_some(every))?;
        if !opened {
            say(&page.display().to_string());
            if !view.no_open {
                open(&page);
            }
            opened = true;
        }
        if !live {
            return Ok(());
        }
        let next = Instant::now() + Duration::from_secs(every.into());
        while Instant::now() < next && !stop.asked() {
            sleep(Duration::from_millis(100));
        }
    }
}

/// Writes the page of a run into its folder; gives where it is.
fn write(folder: &Path, size: u16, threads: usize, reload: Option<u16>) -> Result<PathBuf, String> {
    let page = page_of(folder, usize::from(size) * 1_000_000, threads, reload.map(f64::from))?;
    let path = folder.join(ResultFolder::VIEW);
    let written = write_whole(&path, |to| to.write_all(page.as_bytes()));
    written.map_err(|e| format!("cannot write {}: {e}\n", path.display()))?;
    Ok(path)
}

/// Asks the system to show a page in the browser that is its default; where there is no screen nothing is done.
fn open(page: &Path) {
    let page = page.canonicalize().unwrap_or_else(|_| page.into());
    let mut command = if cfg!(target_os = "windows") {
        let mut command = Command::new("cmd");
        command.args(["/C", "start", ""]);
        command
    } else if cfg!(target_os = "macos") {
        Command::new("open")
    } else {
        if ["DISPLAY", "WAYLAND_DISPLAY"].iter().all(|name| std::env::var_os(name).is_none()) {
            return;
        }
        Command::new("xdg-open")
    };
    let quiet = command.arg(&page).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    if quiet.spawn().is_err() {
        say(&format!("no browser could be started; open {}", page.display()));
    }
}

/// A page that follows a run of this process, on a thread of its own.
pub struct Follower {
    folder: PathBuf,
    /// Dropped to end it.
    over: Sender<()>,
    /// Gives whether it opened the page.
    thread: JoinHandle<bool>,
}

impl Follower {
    /// Begins to write the page of a folder as soon as it has frames, and opens it.
    pub fn begin(folder: &Path) -> Self {
        let (over, ended) = channel();
        let own = folder.to_path_buf();
        Self { folder: folder.into(), over, thread: spawn(move || follow(&own, &ended)) }
    }

    /// Writes the page of the whole run.
    pub fn end(self) -> Result<(), String> {
        drop(self.over);
        let opened = self.thread.join().unwrap_or_default();
        let page = write(&self.folder, SIZE, 1, None)?;
        say(&page.display().to_string());
        if !opened {
            open(&page);
        }
        Ok(())
    }
}

fn follow(folder: &Path, ended: &Receiver<()>) -> bool {
    let mut opened = false;
    // The first look comes soon: a short run is over by then.
    let mut pause = Duration::from_secs(1);
    while ended.recv_timeout(pause) == Err(RecvTimeoutError::Timeout) {
        pause = Duration::from_secs(FOLLOW.into());
        // Until there are frames nothing is to be seen; what cannot be written is reported at the end.
        if !has_frames(folder) {
            continue;
        }
        if let Ok(page) = write(folder, SIZE, 1, Some(FOLLOW)) {
            if !opened {
                open(&page);
            }
            opened = true;
        }
    }
    opened
}
