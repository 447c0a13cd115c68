//! The Python environment of the tests: target/python, with exactly the packages that the locked list names.

use crate::cargo;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The locked list, relative to the root.
const LIST: &str = "coque/tests/python/requirements.txt";

/// Make the environment if it is not there or its list has changed; why not, if it cannot be made.
pub fn make() -> Result<(), String> {
    let environment = folder()?;
    let list = cargo::root().join(LIST);
    let wanted = fs::read_to_string(&list).map_err(|error| format!("cannot read {LIST}: {error}"))?;
    let stamp = environment.join("requirements.txt");
    if fs::read_to_string(&stamp).is_ok_and(|made| made == wanted) && runs(&python_of(&environment)) {
        println!("{} is as {LIST} wants it", environment.display());
        return Ok(());
    }
    let words = calls(&environment, &list, cargo::has_program("uv"), interpreter()?);
    for words in words {
        println!("{}", words.join(" "));
        let status = Command::new(&words[0]).args(&words[1..]).current_dir(cargo::root()).status();
        match status {
            Ok(status) if status.success() => {}
            Ok(_) => return Err(format!("`{}` failed (no network?)", words.join(" "))),
            Err(error) => return Err(format!("cannot start {}: {error}", words[0])),
        }
    }
    fs::write(&stamp, wanted).map_err(|error| format!("cannot write {}: {error}", stamp.display()))
}

/// Words of the calls that make the environment: with uv, or with what Python brings along.
fn calls(environment: &Path, list: &Path, uv: bool, interpreter: &str) -> [Vec<String>; 2] {
    let owned = |words: &[&str]| cargo::words(words);
    let (environment, list) = (environment.display().to_string(), list.display().to_string());
    let python = python_of(Path::new(&environment)).display().to_string();
    if uv {
        let venv = owned(&["uv", "venv", "--clear", "--python", interpreter, &environment]);
        let install = ["uv", "pip", "install", "--python", &python, "--require-hashes", "-r", &list];
        return [venv, owned(&install)];
    }
    let venv = owned(&[interpreter, "-m", "venv", "--clear", &environment]);
    let quiet = ["--quiet", "--disable-pip-version-check", "--retries", "1", "--timeout", "15"];
    let mut install = owned(&[&python, "-m", "pip", "install"]);
    install.extend(owned(&quiet));
    install.extend(owned(&["--require-hashes", "-r", &list]));
    [venv, install]
}

/// Beside what cargo builds, where the tests look for it.
pub fn folder() -> Result<PathBuf, String> {
    Ok(cargo::target()?.join("python"))
}

/// Its interpreter.
pub fn program() -> Result<PathBuf, String> {
    let program = python_of(&folder()?);
    if runs(&program) { Ok(program) } else { Err("there is no environment: cargo xtask python".to_owned()) }
}

fn interpreter() -> Result<&'static str, String> {
    let known = ["python3", "python"].into_iter().find(|program| cargo::has_program(program));
    known.ok_or_else(|| "there is no Python 3; install it to have the package for Python tested, and fields read back by meshio".to_owned())
}

fn python_of(environment: &Path) -> PathBuf {
    environment.join(if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" })
}

fn runs(program: &Path) -> bool {
    cargo::has_program(&program.display().to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_package_is_pinned_and_hashed() {
        let text = fs::read_to_string(cargo::root().join(LIST)).unwrap();
        let packages: Vec<&str> =
            text.lines().filter(|line| !line.starts_with('#') && line.contains("==")).collect();
        for name in ["meshio", "numpy", "pytest", "mypy", "maturin"] {
            let named = |line: &&str| line.starts_with(&format!("{name}=="));
            assert!(packages.iter().any(named), "{name}");
        }
        // Each package goes on to at least one line of hashes.
        assert!(packages.iter().all(|line| line.ends_with('\\')), "{packages:?}");
        assert!(text.matches("--hash=sha256:").count() >= packages.len());
    }

    #[test]
    fn both_ways_insist_on_the_hashes() {
        let (environment, list) = (Path::new("target/python"), Path::new("list.txt"));
        for uv in [true, false] {
            let [venv, install] = calls(environment, list, uv, "python3");
            assert!(venv.contains(&"--clear".to_owned()) && venv.contains(&"target/python".to_owned()));
            assert!(install.join(" ").ends_with("--require-hashes -r list.txt"));
        }
    }
}
