//! Files that are read: plain ones, of a size that fits; and how messages quote from them.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

/// Longest text that a person or a run writes: a scene, a curve, a list of frames \[bytes\].
const LONGEST_TEXT: u64 = 1 << 30;

/// Reads a file as text.
///
/// # Errors
/// What the system says; inputs that are no file or too long; bytes that are no UTF-8.
pub fn read_text(path: &Path) -> io::Result<String> {
    let bytes = read_bytes(path, LONGEST_TEXT)?;
    String::from_utf8(bytes).map_err(|_| io::Error::new(io::ErrorKind::InvalidData, "it is not text (UTF-8)"))
}

/// Reads a plain file of at most so many bytes: pipes and devices may never end.
///
/// # Errors
/// Those of the system; a folder, a pipe, a device, a file that is longer.
pub fn read_bytes(path: &Path, most: u64) -> io::Result<Vec<u8>> {
    let refused = |what: String| Err(io::Error::new(io::ErrorKind::InvalidInput, what));
    // Asked before it is opened: a pipe would wait for its writer.
    let found = std::fs::metadata(path)?;
    if found.is_dir() {
        return refused("it is a folder; name a file in it".into());
    }
    if !found.is_file() {
        return refused("it is a pipe or a device, which may never end; copy it to a file".into());
    }
    let mut bytes = Vec::new();
    // One more than is allowed tells a file that is longer, or grows while it is read.
    let mut file = File::open(path)?.take(most.saturating_add(1));
    if found.len() <= most {
        file.read_to_end(&mut bytes)?;
    }
    if found.len() > most || bytes.len() as u64 > most {
        let length = found.len().max(bytes.len() as u64);
        return refused(format!("it has {length} bytes; at most {most} are read"));
    }
    Ok(bytes)
}

/// The head of a long word, for messages.
pub(crate) fn shortened(word: &str) -> String {
    const LONGEST: usize = 40;
    match word.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}…", &word[..end]),
        None => word.into(),
    }
}
