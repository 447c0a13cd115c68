//! Citations: a key in square brackets, such as those of references.bib, in comments and Markdown.

use super::Violation;
use super::tree::SourceFile;
use std::collections::{BTreeMap, BTreeSet};

/// Where the entries stand.
const BIBLIOGRAPHY: &str = "references.bib";

/// What the check found.
#[derive(Debug, Default)]
pub struct Findings {
    /// Keys without an entry, entries given twice.
    pub violations: Vec<Violation>,
    /// Entries that nobody cites.
    pub warnings: Vec<String>,
}

/// Hold every citation against the bibliography, and the other way round.
pub fn check(files: &[SourceFile]) -> Findings {
    let mut findings = Findings::default();
    let mut entries = BTreeMap::new();
    for file in files.iter().filter(|file| file.path == BIBLIOGRAPHY) {
        for (number, key) in bib_keys(&file.text) {
            if entries.insert(key, number).is_some() {
                let what = format!("a second entry {key}");
                findings.violations.push(Violation::new(BIBLIOGRAPHY, number, what, "keep one of the two"));
            }
        }
    }
    let mut cited = BTreeSet::new();
    for file in files {
        for (number, key) in citations(file) {
            if !entries.contains_key(key.as_str()) {
                let what = format!("[{key}] has no entry in {BIBLIOGRAPHY}");
                let repair = "add the entry, or correct the key";
                findings.violations.push(Violation::new(&file.path, number, what, repair));
            }
            cited.insert(key);
        }
    }
    let silent = entries.iter().filter(|(key, _)| !cited.contains(**key));
    findings.warnings =
        silent.map(|(key, line)| format!("{BIBLIOGRAPHY}:{line}: nobody cites {key}")).collect();
    findings
}

/// The keys of a BibTeX file: what stands between `@kind{` and the comma.
fn bib_keys(text: &str) -> impl Iterator<Item = (usize, &str)> {
    text.lines().enumerate().filter_map(|(index, line)| {
        let (_, rest) = line.trim_start().strip_prefix('@')?.split_once('{')?;
        Some((index + 1, rest.split(',').next()?.trim()))
    })
}

/// The keys cited in the comments of a Rust file or anywhere in a Markdown file.
///
/// This crate is left out: it cites nothing, it only speaks of citations.
fn citations(file: &SourceFile) -> Vec<(usize, String)> {
    let whole = file.path.ends_with(".md");
    if !whole && !file.path.ends_with(".rs") || file.path.starts_with("xtask/") {
        return Vec::new();
    }
    let lines =
        file.text.lines().enumerate().filter(|(_, line)| whole || line.trim_start().starts_with("//"));
    lines.flat_map(|(index, line)| keys(line).into_iter().map(move |key| (index + 1, key))).collect()
}

/// The keys in one line. `\[simo1989\]` counts as `[simo1989]` does: the backslash only tells rustdoc that it is no
/// link. Several keys or a place may share a pair of brackets: `[simo1989, eq. 3; sze2004]`.
fn keys(line: &str) -> Vec<String> {
    let plain = line.replace('\\', "");
    let mut found = Vec::new();
    for inside in plain.split('[').skip(1).filter_map(|rest| rest.split_once(']')).map(|(inside, _)| inside) {
        let words = inside.split([',', ';']).filter_map(|part| part.split_whitespace().next());
        found.extend(words.filter(|word| is_key(word)).map(str::to_owned));
    }
    found
}

/// Lower-case letters, four digits, at most one more letter.
fn is_key(word: &str) -> bool {
    let name = word.trim_start_matches(|c: char| c.is_ascii_lowercase());
    let (year, suffix) = match name.split_at_checked(4) {
        Some(parts) => parts,
        None => return false,
    };
    name.len() < word.len()
        && year.bytes().all(|digit| digit.is_ascii_digit())
        && (suffix.is_empty() || (suffix.len() == 1 && suffix.bytes().all(|c| c.is_ascii_lowercase())))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(path: &str, text: &str) -> SourceFile {
        SourceFile { path: path.to_owned(), text: text.to_owned() }
    }

    const BIB: &str = "@article{simo1989,\n  title = {A},\n}\n@book{sze2004b,\n}\n";

    #[test]
    fn keys_and_what_only_looks_like_one() {
        assert_eq!(keys("after [simo1989] and \\[sze2004b\\]"), ["simo1989", "sze2004b"]);
        assert_eq!(keys("[simo1989, eq. 3; sze2004b]"), ["simo1989", "sze2004b"]);
        for no_key in [
            "[F/L²]",
            "[1989]",
            "[simo]",
            "[simo198]",
            "[Simo1989]",
            "[simo1989xy]",
            "[a[i]]",
            "simo1989]",
            "[simo1989",
        ] {
            assert_eq!(keys(no_key), [""; 0], "{no_key}");
        }
    }

    #[test]
    fn a_key_without_an_entry_is_a_violation() {
        let findings = check(&[
            file(BIBLIOGRAPHY, BIB),
            file("a/src/lib.rs", "//! After [simo1989].\nlet x = y[nobody1999];\n/// See [nobody1999].\n"),
            file("README.md", "After [sze2004b] and [noone2001].\n"),
        ]);
        let found: Vec<String> = findings.violations.iter().map(ToString::to_string).collect();
        assert_eq!(found.len(), 2, "{found:?}");
        assert!(found[0].starts_with("a/src/lib.rs:3: [nobody1999] has no entry"), "{found:?}");
        assert!(found[1].starts_with("README.md:1: [noone2001] has no entry"), "{found:?}");
        assert_eq!(findings.warnings, [""; 0]);
    }

    #[test]
    fn an_entry_that_nobody_cites_is_a_warning() {
        let findings = check(&[file(BIBLIOGRAPHY, BIB), file("a.rs", "// [simo1989]\n")]);
        assert!(findings.violations.is_empty());
        assert_eq!(findings.warnings, ["references.bib:4: nobody cites sze2004b"]);
    }

    #[test]
    fn this_crate_may_speak_of_keys() {
        assert!(citations(&file("xtask/src/a.rs", "// [nobody1999]")).is_empty());
        assert_eq!(citations(&file("sph-core/src/a.rs", "// [nobody1999]")).len(), 1);
    }

    #[test]
    fn an_entry_given_twice_is_a_violation() {
        let findings =
            check(&[file(BIBLIOGRAPHY, "@book{a2000,\n}\n@misc{ a2000,\n}\n"), file("a.md", "[a2000]")]);
        assert_eq!(findings.violations.len(), 1);
        assert_eq!(findings.violations[0].line, 3);
    }

    #[test]
    fn without_a_bibliography_every_citation_is_a_violation() {
        assert_eq!(check(&[file("a.md", "[simo1989]")]).violations.len(), 1);
    }
}
