//! The rows and shapes of a run on disk, appended from checkpoint to checkpoint.
//!
//! A block is what came since the checkpoint before: its length, its checksum, its contents. What stands beyond the
//! length that a checkpoint names was under way when the run was killed, and is written over.

use std::borrow::Cow;
use std::fs::OpenOptions;
use std::io::{self, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use super::file::CheckpointError;
use crate::bodies::Shape;
use mesh_io::read_bytes;

/// Greatest length that is read \[bytes\]: ten million particles with all their shapes.
const LONGEST: u64 = 1 << 34;
/// Bytes before the contents of a block: their length and their checksum.
const HEADER: usize = 8 + 4;

/// What a run has recorded.
#[derive(Debug, Default)]
pub(crate) struct Grown {
    pub rows: Vec<Vec<f64>>,
    pub shapes: Vec<Shape>,
}

/// What came since the checkpoint before.
#[derive(Serialize, Deserialize)]
struct Block<'a> {
    rows: Cow<'a, [Vec<f64>]>,
    shapes: Cow<'a, [Shape]>,
}

/// The file, and how much of it counts.
pub(super) struct GrowingLog {
    path: PathBuf,
    length: u64,
    /// Rows and shapes in it.
    written: [usize; 2],
}

impl GrowingLog {
    /// An empty one; what stands in the file counts for nothing.
    pub fn new(path: PathBuf) -> Self {
        Self { path, length: 0, written: [0; 2] }
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Goes on where so many bytes hold so many rows and shapes.
    pub fn go_on(&mut self, length: u64, written: [usize; 2]) {
        (self.length, self.written) = (length, written);
    }

    /// Appends what is new and gives the length that counts from now on.
    pub fn take(&mut self, rows: &[Vec<f64>], shapes: &[Shape]) -> Result<u64, CheckpointError> {
        let [first_row, first_shape] = self.written;
        if self.length > 0 && first_row == rows.len() && first_shape == shapes.len() {
            return Ok(self.length);
        }
        let block = Block { rows: rows[first_row..].into(), shapes: shapes[first_shape..].into() };
        let refuse =
            |reason: String| CheckpointError::Write { path: self.path.display().to_string(), reason };
        let body = postcard::to_stdvec(&block).map_err(|error| refuse(error.to_string()))?;
        self.append(&body).map_err(|error| refuse(error.to_string()))?;
        self.length += (HEADER + body.len()) as u64;
        self.written = [rows.len(), shapes.len()];
        Ok(self.length)
    }

    /// Writes a block behind what counts, and puts it on the disk.
    fn append(&self, body: &[u8]) -> io::Result<()> {
        // A link is not followed: what it names is not the run's.
        if std::fs::symlink_metadata(&self.path).is_ok_and(|there| !there.is_file()) {
            return Err(io::Error::other("a link, a folder or a device stands there, where a file is to be"));
        }
        let mut file = OpenOptions::new().write(true).create(true).truncate(false).open(&self.path)?;
        file.set_len(self.length)?;
        file.seek(SeekFrom::Start(self.length))?;
        let mut block = Vec::with_capacity(HEADER + body.len());
        block.extend((body.len() as u64).to_le_bytes());
        block.extend(crc32fast::hash(body).to_le_bytes());
        block.extend(body);
        file.write_all(&block)?;
        file.sync_all()
    }
}

/// Reads the part that counts.
pub(super) fn read(path: &Path, length: u64) -> Result<Grown, CheckpointError> {
    let shown = path.display().to_string();
    let damaged = |how: &str| CheckpointError::Damaged { path: shown.clone(), how: how.into() };
    let mut grown = Grown::default();
    if length == 0 {
        return Ok(grown);
    }
    let bytes = read_bytes(path, LONGEST)
        .map_err(|error| CheckpointError::Read { path: shown.clone(), reason: error.to_string() })?;
    let cut = || damaged("it is shorter than its checkpoint says");
    let length = usize::try_from(length).map_err(|_| cut())?;
    let mut rest = bytes.get(..length).ok_or_else(cut)?;
    while !rest.is_empty() {
        let (length, after) = rest.split_first_chunk().ok_or_else(cut)?;
        let (checksum, after) = after.split_first_chunk().ok_or_else(cut)?;
        let length = usize::try_from(u64::from_le_bytes(*length)).map_err(|_| cut())?;
        let body = after.get(..length).ok_or_else(cut)?;
        if u32::from_le_bytes(*checksum) != crc32fast::hash(body) {
            return Err(damaged("its checksum does not fit its contents"));
        }
        let block: Block<'static> = postcard::from_bytes(body)
            .map_err(|error| damaged(&format!("its contents are not what they should be ({error})")))?;
        grown.rows.extend(block.rows.into_owned());
        grown.shapes.extend(block.shapes.into_owned());
        rest = &after[length..];
    }
    Ok(grown)
}
