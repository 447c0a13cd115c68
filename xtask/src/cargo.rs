//! Calling cargo: from the root of the workspace, with the words printed so that a reader can repeat them.

use serde_json::Value;
use std::path::PathBuf;
use std::process::{Command, Stdio};

/// The root of the workspace.
pub fn root() -> PathBuf {
    // `cargo run` sets the variable anew; the compiled-in value serves a binary that is started by hand
    let own = std::env::var("CARGO_MANIFEST_DIR").unwrap_or_else(|_| env!("CARGO_MANIFEST_DIR").to_owned());
    PathBuf::from(own).parent().map_or_else(|| PathBuf::from("."), PathBuf::from)
}

/// A call of cargo with `words`, in the directory of the caller.
pub fn command(words: &[String]) -> Command {
    let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.args(words);
    command
}

/// The call as a person would type it.
pub fn spelled(words: &[String]) -> String {
    let quoted: Vec<String> = words
        .iter()
        .map(|word| if word.contains(char::is_whitespace) { format!("'{word}'") } else { word.clone() })
        .collect();
    format!("cargo {}", quoted.join(" "))
}

/// Run cargo at the root with its output passed on; whether it succeeded.
pub fn succeeds(words: &[String]) -> Result<bool, String> {
    let status = command(words).current_dir(root()).status();
    status.map(|status| status.success()).map_err(|error| format!("cannot start {}: {error}", spelled(words)))
}

/// Whether a subcommand such as `fmt` or `nextest` is installed.
pub fn has(subcommand: &str) -> bool {
    responds(&mut command(&[subcommand.to_owned(), "--version".to_owned()]))
}

/// Whether a program is on the PATH.
pub fn has_program(program: &str) -> bool {
    responds(Command::new(program).arg("--version"))
}

fn responds(command: &mut Command) -> bool {
    let quiet = command.current_dir(root()).stdout(Stdio::null()).stderr(Stdio::null());
    quiet.status().is_ok_and(|status| status.success())
}

/// What `cargo metadata` says about the packages of the workspace.
pub fn metadata() -> Result<Value, String> {
    let call = words(&["metadata", "--format-version", "1", "--no-deps"]);
    let output = command(&call)
        .current_dir(root())
        .stderr(Stdio::inherit())
        .output()
        .map_err(|error| format!("cannot start {}: {error}", spelled(&call)))?;
    if !output.status.success() {
        return Err(format!("{} failed; its message stands above", spelled(&call)));
    }
    serde_json::from_slice(&output.stdout).map_err(|error| format!("{} is no JSON: {error}", spelled(&call)))
}

/// Where cargo puts what it builds.
pub fn target() -> Result<PathBuf, String> {
    let metadata = metadata()?;
    let target = metadata["target_directory"].as_str().ok_or("cargo metadata names no target directory")?;
    Ok(PathBuf::from(target))
}

/// Literal words as owned ones.
pub fn words(literal: &[&str]) -> Vec<String> {
    literal.iter().map(|&word| word.to_owned()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_call_is_spelled_as_it_is_typed() {
        assert_eq!(spelled(&words(&["bench", "--", "two words"])), "cargo bench -- 'two words'");
    }

    #[test]
    fn the_root_holds_the_workspace() {
        assert!(root().join("Cargo.toml").is_file() && root().join("xtask").is_dir());
    }

    #[test]
    fn a_program_that_is_not_there_is_not_there() {
        assert!(has_program("cargo"));
        assert!(!has_program("no-such-program-anywhere"));
        assert!(!has("no-such-subcommand-anywhere"));
    }
}
