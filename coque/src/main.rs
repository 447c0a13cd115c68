//! The command `coque`: runs a scene and writes its results.

use std::process::ExitCode;

fn main() -> ExitCode {
    coque::command_line(std::env::args_os()).into()
}
