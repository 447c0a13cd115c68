//! Files that exist whole or not at all: written beside their place under another name, put on the disk, then renamed.

use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// Bytes gathered before they go to the system.
const BUFFER: usize = 1 << 18;

/// A file under way: nothing stands in its place, or what stood there before, until [`Whole::finish`].
///
/// Dropped before that, it leaves nothing behind.
#[derive(Debug)]
pub struct Whole {
    path: PathBuf,
    to: BufWriter<File>,
}

impl Whole {
    /// Opens `PATH.part`, in place of what a killed run may have left there.
    ///
    /// # Errors
    /// Those of the system; whatever is no plain file in the place of the file: a link is not followed.
    pub fn begin(path: &Path) -> io::Result<Self> {
        if let Ok(there) = fs::symlink_metadata(path) {
            let kind = there.file_type();
            let what = if kind.is_symlink() { "a link" } else { "a folder or device" };
            if !kind.is_file() {
                return Err(io::Error::other(format!("{what} stands there, where a file is to be")));
            }
        }
        let under_way = under_way(path);
        match fs::remove_file(&under_way) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(error),
            _ => {}
        }
        // A new file, so that no link of that name is followed.
        let file = OpenOptions::new().write(true).create_new(true).open(&under_way)?;
        Ok(Self { path: path.into(), to: BufWriter::with_capacity(BUFFER, file) })
    }

    /// Puts the file on the disk and into its place.
    ///
    /// # Errors
    /// Those of the system; what stood there before still does.
    pub fn finish(mut self) -> io::Result<()> {
        self.to.flush()?;
        // The new name must not reach the disk before the data do.
        self.to.get_ref().sync_all()?;
        fs::rename(under_way(&self.path), &self.path)?;
        // Where a folder cannot be synchronised, its names reach the disk in their own time.
        let _ = File::open(folder(&self.path)).and_then(|folder| folder.sync_all());
        Ok(())
    }
}

impl Write for Whole {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.to.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.to.flush()
    }
}

impl Drop for Whole {
    fn drop(&mut self) {
        // Renamed, it is not there any more. Half a file is of no use; that it cannot be removed changes nothing.
        let _ = fs::remove_file(under_way(&self.path));
    }
}

/// Writes a file by way of [`Whole`]; whoever looks finds the old file or the new one.
///
/// # Errors
/// Those of `write` and of the system; the old file, if any, stands, and the other name is gone.
pub fn write_whole(path: &Path, write: impl FnOnce(&mut Whole) -> io::Result<()>) -> io::Result<()> {
    let mut file = Whole::begin(path)?;
    write(&mut file)?;
    file.finish()
}

/// The name under which a file is written.
pub fn under_way(path: &Path) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(".part");
    name.into()
}

fn folder(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn empty(name: &str) -> PathBuf {
        let folder = std::env::temp_dir().join(format!("coque-whole-{name}-{}", std::process::id()));
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).unwrap();
        folder
    }

    #[test]
    fn a_write_that_fails_leaves_the_old_file() {
        let folder = empty("fails");
        let path = folder.join("a.txt");
        let put = |text: &'static str, fails: bool| {
            write_whole(&path, |file| {
                file.write_all(text.as_bytes())?;
                if fails { Err(io::Error::other("the disk is full")) } else { Ok(()) }
            })
        };
        put("first", false).unwrap();
        assert_eq!(put("second", true).unwrap_err().to_string(), "the disk is full");
        assert_eq!(fs::read_to_string(&path).unwrap(), "first");
        put("third", false).unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), "third");
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 1);
        fs::remove_dir_all(&folder).unwrap();
    }

    #[cfg(unix)]
    #[test]
    fn links_are_not_followed() {
        let folder = empty("links");
        let [mine, path] = ["mine", "a.txt"].map(|name| folder.join(name));
        fs::write(&mine, "mine").unwrap();
        std::os::unix::fs::symlink(&mine, &path).unwrap();
        assert!(write_whole(&path, |file| file.write_all(b"theirs")).is_err());
        fs::remove_file(&path).unwrap();
        std::os::unix::fs::symlink(&mine, under_way(&path)).unwrap();
        write_whole(&path, |file| file.write_all(b"theirs")).unwrap();
        assert_eq!(fs::read_to_string(&mine).unwrap(), "mine");
        assert_eq!(fs::read_to_string(&path).unwrap(), "theirs");
        fs::remove_dir_all(&folder).unwrap();
    }
}
