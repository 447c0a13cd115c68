//! `cargo xtask book`: the Markdown pages of the repository as one site, with the pictures of the gallery where it was made.

use crate::cargo;
use crate::pages::{below_docs, joined, listed, targets};
use std::fs;
use std::path::Path;
use std::process::Command;

/// Where files of the repository are read that are no page of the site.
const REPOSITORY: &str = "https://github.com/coque-shell/coque/blob/main/";

/// The list of pages, in the order of the site.
const SUMMARY: &str = "docs/SUMMARY.md";

/// Pages and pictures are copied below target/book and `mdbook` makes the site of them.
pub fn run() -> Result<(), String> {
    if !cargo::has_program("mdbook") {
        return Err("mdbook is not on the PATH; install it with: cargo install mdbook".into());
    }
    let root = cargo::root();
    let book = root.join("target/book");
    let _ = fs::remove_dir_all(&book);
    let text = |path: &Path| {
        fs::read_to_string(path).map_err(|error| format!("cannot read {}: {error}", path.display()))
    };
    let mut summary = text(&root.join(SUMMARY))?;
    let pages = listed(&summary);
    for page in &pages {
        keep(&book.join("src").join(of_the_site(page)), &moved(&text(&root.join(page))?, page, &pages))?;
    }
    for folder in ["docs/guide", "docs/pictures"] {
        pictures(&root.join(folder), &book.join("src").join(folder))?;
    }
    if let Some(page) = gallery(&root.join("target/gallery"), &book.join("src/gallery"))? {
        keep(&book.join("src/gallery.md"), &page)?;
        summary = summary.replacen("# Tutorials", "[Gallery](../gallery.md)\n\n# Tutorials", 1);
    } else {
        println!("without a gallery: `cargo xtask gallery` makes its pictures");
    }
    keep(&book.join("src/SUMMARY.md"), &from_the_root(&summary))?;
    keep(&book.join("book.toml"), &text(&root.join("docs/book.toml"))?)?;
    let status = Command::new("mdbook").arg("build").arg(&book).status();
    if !status.map_err(|error| format!("cannot start mdbook: {error}"))?.success() {
        return Err("mdbook failed; its message stands above".into());
    }
    println!("book: {}", book.join("html/index.html").display());
    Ok(())
}

/// What a page is called on the site: the first of a folder is its index.
fn of_the_site(page: &str) -> String {
    page.replace("README.md", "index.md")
}

/// The summary with paths from the root, as the site has them.
fn from_the_root(summary: &str) -> String {
    let mut out = summary.to_owned();
    for target in targets(summary) {
        out = out.replace(&format!("]({target})"), &format!("]({})", of_the_site(&below_docs(target))));
    }
    out
}

/// A page whose links to files that the site does not have lead to the repository.
fn moved(text: &str, page: &str, pages: &[String]) -> String {
    let mut out = text.to_owned();
    for target in targets(text) {
        let (path, _) = target.split_once('#').unwrap_or((target, ""));
        let at = joined(page, path);
        let elsewhere = target.contains("://") || path.is_empty() || target.contains(' ');
        let drawn = [".svg", ".png"].iter().any(|end| path.ends_with(end));
        let there = match pages.contains(&at) {
            true => of_the_site(target),
            false => format!("{REPOSITORY}{at}"),
        };
        if !(elsewhere || drawn) {
            out = out.replace(&format!("]({target})"), &format!("]({there})"));
        }
    }
    out
}

/// The page of the gallery with its pictures copied, if the gallery was made.
fn gallery(from: &Path, to: &Path) -> Result<Option<String>, String> {
    let Ok(entries) = fs::read_dir(from) else { return Ok(None) };
    let mut names: Vec<String> =
        entries.filter_map(|entry| entry.ok()?.file_name().into_string().ok()).collect();
    names.retain(|name| from.join(name).join("shape.svg").is_file());
    names.sort();
    let mut page =
        String::from("# Gallery\n\nEvery scene of the repository, run and drawn by `cargo xtask gallery`.\n");
    for name in &names {
        let bytes = from.join(name).join("shape.svg");
        make(to)?;
        fs::copy(&bytes, to.join(format!("{name}.svg")))
            .map_err(|error| format!("cannot copy {}: {error}", bytes.display()))?;
        page += &format!("\n## {name}\n\n[![{name}](gallery/{name}.svg)]({REPOSITORY}scenes)\n");
    }
    Ok((!names.is_empty()).then_some(page))
}

fn pictures(from: &Path, to: &Path) -> Result<(), String> {
    let entries = fs::read_dir(from).map_err(|error| format!("cannot read {}: {error}", from.display()))?;
    for path in entries.filter_map(|entry| Some(entry.ok()?.path())) {
        if path.extension().is_some_and(|end| end == "svg" || end == "png") {
            make(to)?;
            let name = path.file_name().unwrap_or_default();
            fs::copy(&path, to.join(name))
                .map_err(|error| format!("cannot copy {}: {error}", path.display()))?;
        }
    }
    Ok(())
}

fn make(folder: &Path) -> Result<(), String> {
    fs::create_dir_all(folder).map_err(|error| format!("cannot make {}: {error}", folder.display()))
}

fn keep(file: &Path, text: &str) -> Result<(), String> {
    make(file.parent().unwrap_or(file))?;
    fs::write(file, text).map_err(|error| format!("cannot write {}: {error}", file.display()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_lead_to_pages_of_the_site_or_to_the_repository() {
        let pages = listed("[a](a.md)\n- [n](../NOTATION.md)\n- [g](guide/README.md)\n");
        assert_eq!(pages, ["docs/a.md", "NOTATION.md", "docs/guide/README.md"]);
        let text = "[n](../NOTATION.md#x) [g](guide/README.md#a) [s](../scenes/ring.toml) [w](https://example.org) [p](p.svg) [h](#h)";
        let on_the_site = moved(text, "docs/a.md", &pages);
        let scene = format!("[s]({REPOSITORY}scenes/ring.toml)");
        let wanted = text.replace("[s](../scenes/ring.toml)", &scene).replace("README.md", "index.md");
        assert_eq!(on_the_site, wanted);
        let summary = from_the_root("- [n](../NOTATION.md) [r](../README.md) [a](a.md)");
        assert_eq!(summary, "- [n](NOTATION.md) [r](index.md) [a](docs/a.md)");
    }
}
