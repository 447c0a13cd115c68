//! Where comparisons run: folders, our own programs, the machine; how other codes are found.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use super::program;
use super::reading::{Found, Reading};
use crate::cargo;
use serde_json::Value;

/// What builds our side; one call, so that one set of features is built.
const BUILD: &str = "build --release --package coque --bin coque --package peridynamics --example held_block \
                     --package sph-shell --example tangent_matrix";

/// Folders and threads of all comparisons.
pub struct Place {
    /// The root of the workspace.
    pub root: PathBuf,
    /// target/peers: the report, and a folder for each comparison.
    pub folder: PathBuf,
    /// Threads asked for.
    pub threads: u32,
}

impl Place {
    pub fn prepare(threads: u32) -> Result<Self, String> {
        let folder = cargo::target()?.join("peers");
        made(&folder)?;
        Ok(Self { root: cargo::root(), folder, threads })
    }

    /// Builds our programs in release mode.
    pub fn build(&self) -> Result<(), String> {
        let words = cargo::words(&BUILD.split(' ').collect::<Vec<_>>());
        if cargo::succeeds(&words)? {
            return Ok(());
        }
        Err(format!("{} failed; its message stands above", cargo::spelled(&words)))
    }

    /// A folder of this name below target/peers, there from now on.
    pub fn at(&self, name: &str) -> Result<PathBuf, String> {
        let folder = self.folder.join(name);
        made(&folder)?;
        Ok(folder)
    }

    /// A deck or script of xtask/peers.
    pub fn deck(&self, name: &str) -> PathBuf {
        self.root.join("xtask/peers").join(name)
    }

    /// A program of ours, as `build` leaves it.
    pub fn ours(&self, name: &str) -> PathBuf {
        let target = self.folder.parent().unwrap_or(&self.folder).join("release");
        target.join(format!("{name}{}", std::env::consts::EXE_SUFFIX))
    }

    /// A scene run by coque, `sets` in place of what it says: the folder with its results, and what the whole program took.
    pub fn scene(&self, scene: &Path, name: &str, sets: &[&str]) -> Result<Scene, String> {
        let folder = self.at(name)?;
        let out = folder.join("out");
        let mut command = Command::new(self.ours("coque"));
        command.arg("run").arg(scene).arg("--out").arg(&out).args(["--threads", &self.threads.to_string()]);
        for set in sets {
            command.args(["--set", set]);
        }
        let ran = program::run(&mut command, &folder, self.threads)?;
        let curve = read(&out.join("curve.csv"))?;
        let summary = serde_json::from_str(&read(&out.join("summary.json"))?).map_err(|e| e.to_string())?;
        Ok(Scene { reading: Reading::of_program(ran, Vec::new()), curve, summary })
    }
}

/// What a run of a scene left.
pub struct Scene {
    /// Time and memory of the whole program; no answers yet.
    pub reading: Reading,
    curve: String,
    /// summary.json.
    pub summary: Value,
}

impl Scene {
    /// The numbers of a column of curve.csv, whose name may be followed by its unit.
    pub fn column(&self, name: &str) -> Result<Vec<f64>, String> {
        column(&self.curve, name).ok_or_else(|| format!("curve.csv has no column {name} of numbers"))
    }
}

fn column(curve: &str, name: &str) -> Option<Vec<f64>> {
    let mut lines = curve.lines();
    let head = lines.next()?;
    let place = head.split(',').position(|title| title.split(" [").next() == Some(name))?;
    lines.map(|line| line.split(',').nth(place)?.trim().parse().ok()).collect()
}

/// A program on the PATH, and the first words of a line of what it prints that begin with `mark`.
pub fn installed(program: &str, word: &str, mark: &str) -> Option<Found> {
    let output = Command::new(program).arg(word).stdin(Stdio::null()).output().ok()?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let line = text.lines().find(|line| line.contains(mark))?;
    let (_, version) = line.split_once(mark)?;
    Some(Found { program: program.into(), version: version.trim().to_owned() })
}

/// A Python that can run `code`, which imports a package and prints its version: that of target/peers/NAME, else the one on the PATH.
pub fn python(place: &Place, name: &str, code: &str) -> Option<Found> {
    let own = place.folder.join(name).join(if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" });
    [own, "python3".into()].into_iter().find_map(|program| {
        let output = Command::new(&program).args(["-c", code]).stdin(Stdio::null()).output().ok()?;
        let version = String::from_utf8_lossy(&output.stdout).lines().next()?.trim().to_owned();
        (output.status.success() && !version.is_empty()).then_some(Found { program, version })
    })
}

/// The text of a file.
pub fn read(file: &Path) -> Result<String, String> {
    fs::read_to_string(file).map_err(|error| format!("cannot read {}: {error}", file.display()))
}

fn made(folder: &Path) -> Result<(), String> {
    fs::create_dir_all(folder).map_err(|error| format!("cannot make {}: {error}", folder.display()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_column_is_found_by_its_name_without_its_unit() {
        let curve = "mode [-],circular_frequency [-]\n1.0,19.7\n2.0,49.3\n";
        assert_eq!(column(curve, "circular_frequency"), Some(vec![19.7, 49.3]));
        assert_eq!(column(curve, "frequency"), None);
        assert_eq!(column("a\nnone\n", "a"), None);
    }

    #[test]
    fn a_program_that_is_not_there_is_not_found() {
        assert!(installed("no-such-program-anywhere", "-v", "Version").is_none());
        assert!(installed("cargo", "--version", "cargo ").is_some());
    }
}
