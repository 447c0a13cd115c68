//! Conventions in the text of single files: opening line, length, blanks, leftovers, input and output, paths.

use super::Violation;
use super::mask::{code_only, without_tests};
use super::tree::SourceFile;

/// One idea fits on this many lines.
const LONGEST: usize = 400;

/// Files that may be longer, each with its reason; tables of numbers are good ones.
const MAY_BE_LONGER: &[(&str, &str)] = &[];

/// Crates that may read, write and print.
const MAY_DO_IO: &[&str] = &["mesh-io", "coque", "validation", "xtask"];

/// First folders of absolute paths that exist on one machine only.
const PRIVATE_FOLDERS: &[&str] = &["work", "home", "tmp"];

/// Every violation in one file.
pub fn check(file: &SourceFile) -> Vec<Violation> {
    let mut violations = private_paths(file);
    if [".rs", ".toml", ".md", ".bib", ".sh", ".template"].iter().any(|end| file.path.ends_with(end)) {
        violations.extend(blanks(file));
    }
    if file.path.ends_with(".rs") {
        let code = code_only(&file.text);
        violations.extend(opening(file));
        violations.extend(length(file, MAY_BE_LONGER));
        violations.extend(leftovers(file, &code));
        violations.extend(input_and_output(file, &without_tests(&code)));
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

fn length(file: &SourceFile, may_be_longer: &[(&str, &str)]) -> Option<Violation> {
    let lines = file.text.lines().count();
    let exempt = format!("/{}", file.path).contains("/tests/")
        || may_be_longer.iter().any(|(path, _)| *path == file.path);
    (lines > LONGEST && !exempt).then(|| {
        Violation::new(
            &file.path,
            lines,
            format!("{lines} lines, more than {LONGEST}"),
            "split it by ideas, or list it with its reason in xtask/src/tidy/sources.rs",
        )
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

/// `code` is the file without comments and literals: a rule may be spoken of, not broken.
fn leftovers(file: &SourceFile, code: &str) -> Vec<Violation> {
    let rules = [
        ("todo!", "write the code, or return an error that says what is missing"),
        ("unimplemented!", "write the code, or return an error that says what is missing"),
        ("dbg!", "remove it"),
        ("#[ignore", "assert the present behaviour and say why it is wrong"),
    ];
    let mut violations = Vec::new();
    for (number, line) in numbered(code) {
        for (pattern, repair) in rules.iter().filter(|(pattern, _)| contains_word(line, pattern)) {
            violations.push(Violation::new(&file.path, number, format!("a left-over `{pattern}`"), *repair));
        }
    }
    violations
}

/// `code` is the file without comments, literals and tests.
fn input_and_output(file: &SourceFile, code: &str) -> Vec<Violation> {
    let Some((package, inside)) = file.path.split_once('/') else { return Vec::new() };
    if MAY_DO_IO.contains(&package) || !inside.starts_with("src/") {
        return Vec::new();
    }
    let mut violations = Vec::new();
    let mut complain = |number: usize, what: &str| {
        violations.push(Violation::new(
            &file.path,
            number,
            format!(
                "{package} uses {what}, but only mesh-io, coque, validation and xtask read, write and print"
            ),
            "return the value, or an error, and let coque print it",
        ));
    };
    for (number, line) in numbered(code) {
        for pattern in ["std::fs", "std::io", "print!", "println!", "eprint!", "eprintln!"] {
            if contains_word(line, pattern) {
                complain(number, pattern);
            }
        }
    }
    for (place, _) in code.match_indices("std::{") {
        let number = code[..place].matches('\n').count() + 1;
        for module in ["fs", "io"] {
            if group(&code[place + "std::{".len()..]).any(|item| first_name(item) == module) {
                complain(number, &format!("std::{module}"));
            }
        }
    }
    violations
}

/// The items of a `use` group whose opening brace has just been passed.
fn group(code: &str) -> impl Iterator<Item = &str> {
    let mut depth = 1_i32;
    let end = code.find(|c| {
        depth += i32::from(c == '{') - i32::from(c == '}');
        depth == 0
    });
    let mut inner = 0_i32;
    code[..end.unwrap_or(code.len())].split(move |c| {
        inner += i32::from(c == '{') - i32::from(c == '}');
        c == ',' && inner == 0
    })
}

fn first_name(item: &str) -> &str {
    item.trim().split(|c: char| !(c.is_alphanumeric() || c == '_')).next().unwrap_or_default()
}

/// Whether `pattern` occurs with no name character before or after it.
fn contains_word(line: &str, pattern: &str) -> bool {
    let is_name = |c: char| c.is_alphanumeric() || c == '_';
    line.match_indices(pattern).any(|(start, _)| {
        let before = line[..start].chars().next_back();
        let after = line[start + pattern.len()..].chars().next();
        // a pattern such as #[ or print! begins or ends with no name character itself
        let longer_before = before.is_some_and(is_name) && pattern.starts_with(is_name);
        let longer_after = after.is_some_and(is_name) && pattern.ends_with(is_name);
        !longer_before && !longer_after
    })
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
    fn a_long_file_is_split_or_listed() {
        let long = format!("//! Long.\n{}", "x();\n".repeat(LONGEST));
        complains(CORE, &long, "kernel.rs:401: 401 lines");
        passes("sph-core/tests/cloud.rs", &long);
        passes(CORE, long.trim_end_matches("x();\n"));
        let file = SourceFile { path: CORE.to_owned(), text: long };
        assert!(length(&file, &[(CORE, "a table")]).is_none());
        assert!(length(&file, &[("other.rs", "a table")]).is_some());
    }

    #[test]
    fn tabs_and_trailing_blanks() {
        complains("a.toml", "a = 1 \n", "a.toml:1: a blank at the end");
        complains("a.md", "one\n\ttwo\n", "a.md:2: a tab");
        complains("a.bib", "one\r\n", "a blank at the end");
        passes("a.json", "1 \n");
    }

    #[test]
    fn leftovers_in_code_but_not_in_words() {
        for leftover in ["todo!()", "unimplemented!()", "dbg!(x)", "#[ignore]", "#[ignore = \"slow\"]"] {
            complains(CORE, &format!("//! K.\n{leftover}\n"), "kernel.rs:2: a left-over");
        }
        passes(CORE, "//! K.\n// a dbg! here\nlet x = \"todo!\";\nmy_dbg!(x);\n");
    }

    #[test]
    fn only_the_edge_reads_and_prints() {
        for code in ["use std::fs;", "std::io::stdout()", "println!(\"x\")", "eprint!(\"x\")"] {
            complains(CORE, &format!("//! K.\n{code}\n"), "kernel.rs:2: sph-core uses");
            passes("coque/src/write.rs", &format!("//! W.\n{code}\n"));
            passes("sph-core/tests/cloud.rs", &format!("//! T.\n{code}\n"));
            passes("sph-core/examples/cloud.rs", &format!("//! E.\n{code}\n"));
        }
        complains(CORE, "//! K.\nuse std::{\n    fmt, io::{self, Read},\n};\n", "std::io");
        passes(CORE, "//! K.\nuse std::{fmt::{self, io}, iter};\nstd::iota();\n");
        passes(CORE, "//! K.\n#[cfg(test)]\nmod tests {\n    fn f() { println!(\"x\"); }\n}\n");
        complains(CORE, "//! K.\n#[cfg(test)]\nmod tests {}\nfn f() { print!(\"x\") }\n", "kernel.rs:4");
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
