//! Files that exist whole or not at all: written beside their place under another name, then renamed.

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use super::FieldError;

/// Bytes gathered before they go to the system.
const BUFFER: usize = 1 << 18;

/// Writes a file by way of another name in the same folder; whoever looks finds the old file or the new one.
///
/// # Errors
/// [`FieldError`]; the old file, if any, stands, and the other name is gone.
pub(crate) fn write_whole(
    path: &Path,
    write: impl FnOnce(BufWriter<File>) -> io::Result<BufWriter<File>>,
) -> Result<(), FieldError> {
    let under_way = under_way(path);
    let written = File::create(&under_way)
        .and_then(|file| write(BufWriter::with_capacity(BUFFER, file)))
        .and_then(|mut file| file.flush())
        .and_then(|()| fs::rename(&under_way, path));
    written.map_err(|error| {
        // Half a file is of no use; that it cannot be removed either changes nothing.
        let _ = fs::remove_file(&under_way);
        FieldError { path: path.display().to_string(), reason: error.to_string() }
    })
}

/// The name under which a file is written.
fn under_way(path: &Path) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(".part");
    name.into()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_write_that_fails_leaves_the_old_file() {
        let folder = std::env::temp_dir().join(format!("coque-whole-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        let path = folder.join("a.txt");
        let put = |text: &'static str, fails: bool| {
            write_whole(&path, |mut file| {
                file.write_all(text.as_bytes())?;
                if fails { Err(io::Error::other("the disk is full")) } else { Ok(file) }
            })
        };
        put("first", false).unwrap();
        let error = put("second", true).unwrap_err();
        assert!(error.to_string().contains("a.txt: the disk is full; make room"), "{error}");
        assert_eq!(fs::read_to_string(&path).unwrap(), "first");
        put("third", false).unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), "third");
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 1);
        fs::remove_dir_all(&folder).unwrap();
    }
}
