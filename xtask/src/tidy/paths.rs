//! The paths that a Rust file names: in its `use` lines, and in its code those that say where they begin.
//!
//! Read line by line, as rustfmt lays them out; comments and what follows the first `#[cfg(test)]` are left out.

/// Names from the root of a crate down, or from a word such as `super`.
pub type Path = Vec<String>;

/// A path in use.
pub struct Used {
    /// Its names.
    pub path: Path,
    /// The name that a `use` line gives it; none of a path in the code.
    pub name: Option<String>,
    /// Whether it is only passed on, as `pub use` does.
    pub passed_on: bool,
    /// Counted from 1.
    pub line: usize,
}

/// Words with which a path in the code says where it begins.
const ROOTS: [&str; 4] = ["crate", "super", "self", "std"];

/// Every path in a file.
pub fn paths(text: &str) -> Vec<Used> {
    let mut found = Vec::new();
    let mut lines = text.lines().take_while(|line| *line != "#[cfg(test)]").map(without_comment).enumerate();
    while let Some((index, first)) = lines.next() {
        let line = index + 1;
        let Some((passed_on, words)) = use_line(first) else {
            found.extend(inline(first).map(|path| Used { path, name: None, passed_on: false, line }));
            continue;
        };
        let mut tree = words.to_owned();
        while !tree.contains(';') {
            let Some((_, more)) = lines.next() else { break };
            tree.push_str(more);
        }
        let expanded = expand(tree.split(';').next().unwrap_or_default());
        found.extend(expanded.into_iter().map(|(path, name)| Used {
            path,
            name: Some(name),
            passed_on,
            line,
        }));
    }
    found
}

fn without_comment(line: &str) -> &str {
    let line = line.trim();
    if line.starts_with("//") { "" } else { line.split(" // ").next().unwrap_or_default() }
}

/// Whether a `use` line passes its names on, and what follows the word.
fn use_line(line: &str) -> Option<(bool, &str)> {
    if let Some(words) = line.strip_prefix("use ") {
        return Some((false, words));
    }
    let (visibility, words) = line.split_once("use ")?;
    let visible = visibility == "pub " || visibility.starts_with("pub(") && visibility.ends_with(") ");
    visible.then_some((true, words))
}

/// The paths of a `use` tree, each with the name that it is given.
fn expand(tree: &str) -> Vec<(Path, String)> {
    let names = |text: &str| -> Path {
        text.split("::").map(str::trim).filter(|name| !name.is_empty()).map(str::to_owned).collect()
    };
    let last = |path: &Path| path.last().cloned().unwrap_or_default();
    let Some((head, rest)) = tree.split_once('{') else {
        let (path, given) = tree.split_once(" as ").map_or((tree, None), |(path, given)| (path, Some(given)));
        let path = names(path);
        let name = given.map_or_else(|| last(&path), |given| given.trim().to_owned());
        return vec![(path, name)];
    };
    let (head, mut depth) = (names(head), 0_i32);
    let inside = &rest[..rest.rfind('}').unwrap_or(rest.len())];
    let items = inside.split(|c| {
        depth += i32::from(c == '{') - i32::from(c == '}');
        c == ',' && depth == 0
    });
    let mut paths = Vec::new();
    for (tail, name) in items.filter(|item| !item.trim().is_empty()).flat_map(expand) {
        let itself = tail == ["self"];
        let name = if itself { last(&head) } else { name };
        paths.push((head.iter().cloned().chain(tail.into_iter().filter(|_| !itself)).collect(), name));
    }
    paths
}

/// The paths in a line of code that begin with one of [`ROOTS`].
fn inline(line: &str) -> impl Iterator<Item = Path> {
    let of_path = |c: char| c.is_alphanumeric() || c == '_' || c == ':';
    line.split(move |c| !of_path(c)).filter_map(|text| {
        let path: Path = text.trim_matches(':').split("::").map(str::to_owned).collect();
        (path.len() > 1 && ROOTS.contains(&path[0].as_str())).then_some(path)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn reported(text: &str) -> Vec<String> {
        let words = |used: &Used| {
            let name = used.name.as_ref().map(|name| format!(" as {name}")).unwrap_or_default();
            let passed_on = if used.passed_on { "pub " } else { "" };
            format!("{}: {passed_on}{}{name}", used.line, used.path.join("::"))
        };
        paths(text).iter().map(words).collect()
    }

    #[test]
    fn trees_are_taken_apart() {
        let text = "use std::{\n    fmt, io::{self, Read as R},\n};\npub(crate) use low::Low;\n";
        let names =
            ["1: std::fmt as fmt", "1: std::io as io", "1: std::io::Read as R", "4: pub low::Low as Low"];
        assert_eq!(reported(text), names);
    }

    #[test]
    fn paths_in_the_code_say_where_they_begin() {
        assert_eq!(
            reported("fn f() -> crate::A { super::b(std::iota(), c::d) }"),
            ["1: crate::A", "1: super::b", "1: std::iota"]
        );
    }

    #[test]
    fn comments_and_tests_are_left_out() {
        let text = "//! crate::a\nf(); // crate::b\n#[cfg(test)]\nmod tests {\n    use crate::c;\n}\n";
        assert_eq!(reported(text), [""; 0]);
    }
}
