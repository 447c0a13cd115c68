//! Circles of modules: in every folder of a crate the modules, each with all below it, use each other without a circle.
//!
//! An arrow is a `use` line, or a path in the code, that leads to a module of the same crate. A name that a module only passes
//! on is followed to the module that defines it. What a folder's own file says (lib.rs, mod.rs, x.rs beside x/) counts for the
//! folder: a module and those below it are one idea and may use each other. Comments and tests do not count.

use super::Violation;
use super::paths::{Path, Used, paths};
use super::tree::SourceFile;
use std::collections::{BTreeMap, BTreeSet};

/// Where a path stands: file, line, words.
type Place = (String, usize, String);

#[derive(Default)]
struct Module {
    /// What `use` lines bring in: the name here, and the path to it.
    names: BTreeMap<String, Path>,
    /// Paths in use, those only passed on left out.
    used: Vec<(Path, Place)>,
}

impl Module {
    fn read(&mut self, file: &SourceFile) {
        for Used { path, name, passed_on, line } in paths(&file.text) {
            if !passed_on {
                self.used.push((path.clone(), (file.path.clone(), line, path.join("::"))));
            }
            self.names.extend(name.map(|name| (name, path)));
        }
    }
}

/// Every circle in every crate.
pub fn check(files: &[SourceFile]) -> Vec<Violation> {
    let mut crates: BTreeMap<&str, BTreeMap<Path, Module>> = BTreeMap::new();
    for file in files {
        let Some((package, inside)) = file.path.split_once("/src/") else { continue };
        let Some(inside) = inside.strip_suffix(".rs").filter(|_| !package.contains('/')) else { continue };
        let path: Path = match inside.strip_suffix("/mod").unwrap_or(inside) {
            "lib" | "main" => Path::new(),
            names => names.split('/').map(str::to_owned).collect(),
        };
        crates.entry(package).or_default().entry(path).or_default().read(file);
    }
    crates.iter().flat_map(|(package, modules)| circles(package, modules)).collect()
}

/// The module that a path leads to from another; none if it leaves the crate.
fn resolve(modules: &BTreeMap<Path, Module>, from: &Path, path: &[String], depth: usize) -> Option<Path> {
    let mut at = from.clone();
    let mut rest = path.iter();
    match path.first()?.as_str() {
        "crate" => (at, _) = (Path::new(), rest.next()),
        "self" => drop(rest.next()),
        "super" => {
            while rest.as_slice().first().is_some_and(|word| word == "super") {
                at.pop();
                rest.next();
            }
        }
        child => {
            at.push(child.to_owned());
            rest.next();
            modules.get(&at)?;
        }
    }
    for word in rest {
        at.push(word.clone());
        if modules.contains_key(&at) {
            continue;
        }
        at.pop();
        let passed_on = modules.get(&at).and_then(|module| module.names.get(word)).filter(|_| depth < 8);
        return Some(passed_on.and_then(|path| resolve(modules, &at, path, depth + 1)).unwrap_or(at));
    }
    Some(at)
}

/// The circles of one crate, folder by folder.
fn circles(package: &str, modules: &BTreeMap<Path, Module>) -> Vec<Violation> {
    let mut folders: BTreeMap<Path, BTreeMap<(String, String), Place>> = BTreeMap::new();
    for (from, module) in modules {
        for (path, place) in &module.used {
            let Some(to) = resolve(modules, from, path, 0) else { continue };
            let shared = from.iter().zip(&to).take_while(|(a, b)| a == b).count();
            // Of a module and one below it neither leaves the other.
            if let (Some(a), Some(b)) = (from.get(shared), to.get(shared)) {
                let arrows = folders.entry(from[..shared].to_vec()).or_default();
                arrows.entry((a.clone(), b.clone())).or_insert_with(|| place.clone());
            }
        }
    }
    let mut violations = Vec::new();
    for (folder, arrows) in &folders {
        let mut done = BTreeSet::new();
        for (start, _) in arrows.keys() {
            let circle: BTreeSet<&str> = reached(arrows, start)
                .into_iter()
                .filter(|to| reached(arrows, to).contains(start.as_str()))
                .collect();
            if circle.is_empty() || !done.insert(circle.clone()) {
                continue;
            }
            let own: Vec<_> = arrows
                .iter()
                .filter(|((a, b), _)| circle.contains(a.as_str()) && circle.contains(b.as_str()))
                .collect();
            let reported: Vec<String> = own
                .iter()
                .map(|((a, b), (file, line, words))| format!("{a} → {b} ({file}:{line} {words})"))
                .collect();
            let (file, line, _) = own[0].1;
            let place = [&[format!("{package}/src")], &folder[..]].concat().join("/");
            let what = format!("a circle of modules in {place}: {}", reported.join(", "));
            let repair = "move what two of them share into a module below both";
            violations.push(Violation::new(file, *line, what, repair));
        }
    }
    violations
}

/// The modules to which arrows lead from one, over others too.
fn reached<'a>(arrows: &'a BTreeMap<(String, String), Place>, start: &str) -> BTreeSet<&'a str> {
    let mut reached = BTreeSet::new();
    let mut front = vec![start];
    while let Some(from) = front.pop() {
        for (_, to) in arrows.keys().filter(|(a, _)| a == from) {
            if reached.insert(to.as_str()) {
                front.push(to);
            }
        }
    }
    reached
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(files: &[(&str, &str)]) -> Vec<String> {
        let file = |&(path, text): &(&str, &str)| SourceFile {
            path: format!("a/src/{path}"),
            text: text.to_owned(),
        };
        check(&files.iter().map(file).collect::<Vec<_>>()).iter().map(ToString::to_string).collect()
    }

    #[test]
    fn a_circle_is_reported_with_a_line_for_each_arrow() {
        let circle = found(&[
            ("one.rs", "//! One.\nuse std::fmt;\nuse crate::two::Two;\n"),
            ("two.rs", "fn f() { crate::deep::g() }\n"),
            ("deep/mod.rs", "mod low;\n"),
            ("deep/low.rs", "use crate::{\n    one::{self, One},\n};\n"),
        ]);
        assert_eq!(circle.len(), 1, "{circle:?}");
        let reported = "a circle of modules in a/src: deep → one (a/src/deep/low.rs:1 crate::one), \
                    one → two (a/src/one.rs:3 crate::two::Two), two → deep (a/src/two.rs:1 crate::deep::g)";
        assert!(circle[0].contains(reported), "{circle:?}");
    }

    #[test]
    fn names_that_are_passed_on_are_followed() {
        let root = (
            "lib.rs",
            "mod one;\nmod two;\npub use one::{One as Uno, Other};\npub(crate) use self::two::Two;\n",
        );
        let two = ("two.rs", "use crate::Uno;\n");
        assert_eq!(found(&[root, ("one.rs", "use crate::Two;\n"), two]).len(), 1);
        assert_eq!(found(&[root, ("one.rs", "use crate::Own;\n"), two]), [""; 0]);
    }

    #[test]
    fn a_parent_and_its_children_may_use_each_other_and_its_children_may_not() {
        let parent = ("one/mod.rs", "mod low;\nmod high;\nuse low::Low;\npub use high::High;\n");
        let low = ("one/low.rs", "use super::One;\n");
        assert_eq!(found(&[parent, low, ("one/high.rs", "use super::{One, low::Low};\n")]), [""; 0]);
        let circle =
            found(&[parent, ("one/low.rs", "use super::High;\n"), ("one/high.rs", "use super::low::Low;\n")]);
        assert!(circle[0].contains("in a/src/one: high → low"), "{circle:?}");
    }

    #[test]
    fn comments_and_tests_do_not_count() {
        let two = ("two.rs", "use crate::one::One;\n");
        let one = "//! See [`crate::two`].\nfn f() {} // crate::two\n#[cfg(test)]\nmod tests {\n    use crate::two::Two;\n}\n";
        assert_eq!(found(&[("one.rs", one), two]), [""; 0]);
    }
}
