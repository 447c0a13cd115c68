//! Conventions in the text of single files: opening line, length, blanks, leftovers, input and output, private paths.

use super::Violation;
use super::paths::{Used, paths};
use super::tree::SourceFile;

/// One idea fits on this many lines.
const LONGEST: usize = 400;

/// Crates that may read, write and print.
const MAY_DO_IO: &[&str] = &["mesh-io", "coque", "coque-mpi", "coque-python", "validation", "xtask"];

/// First folders of absolute paths that exist on one machine only.
const PRIVATE_FOLDERS: &[&str] = &["work", "home", "tmp"];

/// Every violation in one file.
pub fn check(file: &SourceFile) -> Vec<Violation> {
    let mut violations = private_paths(file);
    if [".rs", ".toml", ".md", ".bib", ".sh", ".template"].iter().any(|end| file.path.ends_with(end)) {
        violations.extend(blanks(file));
        violations.extend(leftovers(file));
    }
    if file.path.ends_with(".rs") {
        violations.extend(opening(file));
        violations.extend(length(file));
        violations.extend(input_and_output(file));
    }
    violations
}

fn opening(file: &SourceFile) -> Option<Violation> {
    let says = file.text.lines().next().and_then(|line| line.strip_prefix("//!"));
    let silent = says.is_none_or(|words| words.trim().is_empty());
    silent.then(|| {
        Violation::new(&file.path, 1, "the file does not say what it is for", "open it with one `//!` line")
    })
}

fn length(file: &SourceFile) -> Option<Violation> {
    let lines = file.text.lines().count();
    let exempt = format!("/{}", file.path).contains("/tests/");
    (lines > LONGEST && !exempt).then(|| {
        Violation::new(&file.path, lines, format!("{lines} lines, more than {LONGEST}"), "split it by ideas")
    })
}

fn blanks(file: &SourceFile) -> Vec<Violation> {
    let mut violations = Vec::new();
    for (number, line) in numbered(&file.text) {
        if line.contains('\t') {
            violations.push(Violation::new(&file.path, number, "a tab", "indent with spaces"));
        }
        if line.ends_with([' ', '\t', '\r']) {
            violations.push(Violation::new(
                &file.path,
                number,
                "a blank at the end of the line",
                "remove it",
            ));
        }
    }
    violations
}

/// Attributes and references that leave a reader alone.
fn leftovers(file: &SourceFile) -> Vec<Violation> {
    let mut violations = Vec::new();
    for (number, line) in numbered(&file.text) {
        if file.path.ends_with(".rs") && line.trim_start().starts_with("#[ignore") {
            let repair = "assert the present behaviour and say why it is wrong";
            violations.push(Violation::new(&file.path, number, "an ignored test", repair));
        }
        for word in ["issue", "study"].into_iter().filter(|word| is_numbered(line, word)) {
            let what = format!("\"{word}\" with a number, which no reader can look up");
            violations.push(Violation::new(&file.path, number, what, "say the reason itself"));
        }
    }
    violations
}

/// Whether a word is followed by a number.
fn is_numbered(line: &str, word: &str) -> bool {
    let line = line.to_lowercase();
    line.match_indices(word).any(|(start, _)| {
        let after = &line[start + word.len()..];
        let number = after.strip_prefix([' ', '#']).map(|rest| rest.trim_start_matches('#'));
        number.is_some_and(|rest| rest.starts_with(|c: char| c.is_ascii_digit()))
    })
}

/// Files and streams in crates that leave them to others.
fn input_and_output(file: &SourceFile) -> Vec<Violation> {
    let Some((package, inside)) = file.path.split_once('/') else { return Vec::new() };
    if MAY_DO_IO.contains(&package) || !inside.starts_with("src/") {
        return Vec::new();
    }
    let reaches = |used: &Used| {
        used.path.len() > 1 && used.path[0] == "std" && ["fs", "io"].contains(&used.path[1].as_str())
    };
    let complain = |used: Used| {
        let what = format!(
            "{package} uses {}, but only {} read, write and print",
            used.path.join("::"),
            MAY_DO_IO.join(", ")
        );
        Violation::new(&file.path, used.line, what, "return the value, or an error, and let coque print it")
    };
    paths(&file.text).into_iter().filter(reaches).map(complain).collect()
}

/// Absolute paths: a private folder right after a slash that nothing path-like precedes.
fn private_paths(file: &SourceFile) -> Vec<Violation> {
    let mut violations = Vec::new();
    for (number, line) in numbered(&file.text) {
        for folder in PRIVATE_FOLDERS.iter().map(|folder| format!("/{folder}/")) {
            let absolute = |(start, _)| {
                let before = line[..start].chars().next_back();
                before.is_none_or(|c| !(c.is_alphanumeric() || "._-~}*$)".contains(c)))
            };
            if line.match_indices(&folder).any(absolute) {
                let what = format!("a path below {folder}, which exists on one machine only");
                let repair = "name it relative to the repository, or use std::env::temp_dir";
                violations.push(Violation::new(&file.path, number, what, repair));
            }
        }
    }
    violations
}

fn numbered(text: &str) -> impl Iterator<Item = (usize, &str)> {
    text.split('\n').enumerate().map(|(index, line)| (index + 1, line))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The violations of a made-up file, as lines.
    fn complaints(path: &str, text: &str) -> Vec<String> {
        let file = SourceFile { path: path.to_owned(), text: text.to_owned() };
        check(&file).iter().map(ToString::to_string).collect()
    }

    fn complains(path: &str, text: &str, about: &str) {
        let found = complaints(path, text);
        assert_eq!(found.len(), 1, "{text:?}: {found:?}");
        assert!(found[0].contains(about), "{found:?}");
    }

    fn passes(path: &str, text: &str) {
        assert_eq!(complaints(path, text), [""; 0], "{text:?}");
    }

    const CORE: &str = "sph-core/src/kernel.rs";

    #[test]
    fn a_rust_file_says_what_it_is_for() {
        passes(CORE, "//! Kernels.\n");
        complains(CORE, "// Kernels.\n", "kernel.rs:1: the file does not say");
        complains(CORE, "//!\n", "does not say");
        complains(CORE, "", "does not say");
        passes("sph-core/notes.md", "# Kernels\n");
    }

    #[test]
    fn a_long_file_is_split() {
        let long = format!("//! Long.\n{}", "x();\n".repeat(LONGEST));
        complains(CORE, &long, "kernel.rs:401: 401 lines");
        passes("sph-core/tests/cloud.rs", &long);
        passes(CORE, long.trim_end_matches("x();\n"));
    }

    #[test]
    fn tabs_and_trailing_blanks() {
        complains("a.toml", "a = 1 \n", "a.toml:1: a blank at the end");
        complains("a.md", "one\n\ttwo\n", "a.md:2: a tab");
        complains("a.bib", "one\r\n", "a blank at the end");
        passes("a.json", "1 \n");
    }

    #[test]
    fn leftovers() {
        complains(CORE, "//! K.\n    #[ignore = \"slow\"]\n", "kernel.rs:2: an ignored test");
        for (word, number) in [("issue", "3"), ("Issue", "#12"), ("study", "1 §2.1")] {
            complains("notes.md", &format!("see {word} {number}\n"), "notes.md:1: ");
        }
        passes("notes.md", "an issue of three, the studies of 2004, study\n");
    }

    #[test]
    fn only_the_edge_reads_and_writes() {
        for code in ["use std::fs;", "std::io::stdout()", "use std::{fmt, io::{self, Read}};"] {
            assert!(!complaints(CORE, &format!("//! K.\n{code}\n")).is_empty(), "{code}");
            passes("coque/src/write.rs", &format!("//! W.\n{code}\n"));
            passes("sph-core/tests/cloud.rs", &format!("//! T.\n{code}\n"));
        }
        passes(CORE, "//! K.\nuse std::{fmt::{self, io}, iter};\nstd::iota();\n");
    }

    #[test]
    fn paths_of_one_machine() {
        for folder in PRIVATE_FOLDERS {
            complains("notes.md", &format!("see /{folder}/me/notes\n"), "notes.md:1: a path below");
            complains("a.json", &format!("\"/{folder}/x\""), "a path below");
            complains("a.svg", &format!("file:///{folder}/x"), "a path below");
            passes("notes.md", &format!("https://example.org/{folder}/ and ./{folder}/ and $X/{folder}/\n"));
        }
        passes("notes.md", "a framework/homework, /workshop\n");
    }
}
