//! Which crate may use which: the arrows of the architecture, read from `cargo metadata`.
//!
//! Normal, build and dev-dependencies count alike: a test that reaches across a layer would tie the layers together.

use super::Violation;
use serde_json::Value;
use std::path::Path;

/// What every layer may use: arithmetic, loops, peers, which know no mechanics.
const GROUND: &[&str] = &["lanes", "parallel", "peers"];

/// Crates without any of ours below them but the ground: space, one point, time, balance; the workspace's commands.
const LEAVES: &[&str] =
    &["sph-core", "shell-kinematics", "solid-kinematics", "explicit-dynamics", "implicit-statics", "xtask"];

/// Crates of files, and the one leaf that they may use: surfaces become particles.
const FILES: &[&str] = &["mesh-io"];
const SPACE: &str = "sph-core";

/// What joins surfaces that touch: it sees space alone, and models see it.
const TOUCH: &str = "contact";

/// Heat that runs: it sees time and balance alone, and models see it.
const HEAT: &str = "heat-conduction";
const TIME: &str = "explicit-dynamics";

/// The crate that shows files, and the one of ours that it may use.
const VIEW: &str = "viewer";

/// Crates that join leaves into a model of a body; none sees another.
const MODELS: &[&str] = &["sph-shell", "peridynamics", "fluid-sph", "sr-galerkin", "rigid-body"];

/// Crates above the models.
const ABOVE: &[&str] = &["coque", "coque-mpi", "coque-python", "validation"];

/// The truth, the only crate that may read it, and the only one of ours that its own shell may use.
const TRUTH: &str = "benchmarks-ref";
const JUDGE: &str = "validation";
const BALANCE: &str = "implicit-statics";

/// A package of the workspace.
#[derive(Debug)]
pub struct Package {
    name: String,
    /// Path of its Cargo.toml, relative to the root.
    manifest: String,
    /// Packages of this workspace that it names in any kind of dependency, with the line.
    uses: Vec<(String, usize)>,
}

/// Read the packages and the arrows between them.
pub fn packages(metadata: &Value, root: &Path) -> Result<Vec<Package>, String> {
    let unexpected =
        || "cargo metadata has an unexpected shape; compare its format version with 1".to_owned();
    let entries = metadata["packages"].as_array().ok_or_else(unexpected)?;
    entries
        .iter()
        .map(|entry| {
            let path = Path::new(entry["manifest_path"].as_str().ok_or_else(unexpected)?);
            let text = std::fs::read_to_string(path)
                .map_err(|error| format!("cannot read {}: {error}", path.display()))?;
            let manifest = path.strip_prefix(root).unwrap_or(path).to_string_lossy().replace('\\', "/");
            package(entry, manifest, &text).ok_or_else(unexpected)
        })
        .collect()
}

/// A dependency with a path is one of ours.
fn package(entry: &Value, manifest: String, text: &str) -> Option<Package> {
    let dependencies = entry["dependencies"].as_array()?;
    let own = dependencies.iter().filter(|dependency| dependency["path"].is_string());
    let uses = own
        .filter_map(|dependency| dependency["name"].as_str())
        .map(|name| (name.to_owned(), line(text, name)));
    Some(Package { name: entry["name"].as_str()?.to_owned(), manifest, uses: uses.collect() })
}

/// The line of a manifest that names a dependency, counted from 1.
fn line(text: &str, name: &str) -> usize {
    let names = |line: &str| {
        let key = line.trim_start().strip_prefix(name);
        key.is_some_and(|rest| rest.starts_with(['.', ' ', '=']))
    };
    text.lines().position(names).map_or(1, |index| index + 1)
}

/// Every arrow that should not be there, and every crate without a place.
pub fn check(packages: &[Package]) -> Vec<Violation> {
    let mut violations = Vec::new();
    for package in packages {
        if ![GROUND, LEAVES, FILES, MODELS, ABOVE, &[TRUTH, VIEW, TOUCH, HEAT]]
            .iter()
            .any(|layer| layer.contains(&package.name.as_str()))
        {
            violations.push(Violation::new(
                &package.manifest,
                1,
                format!("the crate {} has no layer", package.name),
                "give it one in xtask/src/tidy/layers.rs and in ARCHITECTURE.md",
            ));
        }
        for (used, line) in &package.uses {
            if let Some((what, repair)) = forbidden(&package.name, used) {
                violations.push(Violation::new(&package.manifest, *line, what, repair));
            }
        }
    }
    violations
}

/// Why `user` may not use `used`, and what to do instead.
fn forbidden(user: &str, used: &str) -> Option<(String, &'static str)> {
    if user == TRUTH && used == BALANCE {
        return None;
    }
    if GROUND.contains(&user) {
        let repair = "remove the dependency; the ground knows nothing of what stands on it";
        return Some((format!("{user} is below all others but uses {used}"), repair));
    }
    if user == TRUTH {
        let repair = "write it anew: a cross-check that shares code with what it checks proves nothing";
        return Some((format!("{TRUTH} uses {used}; of ours it may use {BALANCE} alone"), repair));
    }
    if GROUND.contains(&used) {
        return None;
    }
    if LEAVES.contains(&user) {
        let repair = "remove the dependency; what both need belongs to the crate that joins them";
        return Some((format!("{user} is a leaf but uses {used}"), repair));
    }
    if used == TRUTH && user != JUDGE {
        let repair = "move the comparison to validation: a solver that can read the answer proves nothing";
        return Some((format!("{user} reads {TRUTH}, which only {JUDGE} may"), repair));
    }
    if (FILES.contains(&user) || user == TOUCH) && used != SPACE {
        let repair = "hand over plain arrays; what they mean belongs to the crates above";
        return Some((format!("{user} uses {used}; of ours it may use {SPACE} alone"), repair));
    }
    if user == HEAT && ![TIME, BALANCE].contains(&used) {
        let repair = "let the model say what conducts; shapes belong to the crates above";
        return Some((format!("{user} uses {used}; of ours it may use {TIME} and {BALANCE} alone"), repair));
    }
    if user == VIEW && !FILES.contains(&used) {
        let repair = "hand over frames and words; what they mean belongs to the crates above";
        return Some((format!("{user} uses {used}; of ours it may use {} alone", FILES[0]), repair));
    }
    if MODELS.contains(&user) && !LEAVES.contains(&used) && ![TOUCH, HEAT].contains(&used) {
        let repair = "let the two meet above both, or move what they share down into a leaf";
        return Some((format!("the model {user} uses {used}, which is no leaf"), repair));
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn using(name: &str, uses: &[&str]) -> Package {
        let uses = uses.iter().map(|&used| (used.to_owned(), 3)).collect();
        Package { name: name.to_owned(), manifest: format!("{name}/Cargo.toml"), uses }
    }

    fn complaints(name: &str, uses: &[&str]) -> Vec<String> {
        check(&[using(name, uses)]).iter().map(ToString::to_string).collect()
    }

    #[test]
    fn the_architecture_as_drawn_passes() {
        let drawn = [
            using("lanes", &[]),
            using("sph-core", &[]),
            using("shell-kinematics", &["lanes"]),
            using(
                "sph-shell",
                &[
                    "lanes",
                    "sph-core",
                    "shell-kinematics",
                    "explicit-dynamics",
                    "implicit-statics",
                    "contact",
                ],
            ),
            using("contact", &["sph-core"]),
            using("mesh-io", &["sph-core"]),
            using("viewer", &["mesh-io"]),
            using("coque", &["sph-core", "sph-shell", "fluid-sph", "mesh-io", "viewer"]),
            using("coque-python", &["coque"]),
            using("benchmarks-ref", &["implicit-statics"]),
            using("validation", &["coque", "benchmarks-ref"]),
            using("xtask", &[]),
        ];
        assert_eq!(check(&drawn), []);
    }

    #[test]
    fn a_leaf_may_use_nothing_of_ours() {
        for leaf in LEAVES {
            let found = complaints(leaf, &["sph-shell"]);
            assert_eq!(found.len(), 1);
            assert!(found[0].starts_with(&format!("{leaf}/Cargo.toml:3: {leaf} is a leaf")), "{found:?}");
        }
        assert_eq!(complaints("sph-core", &["shell-kinematics"]).len(), 1);
    }

    #[test]
    fn the_ground_uses_nothing_of_ours() {
        for ground in GROUND {
            let found = complaints(ground, &["sph-core"]);
            assert_eq!(found.len(), 1);
            assert!(found[0].contains("is below all others but uses sph-core"), "{found:?}");
        }
        assert_eq!(
            complaints("benchmarks-ref", &["lanes"]).len(),
            1,
            "the truth shares no arithmetic either"
        );
    }

    #[test]
    fn a_model_may_not_see_another_nor_the_application() {
        assert_eq!(complaints("sph-shell", &["peridynamics"]).len(), 1);
        assert_eq!(complaints("fluid-sph", &["sph-shell", "sph-core"]).len(), 1);
        assert_eq!(complaints("sph-shell", &["coque"]).len(), 1);
    }

    #[test]
    fn files_know_space_and_no_model() {
        for used in ["sph-shell", "shell-kinematics", "coque"] {
            let found = complaints("mesh-io", &[used]);
            assert_eq!(found.len(), 1);
            assert!(found[0].contains("sph-core alone"), "{found:?}");
        }
        assert_eq!(complaints("sph-shell", &["mesh-io"]).len(), 1);
    }

    #[test]
    fn only_the_judge_reads_the_truth() {
        for user in ["coque", "sph-shell", "sph-core"] {
            assert_eq!(complaints(user, &["benchmarks-ref"]).len(), 1, "{user}");
        }
        assert_eq!(complaints("validation", &["benchmarks-ref"]).len(), 0);
    }

    #[test]
    fn the_truth_shares_no_mechanics_with_what_it_judges() {
        for used in ["shell-kinematics", "sph-core", "sph-shell", "explicit-dynamics"] {
            let found = complaints("benchmarks-ref", &[used]);
            assert_eq!(found.len(), 1);
            assert!(found[0].contains("implicit-statics alone"), "{found:?}");
        }
    }

    #[test]
    fn a_crate_without_a_layer_is_named() {
        let found = complaints("new-crate", &[]);
        assert!(found[0].contains("new-crate has no layer"), "{found:?}");
    }

    #[test]
    fn every_kind_of_dependency_counts_and_foreign_ones_do_not() {
        let entry = json!({"name": "sph-shell", "dependencies": [
            {"name": "sph-core", "kind": null, "path": "x"},
            {"name": "coque", "kind": "dev", "path": "y"},
            {"name": "sph", "kind": "build", "path": "z"},
            {"name": "rayon", "kind": null},
        ]});
        let text =
            "[dependencies]\nsph-core.workspace = true\nrayon = \"1\"\n[dev-dependencies]\ncoque = {}\n";
        let package = package(&entry, "m".to_owned(), text).unwrap();
        let uses: Vec<_> = package.uses.iter().map(|(name, line)| (name.as_str(), *line)).collect();
        assert_eq!(uses, [("sph-core", 2), ("coque", 5), ("sph", 1)]);
    }
}
