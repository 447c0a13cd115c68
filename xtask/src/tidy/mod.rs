//! `cargo xtask tidy`: rules that the compiler cannot check, one line for each violation and how to repair it.

mod circles;
mod citations;
mod layers;
mod links;
mod paths;
mod sources;
mod tree;
mod words;

use crate::cargo;
use std::fmt;

/// A rule broken at one place.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
struct Violation {
    /// Relative to the root.
    file: String,
    /// Counted from 1.
    line: usize,
    /// What is wrong.
    what: String,
    /// How to repair it.
    repair: String,
}

impl Violation {
    fn new(file: &str, line: usize, what: impl Into<String>, repair: impl Into<String>) -> Self {
        Self { file: file.to_owned(), line, what: what.into(), repair: repair.into() }
    }
}

impl fmt::Display for Violation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}: {}; {}", self.file, self.line, self.what, self.repair)
    }
}

/// Check the whole workspace; warnings are printed, violations are an error.
pub fn run() -> Result<(), String> {
    let root = cargo::root();
    let files = tree::read(&root)?;
    let packages = layers::packages(&cargo::metadata()?, &root)?;
    let citations = citations::check(&files);

    let mut violations = layers::check(&packages);
    violations.extend(files.iter().flat_map(sources::check));
    violations.extend(files.iter().flat_map(words::check));
    violations.extend(circles::check(&files));
    violations.extend(citations.violations);
    violations.extend(links::check(&files, &root));
    violations.sort();

    for warning in &citations.warnings {
        println!("warning: {warning}");
    }
    for violation in &violations {
        println!("{violation}");
    }
    println!("tidy: {} files, {} packages, {} violations", files.len(), packages.len(), violations.len());
    match violations.len() {
        0 => Ok(()),
        count => Err(format!("tidy found {count} violations; each line above says how to repair one")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_violation_is_one_line_that_editors_can_follow() {
        let violation = Violation::new("a/b.rs", 7, "a tab", "use spaces");
        assert_eq!(violation.to_string(), "a/b.rs:7: a tab; use spaces");
    }
}
