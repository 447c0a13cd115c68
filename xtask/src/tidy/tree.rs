//! The text files of the checkout, found without git so that an exported tree can be checked too.

use std::fs;
use std::io::ErrorKind;
use std::path::Path;

/// A text file.
#[derive(Debug, Clone)]
pub struct SourceFile {
    /// Relative to the root, with forward slashes.
    pub path: String,
    /// Its whole content.
    pub text: String,
}

/// Folders that hold what was made, not what was written; the same as in .gitignore.
const MADE: &[&str] = &[".git", "target", "__pycache__"];
const MADE_AT_ROOT: &[&str] = &["out", "report"];

/// Every text file below `root`, in the order of the paths.
pub fn read(root: &Path) -> Result<Vec<SourceFile>, String> {
    let mut files = Vec::new();
    descend(root, "", &mut files)?;
    files.sort_by(|a, b| a.path.cmp(&b.path));
    Ok(files)
}

fn descend(folder: &Path, prefix: &str, files: &mut Vec<SourceFile>) -> Result<(), String> {
    let problem = |error: std::io::Error| format!("cannot read {}: {error}", folder.display());
    for entry in fs::read_dir(folder).map_err(problem)? {
        let entry = entry.map_err(problem)?;
        let name = entry.file_name().to_string_lossy().into_owned();
        let path = format!("{prefix}{name}");
        // links are left alone: they could lead out of the tree or round in circles
        let kind = entry.file_type().map_err(problem)?;
        if is_made(&name, prefix.is_empty()) {
            continue;
        }
        if kind.is_dir() {
            descend(&entry.path(), &format!("{path}/"), files)?;
        } else if kind.is_file() {
            match fs::read_to_string(entry.path()) {
                Ok(text) => files.push(SourceFile { path, text }),
                Err(error) if error.kind() == ErrorKind::InvalidData => {} // a picture or another binary
                Err(error) if error.kind() == ErrorKind::NotFound => {}    // an editor's file, gone meanwhile
                Err(error) => return Err(format!("cannot read {path}: {error}")),
            }
        }
    }
    Ok(())
}

fn is_made(name: &str, at_root: bool) -> bool {
    MADE.contains(&name) || (at_root && MADE_AT_ROOT.contains(&name))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_this_package_in_order_with_relative_paths() {
        let files = read(Path::new(env!("CARGO_MANIFEST_DIR"))).unwrap();
        let paths: Vec<_> = files.iter().map(|file| file.path.as_str()).collect();
        assert!(paths.contains(&"src/tidy/tree.rs") && paths.contains(&"Cargo.toml"));
        assert!(paths.is_sorted());
    }

    #[test]
    fn what_was_made_is_left_out() {
        assert!(is_made("target", false) && is_made("out", true));
        assert!(!is_made("out", false) && !is_made("src", true));
    }
}
