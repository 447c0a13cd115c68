//! `cargo xtask bench`: every bench target of the workspace, those that count instructions only under valgrind.

use crate::cargo;
use clap::Args;
use serde_json::Value;

/// What to measure.
#[derive(Args)]
pub struct Options {
    /// Only benches whose name contains this text
    #[arg(value_name = "FILTER")]
    filter: Option<String>,
}

/// A `[[bench]]` of one package.
#[derive(Debug, PartialEq, Eq)]
struct Target {
    package: String,
    name: String,
}

/// Run the benches one after another; stops at the first that fails.
pub fn run(options: &Options) -> Result<(), String> {
    let targets = targets(&cargo::metadata()?);
    if targets.is_empty() {
        println!("no bench target in the workspace: add a [[bench]] to a Cargo.toml");
    }
    let valgrind = cargo::has_program("valgrind");
    for target in &targets {
        if target.counts_instructions() && !valgrind {
            println!("*** SKIPPED {}/{}: valgrind is not installed ***", target.package, target.name);
            continue;
        }
        let words = target.words(options.filter.as_deref());
        println!("\n── {}", cargo::spelled(&words));
        if !cargo::succeeds(&words)? {
            return Err(format!("bench {}/{} failed", target.package, target.name));
        }
    }
    Ok(())
}

fn targets(metadata: &Value) -> Vec<Target> {
    let list = |value: &Value| value.as_array().cloned().unwrap_or_default();
    let mut found = Vec::new();
    for package in list(&metadata["packages"]) {
        for target in list(&package["targets"]) {
            if list(&target["kind"]).iter().any(|kind| kind == "bench") {
                let text = |value: &Value| value.as_str().unwrap_or_default().to_owned();
                found.push(Target { package: text(&package["name"]), name: text(&target["name"]) });
            }
        }
    }
    found
}

impl Target {
    fn counts_instructions(&self) -> bool {
        self.name.contains("instructions")
    }

    fn words(&self, filter: Option<&str>) -> Vec<String> {
        let mut words = cargo::words(&["bench", "--package", &self.package, "--bench", &self.name]);
        words.extend(filter.into_iter().flat_map(|filter| ["--".to_owned(), filter.to_owned()]));
        words
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn finds_bench_targets_and_nothing_else() {
        let metadata = json!({"packages": [
            {"name": "a", "targets": [{"name": "a", "kind": ["lib"]}, {"name": "sweep", "kind": ["bench"]}]},
            {"name": "b", "targets": [{"name": "instructions", "kind": ["bench"]}, {"name": "t", "kind": ["test"]}]},
        ]});
        let found = targets(&metadata);
        let names: Vec<_> =
            found.iter().map(|target| (target.package.as_str(), target.name.as_str())).collect();
        assert_eq!(names, [("a", "sweep"), ("b", "instructions")]);
        assert!(!found[0].counts_instructions() && found[1].counts_instructions());
    }

    #[test]
    fn the_filter_is_passed_on() {
        let target = Target { package: "a".to_owned(), name: "sweep".to_owned() };
        assert_eq!(cargo::spelled(&target.words(None)), "cargo bench --package a --bench sweep");
        assert_eq!(
            cargo::spelled(&target.words(Some("ring"))),
            "cargo bench --package a --bench sweep -- ring"
        );
    }
}
