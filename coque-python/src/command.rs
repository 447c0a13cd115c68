//! The command `coque` within the package.

use std::ffi::OsString;
use std::io::Write;

use pyo3::prelude::*;

/// Obeys a command line, the first word of which is the name of the program; returns the exit code.
#[pyfunction]
pub fn command_line(py: Python<'_>, arguments: Vec<OsString>) -> u8 {
    let code = py.detach(|| coque::command_line(arguments));
    // What Rust has not handed over yet is lost when Python ends the process.
    let _ = std::io::stdout().flush();
    code
}
