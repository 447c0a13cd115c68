//! Words that mean something to those who wrote the project and nothing to the field: each with the term to use.

use super::Violation;
use super::tree::SourceFile;

/// What is not written, as a whole word in any case, and what is.
const PRIVATE: &[(&str, &str)] = &[
    ("told", "prescribed, reported, measured, or warned of"),
    ("doubt", "warning, or kind of warning"),
    ("doubts", "warnings"),
    ("freedoms", "degrees of freedom, or dof"),
    ("booked", "counted, or recorded"),
    ("dial", "formulation"),
    ("unsound", "invalid"),
    ("felt", "acts"),
    ("nought", "zero"),
    ("restless", "unsettled"),
    ("thrift", "cost"),
    ("senseless", "without meaning"),
    ("hasten", "deflate, or accelerate"),
];

/// The list itself, and the page that says what was renamed.
const EXEMPT: &[&str] = &["xtask/src/tidy/words.rs", "CHANGELOG.md"];

/// Every private word of a file of code or prose.
pub fn check(file: &SourceFile) -> Vec<Violation> {
    if ![".rs", ".md"].iter().any(|end| file.path.ends_with(end)) || EXEMPT.contains(&file.path.as_str()) {
        return Vec::new();
    }
    let lines = (1..).zip(file.text.lines());
    lines.flat_map(|(number, line)| found(line).map(move |of| violation(&file.path, number, of))).collect()
}

fn found(line: &str) -> impl Iterator<Item = &'static (&'static str, &'static str)> {
    // A Markdown table and `snake_case` names hold words as well.
    let words = line.split(|c: char| !c.is_alphabetic());
    words.filter_map(|word| PRIVATE.iter().find(|(private, _)| word.eq_ignore_ascii_case(private)))
}

fn violation(file: &str, line: usize, (word, instead): &(&str, &str)) -> Violation {
    Violation::new(file, line, format!("the private word \"{word}\""), format!("write {instead}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_words_in_any_case_and_in_names() {
        let text =
            "//! Told twice.\nfn is_told() {} // mandoubtful, of the dial_gauge\nall untold, doubtful\n";
        let file = |path: &str| SourceFile { path: path.into(), text: text.into() };
        let found: Vec<_> = check(&file("a/src/b.rs")).into_iter().map(|v| (v.line, v.what)).collect();
        let what = |word: &str| format!("the private word \"{word}\"");
        assert_eq!(found, [(1, what("told")), (2, what("told")), (2, what("dial"))]);
        assert_eq!(check(&file("a/data.txt")), []);
    }
}
