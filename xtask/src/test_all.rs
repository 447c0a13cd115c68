//! `cargo xtask test` and `ci`: the steps that stand between a change and the main branch.

use crate::{aarch64, cargo, mpi, package, python, tidy, validate};
use std::time::{Duration, Instant};

/// How far the validation goes.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Depth {
    /// The quick cases, which are tests of the crate `validation`.
    Quick,
    /// Then all of them in release mode, with a report.
    Full,
}

/// One thing to check.
struct Step {
    name: &'static str,
    action: Action,
}

enum Action {
    /// Words after `cargo`.
    Cargo(Vec<String>),
    /// The same, if the subcommand is installed; else the step is skipped.
    IfInstalled(&'static str, Vec<String>),
    /// The rules of [`tidy`], in this process.
    Tidy,
    /// The environment of [`python`]; skipped where it cannot be made.
    Python,
    /// Another processor, [`aarch64`]; not run where its tools are missing.
    Aarch64,
    /// The tests of the package; skipped where there is no such environment.
    Package,
    /// An MPI library, which the tests of several processes take; skipped where there is none.
    Mpi,
}

#[derive(Clone, PartialEq, Eq, Debug)]
enum Outcome {
    Passed,
    Skipped(String),
    /// Nobody is held to have its tools.
    NotRun(String),
    Failed,
}

/// Run every step in order and stop at the first that fails. Where the environment variable CI is set, a step that is
/// skipped fails the run too, at its end: nobody is there to read that something was not looked at. One that needs another
/// processor may be left out there too, and says so.
pub fn run(depth: Depth) -> Result<(), String> {
    let strict = std::env::var_os("CI").is_some_and(|value| !value.is_empty());
    perform(&plan(depth, cargo::has("nextest"), mpi::missing().is_none()), strict)
}

/// Run the tests of several processes alone.
pub fn of_processes() -> Result<(), String> {
    match mpi::missing() {
        Some(why) => Err(why),
        None => perform(&[Step { name: "processes", action: Action::Cargo(mpi::tests()) }], true),
    }
}

/// Performs some steps; `strict` where each must be.
fn perform(steps: &[Step], strict: bool) -> Result<(), String> {
    let mut lines = Vec::new();
    let mut tally = Tally::default();
    for step in steps {
        println!("\n── {} ── {}", step.name, step.action.repeat());
        let start = Instant::now();
        let outcome = step.action.perform();
        lines.push(line(step.name, &outcome, start.elapsed()));
        match outcome {
            Outcome::Passed => tally.passed += 1,
            Outcome::Skipped(why) => {
                println!("*** SKIPPED {}: {why} ***", step.name);
                tally.skipped.push(step);
            }
            Outcome::NotRun(why) => println!("*** NOT RUN {}: {why} ***", step.name),
            Outcome::Failed => {
                tally.failed = Some(step);
                break;
            }
        }
    }
    println!("\n{}", lines.join("\n"));
    println!("{}", tally.closing());
    tally.verdict(strict)
}

/// How the steps ended.
#[derive(Default)]
struct Tally<'a> {
    passed: usize,
    skipped: Vec<&'a Step>,
    failed: Option<&'a Step>,
}

impl Tally<'_> {
    /// The last line of the run.
    fn closing(&self) -> String {
        let (failed, skipped) = (usize::from(self.failed.is_some()), self.skipped.len());
        format!("{} passed, {failed} failed, {skipped} skipped", self.passed)
    }

    fn verdict(&self, strict: bool) -> Result<(), String> {
        if let Some(step) = self.failed {
            return Err(format!("{} failed; repeat it alone with: {}", step.name, step.action.repeat()));
        }
        if strict && !self.skipped.is_empty() {
            let names: Vec<_> = self.skipped.iter().map(|step| step.name).collect();
            return Err(format!(
                "skipped: {}; where CI is set every step must be performed: install what it lacks, or unset CI",
                names.join(", ")
            ));
        }
        Ok(())
    }
}

/// The steps, cheapest first.
fn plan(depth: Depth, nextest: bool, mpi: bool) -> Vec<Step> {
    let words = cargo::words;
    let tests = if nextest { &["nextest", "run", "--workspace"][..] } else { &["test", "--workspace"] };
    let with = if mpi { &mpi::FEATURE[..] } else { &[] };
    let tests = words(&[tests, with].concat());
    // `cargo test --workspace` already runs the documentation tests
    let documentation = nextest.then(|| words(&["test", "--doc", "--workspace"]));
    let full =
        validate::Options { full: true, report: Some("target/ci-report".to_owned()), ..Default::default() };

    let clippy = words(&["clippy", "--workspace", "--all-targets", "--", "-D", "warnings"]);
    // broken links between pages are warnings, and no page should have one
    let strict = r#"build.rustdocflags = ["-D", "warnings"]"#;
    let pages = words(&["doc", "--workspace", "--no-deps", "--config", strict]);
    let mut steps = vec![
        Step { name: "format", action: Action::IfInstalled("fmt", words(&["fmt", "--all", "--check"])) },
        Step { name: "tidy", action: Action::Tidy },
        Step { name: "lints", action: Action::IfInstalled("clippy", clippy) },
        Step { name: "pages", action: Action::Cargo(pages) },
        Step { name: "python", action: Action::Python },
        Step { name: "MPI library", action: Action::Mpi },
        Step { name: "tests", action: Action::Cargo(tests) },
        Step { name: "python package", action: Action::Package },
    ];
    steps.extend(documentation.map(|words| Step { name: "doc tests", action: Action::Cargo(words) }));
    steps.push(Step { name: "aarch64", action: Action::Aarch64 });
    if depth == Depth::Full {
        steps.push(Step { name: "validation, full", action: Action::Cargo(full.words()) });
    }
    steps
}

impl Action {
    fn perform(&self) -> Outcome {
        let result = match self {
            Self::IfInstalled(subcommand, _) if !cargo::has(subcommand) => {
                return Outcome::Skipped(missing(subcommand));
            }
            Self::IfInstalled(_, words) | Self::Cargo(words) => cargo::succeeds(words),
            Self::Tidy => tidy::run().map(|()| true),
            Self::Python => match python::make() {
                Ok(()) => Ok(true),
                Err(why) => return Outcome::Skipped(format!("{why}; fields are not read back by meshio")),
            },
            Self::Aarch64 => match aarch64::Tools::find() {
                Ok(tools) => tools.check().map(|()| true),
                Err(why) => return Outcome::NotRun(why),
            },
            Self::Mpi => match mpi::missing() {
                None => Ok(true),
                Some(why) => return Outcome::Skipped(why),
            },
            Self::Package => match python::program() {
                Ok(_) => package::test(),
                Err(why) => return Outcome::Skipped(format!("{why}; the package for Python is not tested")),
            },
        };
        match result {
            Ok(true) => Outcome::Passed,
            Ok(false) => Outcome::Failed,
            Err(message) => {
                eprintln!("error: {message}");
                Outcome::Failed
            }
        }
    }

    /// The exact command that repeats the step.
    fn repeat(&self) -> String {
        match self {
            Self::Cargo(words) | Self::IfInstalled(_, words) => cargo::spelled(words),
            Self::Tidy => "cargo xtask tidy".to_owned(),
            Self::Python => "cargo xtask python".to_owned(),
            Self::Aarch64 => "cargo xtask aarch64".to_owned(),
            Self::Package => "cargo xtask package".to_owned(),
            Self::Mpi => "cargo xtask test --mpi".to_owned(),
        }
    }
}

fn missing(subcommand: &str) -> String {
    let component = if subcommand == "fmt" { "rustfmt" } else { subcommand };
    format!("cargo {subcommand} is not installed; add it with: rustup component add {component}")
}

fn line(name: &str, outcome: &Outcome, time: Duration) -> String {
    let word = match outcome {
        Outcome::Passed => "passed",
        Outcome::Skipped(_) => "SKIPPED",
        Outcome::NotRun(_) => "NOT RUN",
        Outcome::Failed => "FAILED",
    };
    format!("{name:<20} {word:<8} {:>8.1} s", time.as_secs_f64())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn commands(depth: Depth, nextest: bool) -> Vec<String> {
        plan(depth, nextest, nextest).iter().map(|step| step.action.repeat()).collect()
    }

    #[test]
    fn the_plan_holds_every_check() {
        assert_eq!(
            commands(Depth::Quick, true),
            [
                "cargo fmt --all --check",
                "cargo xtask tidy",
                "cargo clippy --workspace --all-targets -- -D warnings",
                "cargo doc --workspace --no-deps --config 'build.rustdocflags = [\"-D\", \"warnings\"]'",
                "cargo xtask python",
                "cargo xtask test --mpi",
                "cargo nextest run --workspace --features coque-mpi/mpi",
                "cargo xtask package",
                "cargo test --doc --workspace",
                "cargo xtask aarch64",
            ]
        );
        assert_eq!(commands(Depth::Quick, false)[6..7], ["cargo test --workspace"]);
        assert!(!commands(Depth::Quick, false).iter().any(|command| command.contains("--doc")));
    }

    #[test]
    fn ci_adds_the_full_validation() {
        let (quick, full) = (commands(Depth::Quick, true), commands(Depth::Full, true));
        assert_eq!(full[..quick.len()], quick[..]);
        assert!(full[quick.len()].ends_with("validate -- --full --report target/ci-report"));
    }

    #[test]
    fn a_missing_component_is_skipped_and_says_how_to_get_it() {
        let action = Action::IfInstalled("no-such-subcommand", Vec::new());
        assert!(matches!(action.perform(), Outcome::Skipped(why) if why.contains("rustup component add")));
        assert!(missing("fmt").ends_with("rustfmt"));
    }

    #[test]
    fn a_failing_step_fails() {
        let action = Action::Cargo(cargo::words(&["no-such-subcommand-anywhere"]));
        assert_eq!(action.perform(), Outcome::Failed);
    }

    fn step(name: &'static str, action: Action) -> Step {
        Step { name, action }
    }

    #[test]
    fn the_last_line_counts_what_was_skipped() {
        let (one, other) = (step("lints", Action::Tidy), step("python", Action::Python));
        let skipped = Tally { passed: 5, skipped: vec![&one, &other], failed: None };
        assert_eq!(skipped.closing(), "5 passed, 0 failed, 2 skipped");
        assert_eq!(Tally { failed: Some(&one), ..skipped }.closing(), "5 passed, 1 failed, 2 skipped");
        assert_eq!(Tally::default().closing(), "0 passed, 0 failed, 0 skipped");
        let row = line("lints", &Outcome::Skipped(String::new()), Duration::from_millis(1250));
        assert!(row.contains("SKIPPED") && row.ends_with("1.2 s"), "{row}");
    }

    #[test]
    fn a_skip_fails_where_every_step_must_be_performed() {
        let missing = || step("lints", Action::IfInstalled("no-such-subcommand", Vec::new()));
        let held = || step("version", Action::Cargo(cargo::words(&["--version"])));
        assert_eq!(perform(&[missing(), held()], false), Ok(()));
        let refused = perform(&[missing(), held()], true).unwrap_err();
        assert!(refused.starts_with("skipped: lints;"), "{refused}");
        assert_eq!(perform(&[held()], true), Ok(()));
        // a step that fails is named before those that were skipped
        let fails = step("tests", Action::Cargo(cargo::words(&["no-such-subcommand-anywhere"])));
        assert!(perform(&[missing(), fails], true).unwrap_err().starts_with("tests failed"));
    }
}
