//! Links of Markdown pages as paths: what docs/SUMMARY.md lists and where a link leads.

/// Pages that the summary lists, relative to the root of the repository.
pub fn listed(summary: &str) -> Vec<String> {
    targets(summary).map(below_docs).collect()
}

/// Targets of the links of a page, in their order.
pub fn targets(text: &str) -> impl Iterator<Item = &str> {
    text.match_indices("](").filter_map(|(at, _)| text[at + 2..].split(')').next())
}

/// A path from the root, of what a page of docs calls `target`.
pub fn below_docs(target: &str) -> String {
    joined("docs/SUMMARY.md", target)
}

/// A path from the root, of what a page at `from` calls `target`.
pub fn joined(from: &str, target: &str) -> String {
    let mut parts: Vec<&str> = from.split('/').collect();
    parts.pop();
    for part in target.split('/') {
        match part {
            ".." => drop(parts.pop()),
            "." | "" => {}
            part => parts.push(part),
        }
    }
    parts.join("/")
}
