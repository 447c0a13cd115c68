//! The folder of a run: one run at a time, nothing left of an earlier one, nothing written outside it.

use std::borrow::Cow;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, Read, Seek, Write};
use std::path::{Path, PathBuf};

use mesh_io::{Whole, listed, write_whole};

use super::checkpoint::{CHECKPOINT, CHECKPOINT_ROWS, SCENE_COPY};
use super::outcome::Outcome;
use crate::bodies::Task;
use crate::fields::{FieldFiles, SETS};
use crate::results::plot::{Scales, plot_scaled};

const CURVE: &str = ResultFolder::CURVE;
const SUMMARY: &str = ResultFolder::SUMMARY;
const FIELDS: &str = ResultFolder::FIELDS;
const PICTURE: &str = "curve.svg";
/// Locked while a run is under way; the system frees it however the run ends.
const LOCK: &str = "coque.lock";

/// What a run writes, but for the copy of its scene and its frames.
const WRITTEN: [&str; 8] = [
    CURVE,
    PICTURE,
    SUMMARY,
    CHECKPOINT,
    CHECKPOINT_ROWS,
    ResultFolder::TABLE,
    ResultFolder::VIEW,
    ResultFolder::CASES,
];

/// The folder of a run, held until this is dropped.
pub struct ResultFolder {
    path: PathBuf,
    lock: Option<File>,
    warning: Option<String>,
}

impl ResultFolder {
    /// The curve of a run.
    pub const CURVE: &'static str = "curve.csv";
    /// What a run was and what it cost.
    pub const SUMMARY: &'static str = "summary.json";
    /// The folder of its frames.
    pub const FIELDS: &'static str = "fields";
    /// The table of a sweep.
    pub const TABLE: &'static str = "sweep.csv";
    /// The table of load cases by name, with their envelope.
    pub const CASES: &'static str = "cases.csv";
    /// The page of the frames.
    pub const VIEW: &'static str = "view.html";

    /// Makes the folder, looks for links that would lead out of it, and locks it.
    ///
    /// # Errors
    /// A folder that cannot be made, another run in it, a link among what is to be written.
    pub fn take(path: &Path) -> Result<Self, String> {
        fs::create_dir_all(path).map_err(|e| format!("cannot create {}: {e}\n", path.display()))?;
        let parts = WRITTEN.map(|name| format!("{name}.part"));
        let names = WRITTEN.into_iter().chain(parts.iter().map(String::as_str));
        for name in names.chain([LOCK, FIELDS]) {
            let file = path.join(name);
            if file.is_symlink() {
                return Err(format!(
                    "{} is a link, and nothing is written outside the folder of the run; \
                     remove it, or name another folder with --out\n",
                    file.display()
                ));
            }
        }
        let locked = locked(path)?;
        let warning = locked.as_ref().err().cloned();
        Ok(Self { path: path.into(), lock: locked.ok(), warning })
    }

    /// What is said of a folder that cannot be locked.
    pub fn warning(&self) -> Option<&str> {
        self.warning.as_deref()
    }

    /// Whether a run holds a folder.
    pub fn is_held(folder: &Path) -> bool {
        let lock = OpenOptions::new().read(true).open(folder.join(LOCK));
        lock.is_ok_and(|lock| matches!(lock.try_lock_shared(), Err(TryLockError::WouldBlock)))
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Takes out what an earlier run left and might be taken for this one's; whatever else is there stays.
    pub fn clear(&self) -> Result<(), String> {
        let parts = WRITTEN.map(|name| format!("{name}.part"));
        for name in WRITTEN.into_iter().map(String::from).chain(parts) {
            let stale = self.path.join(name);
            match fs::remove_file(&stale) {
                Err(error) if error.kind() != io::ErrorKind::NotFound => {
                    return Err(format!("cannot remove {}: {error}\n", stale.display()));
                }
                _ => {}
            }
        }
        let fields = self.path.join(FIELDS);
        if fields.is_dir() {
            for name in [FieldFiles::LONE.to_string()].into_iter().chain(bodies(&fields)) {
                FieldFiles::clear(&fields, &name).map_err(|error| format!("{error}\n"))?;
            }
            let _ = fs::remove_file(fields.join(SETS));
            // What else is there keeps it.
            let _ = fs::remove_dir(&fields);
        }
        Ok(())
    }

    /// Clears the folder and copies the scene into it; gives the text of the copy, which names what was replaced at its
    /// end. An earlier run's results stand until the copy has found room.
    pub fn begin(
        &self,
        scene: &Path,
        mut text: String,
        replaced: &[(String, String)],
    ) -> Result<String, String> {
        let copy = self.path.join(SCENE_COPY);
        let same =
            |a: &Path, b: &Path| a.canonicalize().is_ok_and(|a| b.canonicalize().is_ok_and(|b| a == b));
        if same(&copy, scene) {
            self.clear()?;
            return Ok(text);
        }
        for (path, value) in replaced {
            let shown = format!("{path}={value}").replace(char::is_control, " ");
            text.push_str(&format!("\n# --set '{shown}'\n"));
        }
        let refused = |error: io::Error| format!("cannot write {}: {error}\n", copy.display());
        let mut file = Whole::begin(&copy).map_err(refused)?;
        file.write_all(text.as_bytes()).and_then(|()| file.flush()).map_err(refused)?;
        self.clear()?;
        file.finish().map_err(refused)?;
        Ok(text)
    }

    /// Writes what a run found. One file that cannot be written keeps no other from being.
    pub fn write(&self, task: &Task, outcome: &Outcome) -> Result<(), String> {
        let mut refused = String::new();
        let mut note = |name: &str, written: io::Result<()>| {
            if let Err(error) = written {
                refused.push_str(&format!("cannot write {}: {error}\n", self.path.join(name).display()));
            }
        };
        let errors = outcome.summary.errors.as_ref();
        let curve =
            errors.map_or(Cow::Borrowed(&outcome.curve), |errors| Cow::Owned(errors.beside(&outcome.curve)));
        note(CURVE, write_whole(&self.path.join(CURVE), |to| curve.write_csv(to)));
        if let Some(cases) = &outcome.summary.cases {
            let file = self.path.join(ResultFolder::CASES);
            note(ResultFolder::CASES, write_whole(&file, |to| cases.write_csv(&curve, to)));
        }
        let summary = serde_json::to_vec_pretty(&outcome.summary).map_err(io::Error::from);
        note(
            SUMMARY,
            summary.and_then(|text| write_whole(&self.path.join(SUMMARY), |to| to.write_all(&text))),
        );
        // A plot of what probes measure has no place among modes.
        if let Some(plot) = task.output.plot.as_ref().filter(|_| !task.analysis.kind().gives_modes) {
            let scales = Scales { log_x: plot.log_x, log_y: plot.log_y };
            let file = self.path.join(PICTURE);
            let drawn = plot_scaled(&curve, [&plot.x, &plot.y], scales, &task.title, &file);
            if let Err(error) = drawn {
                refused.push_str(&format!("{error}\n"));
            }
        }
        if refused.is_empty() { Ok(()) } else { Err(refused) }
    }
}

/// Bodies of which an earlier run listed frames: lists that name files of their own name.
fn bodies(fields: &Path) -> Vec<String> {
    let lists = fs::read_dir(fields).into_iter().flatten().flatten().map(|entry| entry.path());
    let own = |list: PathBuf| {
        let name = list.file_stem()?.to_str()?.to_string();
        let frames = listed(&list).ok()?;
        let of_run = |path: &Path| {
            path.file_name()
                .and_then(|file| file.to_str())
                .is_some_and(|file| file.starts_with(&format!("{name}-")))
        };
        (!frames.is_empty() && frames.iter().all(|(_, path)| of_run(path))).then_some(name)
    };
    lists.filter(|path| path.extension().is_some_and(|ending| ending == "pvd")).filter_map(own).collect()
}

impl Drop for ResultFolder {
    fn drop(&mut self) {
        if self.lock.is_some() {
            // Removed while it is locked; whoever waits looks whether the file it locked is still there.
            let _ = fs::remove_file(self.path.join(LOCK));
        }
    }
}

/// Locks a folder; a warning in place of the lock where its file system knows none.
fn locked(folder: &Path) -> Result<Result<File, String>, String> {
    let path = folder.join(LOCK);
    let refused = |error: io::Error| format!("cannot write {}: {error}\n", path.display());
    loop {
        let opened = OpenOptions::new().read(true).write(true).create(true).truncate(false).open(&path);
        let mut file = opened.map_err(refused)?;
        match file.try_lock() {
            Ok(()) if !still_there(&file, &path) => {}
            Ok(()) => {
                // For people: that it does not fit on the disk unlocks nothing.
                let _ = file.set_len(0).and_then(|()| file.rewind());
                let _ = writeln!(file, "process {}{}", std::process::id(), host());
                return Ok(Ok(file));
            }
            Err(TryLockError::WouldBlock) => {
                let mut who = String::new();
                let _ = file.take(200).read_to_string(&mut who);
                let who = if who.trim().is_empty() { "another run" } else { who.trim() };
                return Err(format!(
                    "{} is in use by {who}; wait until it has ended, or name another folder with --out\n",
                    folder.display()
                ));
            }
            Err(TryLockError::Error(error)) => {
                let shown = folder.display();
                let _ = fs::remove_file(&path);
                return Ok(Err(format!("{shown} cannot be locked ({error}): start no second run in it")));
            }
        }
    }
}

/// Whether the file of that name is the one that was locked: the run that held it may have removed it meanwhile.
#[cfg(unix)]
fn still_there(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let id = |data: fs::Metadata| (data.dev(), data.ino());
    let (mine, there) = (file.metadata().map(id), fs::symlink_metadata(path).map(id));
    mine.is_ok_and(|mine| there.is_ok_and(|there| mine == there))
}

/// An open file is not removed here.
#[cfg(not(unix))]
fn still_there(_: &File, _: &Path) -> bool {
    true
}

#[cfg(unix)]
fn host() -> String {
    format!(" on {}", rustix::system::uname().nodename().to_string_lossy())
}

#[cfg(not(unix))]
fn host() -> String {
    String::new()
}
