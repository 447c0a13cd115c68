//! Fields read back by others: meshio holds them against the curve, pyvista draws them.
//!
//! Needs the Python environment that `cargo xtask python` makes under target/python; without it the tests pass and say
//! what they left out.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// Python with these modules; none, and a word on the terminal, if it is not there.
fn python(modules: &str, hint: &str) -> Option<PathBuf> {
    let environment = Path::new(env!("CARGO_TARGET_TMPDIR")).parent()?.join("python");
    let program = environment.join(if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" });
    let imported = Command::new(&program).args(["-c", &format!("import {modules}")]).output();
    if imported.is_ok_and(|output| output.status.success()) {
        return Some(program);
    }
    // Past the capture of the test runner: a test that was left out must not look like one that passed.
    let place = environment.display();
    let message = format!("*** SKIPPED: no {modules} in {place} to read fields back; {hint} ***\n");
    std::io::stderr().write_all(message.as_bytes()).unwrap();
    None
}

const PICTURES: &str = "coque/tests/python/requirements-pictures.txt says how to install it";

/// Runs the panel with everything that can be written; the folder of its results.
fn panel(name: &str) -> PathBuf {
    let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let output = Command::new(env!("CARGO_BIN_EXE_coque"))
        .args(["run", "scenes/panel.toml", "--set", "analysis.static.levels=6"])
        .args(["--set", "output.fields={ stresses = true, extruded = true }", "--out"])
        .arg(&out)
        .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join(".."))
        .output()
        .unwrap();
    succeeded(&output);
    out
}

fn succeeded(output: &Output) -> String {
    let said = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    assert!(output.status.success(), "{}{}", said(&output.stdout), said(&output.stderr));
    said(&output.stdout)
}

fn script(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/python").join(name)
}

#[test]
fn meshio_reads_what_the_run_wrote() {
    let Some(python) = python("meshio, numpy", "`cargo xtask python` installs it") else { return };
    let said = Command::new(python).arg(script("check_fields.py")).arg(panel("meshio")).output().unwrap();
    assert_eq!(succeeded(&said).trim(), "7 frames agree with the curve");
}

#[test]
fn pyvista_draws_what_the_run_wrote() {
    let Some(python) = python("pyvista", PICTURES) else { return };
    let out = panel("pyvista");
    let picture = out.join("panel.png");
    let said = Command::new(python).arg(script("draw_fields.py")).args([&out, &picture]).output().unwrap();
    assert!(succeeded(&said).contains("drawn"));
    assert!(picture.metadata().unwrap().len() > 1000);
}
