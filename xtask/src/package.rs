//! The Python package: built for development and tested in the environment of [`crate::python`], or as a wheel.

use crate::{cargo, python};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The Rust half and the Python half, relative to the root.
const CRATE: &str = "coque-python";
const MODULES: &str = "coque-python/python/coque";

/// Build the package for development, test it, check its types; whether all passed.
pub fn test() -> Result<bool, String> {
    if !cargo::succeeds(&cargo::words(&["build", "-p", CRATE, "-p", "coque"]))? {
        return Ok(false);
    }
    let built = cargo::target()?.join("debug");
    let package = python::folder()?.join("package");
    assemble(&built, &package.join("coque"))?;
    let command = built.join(format!("coque{}", std::env::consts::EXE_SUFFIX));
    for words in checks() {
        println!("python -m {}", words.join(" "));
        let mut python = Command::new(python::program()?);
        python.args(["-B", "-m"]).args(words).current_dir(cargo::root().join(CRATE));
        python.env("PYTHONPATH", &package).env("COQUE", &command);
        let status = python.status().map_err(|error| format!("cannot start Python: {error}"))?;
        if !status.success() {
            return Ok(false);
        }
    }
    Ok(true)
}

/// Tests, then types: those of the sources, and of what Rust offers to them.
fn checks() -> [&'static [&'static str]; 3] {
    [
        &["pytest", "-q", "-p", "no:cacheprovider"],
        &["mypy", "--cache-dir", "../target/mypy", "python/coque"],
        &["mypy.stubtest", "coque._coque"],
    ]
}

/// Lay the modules and what Rust built side by side, as Python imports them.
fn assemble(built: &Path, to: &Path) -> Result<(), String> {
    let refused = |error: std::io::Error| format!("cannot make {}: {error}", to.display());
    if to.is_dir() {
        fs::remove_dir_all(to).map_err(refused)?;
    }
    fs::create_dir_all(to).map_err(refused)?;
    for entry in fs::read_dir(cargo::root().join(MODULES)).map_err(refused)? {
        let entry = entry.map_err(refused)?;
        if entry.path().is_file() {
            fs::copy(entry.path(), to.join(entry.file_name())).map_err(refused)?;
        }
    }
    let library = format!("{}_coque{}", std::env::consts::DLL_PREFIX, std::env::consts::DLL_SUFFIX);
    let module = if cfg!(windows) { "_coque.pyd" } else { "_coque.abi3.so" };
    fs::copy(built.join(&library), to.join(module)).map_err(refused)?;
    Ok(())
}

/// Build the wheel in release mode into target/wheels, and say how large it is.
pub fn wheel() -> Result<(), String> {
    python::make()?;
    let wheels = cargo::target()?.join("wheels");
    let out = wheels.display().to_string();
    let manifest = format!("{CRATE}/Cargo.toml");
    let words = ["-m", "maturin", "build", "--release", "--strip", "--locked", "--manifest-path", &manifest];
    let mut python = Command::new(python::program()?);
    let status = python.args(words).args(["--out", &out]).current_dir(cargo::root()).status();
    match status {
        Ok(status) if status.success() => {}
        Ok(_) => return Err("maturin failed; its message stands above".to_owned()),
        Err(error) => return Err(format!("cannot start maturin: {error}")),
    }
    if let Some(wheel) = newest(&wheels)? {
        let size = fs::metadata(&wheel).map_or(0, |data| data.len());
        println!("{}: {:.1} MB; pip install it", wheel.display(), 1e-6 * size as f64);
    }
    Ok(())
}

/// The wheel that was made last.
fn newest(wheels: &Path) -> Result<Option<PathBuf>, String> {
    let entries =
        fs::read_dir(wheels).map_err(|error| format!("cannot read {}: {error}", wheels.display()))?;
    let all = entries.flatten().map(|entry| entry.path());
    let made = |path: &PathBuf| fs::metadata(path).and_then(|data| data.modified()).ok();
    Ok(all.filter(|path| path.extension().is_some_and(|ending| ending == "whl")).max_by_key(made))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_package_is_the_modules_and_the_library() {
        let folder = std::env::temp_dir().join(format!("xtask-package-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        let library = format!("{}_coque{}", std::env::consts::DLL_PREFIX, std::env::consts::DLL_SUFFIX);
        let package = folder.join("coque");
        assert!(assemble(&folder, &package).is_err(), "nothing is built");
        fs::write(folder.join(library), "built").unwrap();
        assemble(&folder, &package).unwrap();
        assert!(package.join("__init__.py").is_file() && package.join("py.typed").is_file());
        assert_eq!(fs::read_dir(&package).unwrap().flatten().filter(|e| is_library(&e.path())).count(), 1);
        fs::remove_dir_all(&folder).unwrap();
    }

    fn is_library(path: &Path) -> bool {
        path.extension().is_some_and(|ending| ending == "so" || ending == "pyd")
    }

    #[test]
    fn the_newest_wheel_is_found_among_other_files() {
        let folder = std::env::temp_dir().join(format!("xtask-wheels-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        assert_eq!(newest(&folder).unwrap(), None);
        fs::write(folder.join("coque.whl"), "").unwrap();
        fs::write(folder.join("notes.txt"), "").unwrap();
        assert_eq!(newest(&folder).unwrap(), Some(folder.join("coque.whl")));
        fs::remove_dir_all(&folder).unwrap();
    }
}
