//! The file of a checkpoint: a header that tells what follows and whether it is whole, written beside its place first.

use std::fs;
use std::io::{self, Write};
use std::path::Path;

use mesh_io::{read_bytes, read_text, under_way, write_whole};

use super::{CHECKPOINT, Contents, Origin, SCENE_COPY};

/// First bytes of the file.
const MARK: [u8; 8] = *b"coque-cp";
/// Version of what follows; to be raised with every change of what is kept.
const VERSION: u32 = 13;
/// Greatest length that is read \[bytes\]: ten million particles with all their shapes.
const LONGEST: u64 = 1 << 34;
/// Mark, version, length of the rest, checksum of the rest.
const HEADER: usize = 8 + 4 + 8 + 4;

/// Why a run cannot go on from a checkpoint, or a checkpoint could not be written.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum CheckpointError {
    /// There is none.
    #[error(
        "there is no {CHECKPOINT} in {0}; a run writes one if its scene says so, \
         as in --set output.checkpoint_every=60"
    )]
    None(String),
    /// A file cannot be read.
    #[error("cannot read {path}: {reason}")]
    Read {
        /// The file.
        path: String,
        /// What the system said.
        reason: String,
    },
    /// A file cannot be written.
    #[error("cannot write {path}: {reason}; make room or choose another folder")]
    Write {
        /// The file.
        path: String,
        /// What the system said.
        reason: String,
    },
    /// The file is something else.
    #[error("{0} is no checkpoint; name the folder of a run that was interrupted")]
    Foreign(String),
    /// The file is not what was written.
    #[error("{path} is damaged: {how}; run the scene again from its start")]
    Damaged {
        /// The file.
        path: String,
        /// What is wrong.
        how: String,
    },
    /// The file has another layout.
    #[error(
        "{path} has version {found} of the layout, this program reads version {VERSION}; \
         go on with the program that wrote it, or run the scene again from its start"
    )]
    Version {
        /// The file.
        path: String,
        /// Version found.
        found: u32,
    },
    /// The file was written by another version of the program.
    #[error(
        "{path} was written by coque {found}, this is coque {here}, whose results may differ in the last bits; \
         go on with coque {found}, or run the scene again from its start",
        here = env!("CARGO_PKG_VERSION")
    )]
    Program {
        /// The file.
        path: String,
        /// Version of the program.
        found: String,
    },
    /// The scene is another one now.
    #[error(
        "{0} has changed since the run began: a run goes on with the scene it began with; \
         put it back, or run the changed scene from its start"
    )]
    Scene(String),
    /// The surface is another one now.
    #[error(
        "{0} has changed since the run began: a run goes on with the surface it began with; \
         put it back, or run the scene again from its start"
    )]
    Surface(String),
    /// The model that the scene builds is another one now.
    #[error(
        "the checkpoint holds {particles} particles, the scene now builds {here}, or measures something else: \
         a file it reads has changed; put it back, or run the scene again from its start"
    )]
    Model {
        /// Particles kept.
        particles: usize,
        /// Particles of the model.
        here: usize,
    },
}

/// Writes a checkpoint; whoever looks finds the old one or the new one, whole.
pub(super) fn write(path: &Path, origin: &Origin, kept: &Contents<'_>) -> Result<(), CheckpointError> {
    let refuse = |reason: String| CheckpointError::Write { path: path.display().to_string(), reason };
    let body = postcard::to_stdvec(origin)
        .and_then(|start| postcard::to_extend(kept, start))
        .map_err(|error| refuse(error.to_string()))?;
    let mut header = Vec::with_capacity(HEADER);
    header.extend(MARK);
    header.extend(VERSION.to_le_bytes());
    header.extend((body.len() as u64).to_le_bytes());
    header.extend(crc32fast::hash(&body).to_le_bytes());
    let written = write_whole(path, |file| {
        file.write_all(&header)?;
        file.write_all(&body)
    });
    written.map_err(|error| refuse(error.to_string()))
}

/// Removes a checkpoint, and what a killed run left of the next one.
pub(super) fn remove(path: &Path) -> Result<(), CheckpointError> {
    for file in [path, &under_way(path)] {
        match fs::remove_file(file) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => {
                let path = file.display().to_string();
                return Err(CheckpointError::Write { path, reason: error.to_string() });
            }
            _ => {}
        }
    }
    Ok(())
}

/// Reads the checkpoint of a folder and its scene, and holds one against the other.
pub(super) fn read(folder: &Path) -> Result<(Origin, Contents<'static>, String), CheckpointError> {
    let (file, scene) = (folder.join(CHECKPOINT), folder.join(SCENE_COPY));
    let unreadable = |path: &Path, error: io::Error| CheckpointError::Read {
        path: path.display().to_string(),
        reason: error.to_string(),
    };
    let bytes = read_bytes(&file, LONGEST).map_err(|error| match error.kind() {
        io::ErrorKind::NotFound => CheckpointError::None(folder.display().to_string()),
        _ => unreadable(&file, error),
    })?;
    let path = file.display().to_string();
    let body = body(&bytes, &path)?;
    let damaged = |error: postcard::Error| CheckpointError::Damaged {
        path: path.clone(),
        how: format!("its checksum is right but its contents are not ({error})"),
    };
    let (origin, rest) = postcard::take_from_bytes::<Origin>(body).map_err(damaged)?;
    if origin.program != env!("CARGO_PKG_VERSION") {
        return Err(CheckpointError::Program { path, found: origin.program });
    }
    let text = read_text(&scene).map_err(|error| unreadable(&scene, error))?;
    if crc32fast::hash(text.as_bytes()) != origin.scene {
        return Err(CheckpointError::Scene(scene.display().to_string()));
    }
    let kept = postcard::from_bytes(rest).map_err(damaged)?;
    Ok((origin, kept, text))
}

/// What follows the header, if all of it is there and as it was written.
fn body<'a>(bytes: &'a [u8], path: &str) -> Result<&'a [u8], CheckpointError> {
    let damaged = |how: String| CheckpointError::Damaged { path: path.into(), how };
    let Some(rest) = bytes.strip_prefix(&MARK) else { return Err(CheckpointError::Foreign(path.into())) };
    let cut = || damaged(format!("it ends after {} bytes", bytes.len()));
    let (version, rest) = rest.split_first_chunk().ok_or_else(cut)?;
    let found = u32::from_le_bytes(*version);
    if found != VERSION {
        return Err(CheckpointError::Version { path: path.into(), found });
    }
    let (length, rest) = rest.split_first_chunk().ok_or_else(cut)?;
    let (checksum, rest) = rest.split_first_chunk().ok_or_else(cut)?;
    let length = u64::from_le_bytes(*length);
    if length != rest.len() as u64 {
        return Err(damaged(format!(
            "{length} bytes were written after its header, {} are there",
            rest.len()
        )));
    }
    if u32::from_le_bytes(*checksum) != crc32fast::hash(rest) {
        return Err(damaged("its checksum does not fit its contents".into()));
    }
    Ok(rest)
}
