//! Frames on disk: one `.vtu` a frame and a `.pvd` that lists them, whole at any moment.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use crate::atomic_file::{under_way, write_whole};
use crate::input::read_text;
use crate::sheet::ReadError;
use crate::vtu::write::Vtu;
use crate::vtu::xml::parsed;
use crate::writer::FieldWriter;

/// A frame that could not be written.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("cannot write {path}: {reason}; make room or choose another folder, then run again")]
pub struct FieldError {
    /// The file.
    pub path: String,
    /// What the system said.
    pub reason: String,
}

/// Frames of one kind in a folder: `NAME-0000.vtu` …, or with a word to each, and `NAME.pvd`, which lists them.
///
/// Each file is written under another name and renamed, the list of frames after each frame: a run that is killed
/// leaves whole files, and lists that name only those.
#[derive(Debug)]
pub struct Series {
    folder: PathBuf,
    name: String,
    /// Where each frame stands, and its file.
    frames: Vec<(f64, String)>,
}

impl Series {
    /// A series without frames; nothing is touched.
    pub fn new(folder: &Path, name: &str) -> Self {
        Self { folder: folder.into(), name: name.into(), frames: Vec::new() }
    }

    /// Writes one more frame, which stands at `along`, then the list of all of them.
    ///
    /// # Errors
    /// [`FieldError`] for what `write` or the system refuses; the frames before stand.
    pub fn add(
        &mut self,
        along: f64,
        write: impl FnOnce(&mut dyn FieldWriter) -> io::Result<()>,
    ) -> Result<(), FieldError> {
        self.add_named(along, None, write)
    }

    /// The same with a word of its own behind the number in the name of the file, `NAME-0000-word.vtu`: a plain one, that a file may be named by.
    ///
    /// # Errors
    /// As [`Series::add`].
    pub fn add_named(
        &mut self,
        along: f64,
        word: Option<&str>,
        write: impl FnOnce(&mut dyn FieldWriter) -> io::Result<()>,
    ) -> Result<(), FieldError> {
        let word = word.map_or_else(String::new, |word| format!("-{word}"));
        let name = format!("{}-{:04}{word}.vtu", self.name, self.frames.len());
        let path = self.folder.join(&name);
        let written = write_whole(&path, |file| {
            let mut file = Vtu::begin(file)?;
            write(&mut file)?;
            file.end().map(|_| ())
        });
        written.map_err(|error| refused(&path, &error))?;
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

    /// Reads the list of an earlier sitting back and keeps its first frames; those after them are taken out.
    ///
    /// # Errors
    /// [`FieldError`] for a list that does not hold them, and a folder that cannot be cleared.
    pub fn up_to(mut self, frames: usize) -> Result<Self, FieldError> {
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

    /// Removes the list, then the frames: no list ever names what is gone. Whatever else is there stays.
    ///
    /// # Errors
    /// [`FieldError`] for a folder that cannot be cleared.
    pub fn clear(&self) -> Result<(), FieldError> {
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
        let number = name.strip_prefix(&self.name).and_then(|rest| rest.strip_prefix('-'));
        let number = number.and_then(|rest| rest.strip_suffix(".vtu"));
        let number = number.map(|rest| rest.split_once('-').map_or(rest, |(number, _)| number));
        number.is_some_and(|number| number.len() >= 4 && number.bytes().all(|c| c.is_ascii_digit()))
    }
}

fn refused(path: &Path, error: &io::Error) -> FieldError {
    FieldError { path: path.display().to_string(), reason: error.to_string() }
}

/// The frames that a list names: what they run along, and their files.
///
/// # Errors
/// [`ReadError`] for a list that is missing or no list.
pub fn listed(list: &Path) -> Result<Vec<(f64, PathBuf)>, ReadError> {
    let frames = |text: &str| {
        let document = parsed(text).map_err(|error| error.what)?;
        let sets = document.descendants().filter(|node| node.has_tag_name("DataSet"));
        sets.map(|set| {
            let along = set.attribute("timestep").and_then(|text| text.parse().ok());
            let along = along.ok_or("a frame has no timestep")?;
            let file = set.attribute("file").ok_or("a frame has no file")?;
            Ok((along, list.with_file_name(file)))
        })
        .collect()
    };
    let text = read_text(list).map_err(|error| error.to_string());
    text.and_then(|text| frames(&text))
        .map_err(|reason| ReadError { path: list.display().to_string(), reason })
}
