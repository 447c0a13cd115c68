//! Links of Markdown pages: each leads to a file of the checkout, and to a heading of it where it names one.

use super::Violation;
use super::tree::SourceFile;
use crate::pages::{joined, listed};
use std::collections::BTreeMap;
use std::path::Path;

/// Holds every link between files against what is there; addresses elsewhere are not visited.
pub fn check(files: &[SourceFile], root: &Path) -> Vec<Violation> {
    let headings: BTreeMap<&str, Vec<String>> =
        pages(files).map(|file| (file.path.as_str(), slugs(&file.text))).collect();
    let mut violations = Vec::new();
    for file in pages(files) {
        for (number, target) in links(&file.text) {
            let (path, heading) = target.split_once('#').unwrap_or((target, ""));
            let path = if path.is_empty() { file.path.clone() } else { joined(&file.path, path) };
            if !(headings.contains_key(path.as_str()) || root.join(&path).exists()) {
                let what = format!("a link to {target}, which is not there");
                violations.push(Violation::new(&file.path, number, what, "correct the link"));
                continue;
            }
            let known =
                headings.get(path.as_str()).is_none_or(|known| known.iter().any(|slug| slug == heading));
            if !(heading.is_empty() || known) {
                let what = format!("a link to #{heading}, which {path} has not");
                violations.push(Violation::new(&file.path, number, what, "correct the heading's name"));
            }
        }
    }
    violations.extend(unlisted(files));
    violations
}

/// Pages of docs that no reader of the site finds.
fn unlisted(files: &[SourceFile]) -> Vec<Violation> {
    let Some(summary) = files.iter().find(|file| file.path == "docs/SUMMARY.md") else { return Vec::new() };
    let listed = listed(&summary.text);
    let of_docs = pages(files).filter(|file| file.path.starts_with("docs/") && file.path != summary.path);
    let missing = of_docs.filter(|file| !listed.contains(&file.path));
    let violation = |file: &SourceFile| {
        Violation::new(&file.path, 1, "docs/SUMMARY.md does not list it", "add a line there")
    };
    missing.map(violation).collect()
}

fn pages(files: &[SourceFile]) -> impl Iterator<Item = &SourceFile> {
    files.iter().filter(|file| file.path.ends_with(".md"))
}

/// Targets of links with the numbers of their lines, outside of blocks and of code.
fn links(text: &str) -> Vec<(usize, &str)> {
    let mut found = Vec::new();
    let mut inside = false;
    for (number, line) in (1..).zip(text.lines()) {
        if line.trim_start().starts_with("```") {
            inside = !inside;
        }
        if inside {
            continue;
        }
        for (at, _) in line.match_indices("](") {
            let open = line[..at].matches('`').count() % 2 == 1;
            let target = line[at + 2..].split(')').next().unwrap_or_default();
            let elsewhere = target.contains("://") || target.starts_with("mailto:");
            if !(open || elsewhere || target.is_empty() || target.contains(' ')) {
                found.push((number, target));
            }
        }
    }
    found
}

/// Names by which links know the headings of a page: small letters, blanks as hyphens, no other marks.
fn slugs(text: &str) -> Vec<String> {
    let heading = |line: &str| line.starts_with('#').then(|| slug(line.trim_start_matches('#').trim()));
    text.lines().filter_map(heading).collect()
}

fn slug(heading: &str) -> String {
    let kept = |c: char| match c {
        ' ' => Some('-'),
        '-' | '_' => Some(c),
        c if c.is_alphanumeric() => Some(c),
        _ => None,
    };
    heading.chars().filter_map(kept).flat_map(char::to_lowercase).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_that_lead_nowhere_are_found() {
        let page = |path: &str, text: &str| SourceFile { path: path.into(), text: text.into() };
        let text = "# A page\n[up](../Cargo.toml) [here](#a-page) [gone](nowhere.md)\n`[no](link.md)`\n\
                    [off](tidy.md#no-such) [web](https://example.org/x)\n```\n[in](a-block.md)\n```\n";
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        let found = check(&[page("src/page.md", text), page("src/tidy.md", "# Tidy …\n")], root);
        let reported: Vec<_> = found.iter().map(|v| (v.line, v.what.as_str())).collect();
        let nowhere = "a link to nowhere.md, which is not there";
        assert_eq!(reported, [(2, nowhere), (4, "a link to #no-such, which src/tidy.md has not")]);
        assert_eq!(slug("To add …"), "to-add-");
        let site = [page("docs/SUMMARY.md", "[a](a.md)"), page("docs/a.md", ""), page("docs/b.md", "")];
        let missing = unlisted(&site);
        assert_eq!(missing.iter().map(|v| v.file.as_str()).collect::<Vec<_>>(), ["docs/b.md"]);
    }
}
