//! Frames on disk: one `.vtu` a frame and a `.pvd` that lists them, whole at any moment.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use sph_shell::PointResult;

use super::content::{Content, results};
use super::read::listed;
use super::vtu::Vtu;
use super::{FieldError, FieldSink, Frame};
use crate::scene::Fields;
use crate::whole::{under_way, write_whole};

/// Writes frames into a folder: `shell.pvd` and `shell-0000.vtu` …, for the extruded shell `solid.pvd` likewise.
///
/// Each file is written under another name and renamed, the list of frames after each frame: a run that is killed
/// leaves whole files, and lists that name only those.
pub struct FieldFiles {
    stresses: bool,
    sheet: Series,
    solid: Option<Series>,
    results: Vec<PointResult>,
}

/// The frames of one kind.
struct Series {
    folder: PathBuf,
    name: &'static str,
    /// Where each frame stands, and its file.
    frames: Vec<(f64, String)>,
}

impl FieldFiles {
    /// Makes the folder and takes out the frames that an earlier run left there.
    ///
    /// # Errors
    /// [`FieldError`] for a folder that cannot be made or cleared.
    pub fn create(folder: &Path, wanted: &Fields) -> Result<Self, FieldError> {
        let series = |name| Series { folder: folder.into(), name, frames: Vec::new() };
        fs::create_dir_all(folder).map_err(|error| refused(folder, &error))?;
        Self::clear(folder)?;
        Ok(Self {
            stresses: wanted.stresses,
            sheet: series("shell"),
            solid: wanted.extruded.then(|| series("solid")),
            results: Vec::new(),
        })
    }

    /// Takes out the frames that an earlier run left in a folder, and their lists; whatever else is there stays.
    ///
    /// # Errors
    /// [`FieldError`] for a folder that cannot be cleared.
    pub fn clear(folder: &Path) -> Result<(), FieldError> {
        let series = |name| Series { folder: folder.into(), name, frames: Vec::new() };
        ["shell", "solid"].into_iter().try_for_each(|name| series(name).clear())
    }

    /// Goes on after so many frames that an earlier sitting wrote; those after them are taken out, to be written again.
    ///
    /// # Errors
    /// [`FieldError`] for a list that does not hold them, and a folder that cannot be cleared.
    pub fn go_on(folder: &Path, wanted: &Fields, frames: u64) -> Result<Self, FieldError> {
        if frames == 0 {
            return Self::create(folder, wanted);
        }
        let series = |name| Series { folder: folder.into(), name, frames: Vec::new() }.up_to(frames as usize);
        Ok(Self {
            stresses: wanted.stresses,
            sheet: series("shell")?,
            solid: wanted.extruded.then(|| series("solid")).transpose()?,
            results: Vec::new(),
        })
    }
}

impl FieldSink for FieldFiles {
    fn frame(&mut self, frame: &Frame<'_>) -> Result<(), FieldError> {
        let stresses = self.stresses && frame.has_forces();
        let content = Content { frame, results: stresses.then(|| results(frame, &mut self.results)) };
        let mut sheet = || {
            self.sheet.add(frame.along, |path| {
                write_whole(path, |file| {
                    let mut file = Vtu::begin(file)?;
                    content.sheet(&mut file)?;
                    file.end().map(|_| ())
                })
                .map_err(|error| refused(path, &error))
            })
        };
        let mut solid = || {
            let Some(solid) = &mut self.solid else { return Ok(()) };
            solid.add(frame.along, |path| {
                write_whole(path, |file| {
                    let mut file = Vtu::begin(file)?;
                    content.solid(&mut file)?;
                    file.end().map(|_| ())
                })
                .map_err(|error| refused(path, &error))
            })
        };
        // While a frame is written no step is made: where the run has threads, two of them write. A run on one thread
        // has no pool, and must not wake that of the whole process.
        let pooled = rayon::current_thread_index().is_some();
        let (sheet, solid) = if pooled { rayon::join(sheet, solid) } else { (sheet(), solid()) };
        sheet.and(solid)
    }
}

impl Series {
    /// Writes one more frame, then the list of all of them.
    fn add(
        &mut self,
        along: f64,
        write: impl FnOnce(&Path) -> Result<(), FieldError>,
    ) -> Result<(), FieldError> {
        let name = format!("{}-{:04}.vtu", self.name, self.frames.len());
        write(&self.folder.join(&name))?;
        self.frames.push((along, name));
        self.write_list()
    }

    fn write_list(&self) -> Result<(), FieldError> {
        write_whole(&self.list(), |file| {
            writeln!(file, "<?xml version=\"1.0\"?>")?;
            writeln!(file, "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">")?;
            writeln!(file, "<Collection>")?;
            for (along, name) in &self.frames {
                writeln!(file, "<DataSet timestep=\"{along:?}\" part=\"0\" file=\"{name}\"/>")?;
            }
            writeln!(file, "</Collection>\n</VTKFile>")
        })
        .map_err(|error| refused(&self.list(), &error))
    }

    fn list(&self) -> PathBuf {
        self.folder.join(format!("{}.pvd", self.name))
    }

    /// Reads the list of an earlier sitting back and keeps its first frames.
    fn up_to(mut self, frames: usize) -> Result<Self, FieldError> {
        let list = self.list();
        let refused = |reason: String| FieldError { path: list.display().to_string(), reason };
        let found = listed(&list).map_err(|error| refused(error.reason))?;
        if found.len() < frames {
            let reason = format!("it lists {} frames, the checkpoint goes on after {frames}", found.len());
            return Err(refused(reason));
        }
        let name = |path: PathBuf| path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        self.frames = found.into_iter().take(frames).map(|(along, path)| (along, name(path))).collect();
        self.write_list()?;
        self.remove_frames()?;
        Ok(self)
    }

    /// Removes the list, then the frames: no list ever names what is gone.
    fn clear(&self) -> Result<(), FieldError> {
        let list = self.list();
        for list in [under_way(&list), list] {
            if list.symlink_metadata().is_ok() {
                fs::remove_file(&list).map_err(|error| refused(&list, &error))?;
            }
        }
        self.remove_frames()
    }

    /// Removes every frame that is not listed.
    fn remove_frames(&self) -> Result<(), FieldError> {
        let entries = fs::read_dir(&self.folder).map_err(|error| refused(&self.folder, &error))?;
        for path in entries.filter_map(|entry| Some(entry.ok()?.path())) {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            let listed = self.frames.iter().any(|(_, kept)| *kept == name);
            if self.is_frame(&name) && !listed && path.is_file() {
                fs::remove_file(&path).map_err(|error| refused(&path, &error))?;
            }
        }
        Ok(())
    }

    /// Whether a file is a frame of this series, whole or under way.
    fn is_frame(&self, name: &str) -> bool {
        let name = name.strip_suffix(".part").unwrap_or(name);
        let number = name.strip_prefix(self.name).and_then(|rest| rest.strip_prefix('-'));
        let number = number.and_then(|rest| rest.strip_suffix(".vtu"));
        number.is_some_and(|number| number.len() >= 4 && number.bytes().all(|c| c.is_ascii_digit()))
    }
}

fn refused(path: &Path, error: &std::io::Error) -> FieldError {
    FieldError { path: path.display().to_string(), reason: error.to_string() }
}
