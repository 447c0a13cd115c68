//! `cargo xtask validate`: hand the question over to the judge, in release mode.

use crate::cargo;
use clap::Args;
use std::process::{Command, ExitCode};

/// What is passed on to the program `validate`.
#[derive(Args, Default)]
pub struct Options {
    /// Only the cases that are fast enough for every commit
    #[arg(long)]
    pub quick: bool,
    /// All runs but the heavy ones: those that take up to ten minutes as well
    #[arg(long, conflicts_with_all = ["quick", "heavy"])]
    pub full: bool,
    /// Only the runs that take more than ten minutes each; no other set has them
    #[arg(long, conflicts_with = "quick")]
    pub heavy: bool,
    /// The hard cases in place of the usual ones: where shells and particles break
    #[arg(long)]
    pub hard: bool,
    /// Only this case; may be repeated
    #[arg(long = "case", value_name = "NAME")]
    pub cases: Vec<String>,
    /// Write one record per run: particles, steps, time, metrics with tolerances, curve
    #[arg(long, value_name = "FILE")]
    pub json: Option<String>,
    /// Write the report with plots into this folder
    #[arg(long, value_name = "DIR")]
    pub report: Option<String>,
    /// Beside the report a page for each pictured case, to be turned and played in a browser
    #[arg(long)]
    pub pages: bool,
    /// Show what changed since it was reviewed: old curve, new curve and reference on one page
    #[arg(long, exclusive = true)]
    pub review: bool,
    /// Further arguments, after `--`, passed on as they are
    #[arg(last = true)]
    pub rest: Vec<String>,
}

/// Run the cases and return what the judge returned.
pub fn run(options: &Options) -> ExitCode {
    if options.review {
        return review();
    }
    let words = options.words();
    // not at the root: FILE and DIR are relative to where the caller stands
    finished(&words, &mut cargo::command(&words))
}

/// The quick set against its snapshots: the test leaves each difference beside its snapshot, and all of them on a page.
fn review() -> ExitCode {
    let words = cargo::words(&["test", "--workspace", "--test", "quick"]);
    // also where CI is set, which keeps insta from leaving files
    let code = finished(&words, cargo::command(&words).env("INSTA_UPDATE", "new"));
    if code == ExitCode::SUCCESS {
        println!("nothing to review: the quick set is as it was reviewed");
    } else {
        println!("the page named above shows what changed; accept or refuse it with: cargo insta review");
        println!("(cargo insta is installed by: cargo install cargo-insta)");
    }
    code
}

/// Runs a command to its end and returns its exit code.
fn finished(words: &[String], command: &mut Command) -> ExitCode {
    match command.status() {
        Ok(status) => ExitCode::from(status.code().and_then(|code| u8::try_from(code).ok()).unwrap_or(1)),
        Err(error) => {
            eprintln!("error: cannot start {}: {error}", cargo::spelled(words));
            ExitCode::FAILURE
        }
    }
}

impl Options {
    /// The words after `cargo`.
    pub fn words(&self) -> Vec<String> {
        let mut words =
            cargo::words(&["run", "--release", "--package", "validation", "--bin", "validate", "--"]);
        if self.quick {
            words.push("--quick".to_owned());
        }
        if self.full {
            words.push("--full".to_owned());
        }
        if self.heavy {
            words.push("--heavy".to_owned());
        }
        if self.hard {
            words.push("--hard".to_owned());
        }
        if self.pages {
            words.push("--pages".to_owned());
        }
        for case in &self.cases {
            words.extend(["--case".to_owned(), case.clone()]);
        }
        for (option, value) in [("--json", &self.json), ("--report", &self.report)] {
            words.extend(value.iter().flat_map(|value| [option.to_owned(), value.clone()]));
        }
        words.extend(self.rest.iter().cloned());
        words
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_argument_is_passed_on() {
        let options = Options {
            quick: true,
            full: true,
            heavy: true,
            hard: true,
            cases: cargo::words(&["ring", "panel"]),
            json: Some("a.json".to_owned()),
            report: Some("out".to_owned()),
            pages: true,
            review: false,
            rest: cargo::words(&["--threads", "2"]),
        };
        assert_eq!(
            cargo::spelled(&options.words()),
            "cargo run --release --package validation --bin validate -- \
             --quick --full --heavy --hard --pages --case ring --case panel --json a.json --report out --threads 2"
        );
    }
}
