//! `cargo xtask new-case NAME`: the files of a new benchmark, from templates that explain each entry.

use crate::cargo;
use clap::Args;
use std::fs;
use std::path::{Path, PathBuf};

/// Which benchmark to lay out.
#[derive(Args)]
pub struct Options {
    /// Its name in kebab-case, such as pinched-cylinder
    #[arg(value_name = "NAME")]
    name: String,
}

const SCENE: &str = include_str!("../templates/scene.toml.template");
const CASE: &str = include_str!("../templates/case.rs.template");

/// Write the files and say what is left to do by hand.
pub fn run(options: &Options) -> Result<(), String> {
    let name = Name::new(&options.name)?;
    for path in lay_out(&name, &cargo::root())? {
        println!("wrote {}", path.display());
    }
    println!("\n{}", name.left_to_do());
    Ok(())
}

/// A checked name.
#[derive(Debug, PartialEq, Eq)]
struct Name {
    kebab: String,
    snake: String,
}

impl Name {
    fn new(name: &str) -> Result<Self, String> {
        let letters = |part: &str| part.bytes().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit());
        let begins = name.starts_with(|c: char| c.is_ascii_lowercase());
        if !begins || !name.split('-').all(|part| !part.is_empty() && letters(part)) {
            return Err(format!(
                "\"{name}\" is not kebab-case: write lower-case letters and digits in parts joined by single \
                 hyphens, beginning with a letter, such as pinched-cylinder"
            ));
        }
        Ok(Self { kebab: name.to_owned(), snake: name.replace('-', "_") })
    }

    fn fill(&self, template: &str) -> String {
        template.replace("{{name}}", &self.kebab).replace("{{snake}}", &self.snake)
    }

    fn left_to_do(&self) -> String {
        self.fill(
            "left to do:\n\
             1. describe the problem in scenes/{{name}}.toml and look at it: coque run scenes/{{name}}.toml\n\
             2. put the reference into benchmarks-ref/data and its line into benchmarks-ref/src/catalogue.rs\n\
             3. state metric and tolerance with its reason in validation/src/cases/shell/{{snake}}.rs\n\
             4. add to validation/src/cases/shell/mod.rs:  mod {{snake}};  and to its list of cases:  {{snake}}::case(),\n\
             5. judge it: cargo xtask validate --case {{name}}",
        )
    }
}

/// Write both files below `root`, or none if one of them exists.
fn lay_out(name: &Name, root: &Path) -> Result<Vec<PathBuf>, String> {
    let files = [
        (PathBuf::from(format!("scenes/{}.toml", name.kebab)), SCENE),
        (PathBuf::from(format!("validation/src/cases/shell/{}.rs", name.snake)), CASE),
    ];
    if let Some((path, _)) = files.iter().find(|(path, _)| root.join(path).exists()) {
        return Err(format!("{} exists already; choose another name, or edit that file", path.display()));
    }
    for (path, template) in &files {
        let target = root.join(path);
        let folder = target.parent().unwrap_or(root);
        fs::create_dir_all(folder)
            .and_then(|()| fs::write(&target, name.fill(template)))
            .map_err(|error| format!("cannot write {}: {error}", path.display()))?;
    }
    Ok(files.into_iter().map(|(path, _)| path).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_kebab_case() {
        let name = Name::new("plate-2-holes").unwrap();
        assert_eq!((name.kebab.as_str(), name.snake.as_str()), ("plate-2-holes", "plate_2_holes"));
        for bad in
            ["", "Ring", "ring_2", "-ring", "ring-", "two--parts", "2-rings", "ring/..", "mit raum", "höhe"]
        {
            let error = Name::new(bad).unwrap_err();
            assert!(error.contains("kebab-case"), "{bad}: {error}");
        }
    }

    #[test]
    fn files_are_written_once() {
        let root = std::env::temp_dir().join(format!("coque-new-case-{}", std::process::id()));
        let name = Name::new("made-up").unwrap();
        let written = lay_out(&name, &root).unwrap();
        let texts: Vec<String> =
            written.iter().map(|path| fs::read_to_string(root.join(path)).unwrap()).collect();
        let second = lay_out(&name, &root);
        fs::remove_dir_all(&root).unwrap();

        assert_eq!(
            written,
            [Path::new("scenes/made-up.toml"), Path::new("validation/src/cases/shell/made_up.rs")]
        );
        for text in &texts {
            assert!(text.contains("made-up") && !text.contains("{{"), "{text}");
        }
        assert!(texts[1].starts_with("//! "));
        assert!(second.unwrap_err().contains("exists already"));
    }

    #[test]
    fn the_list_line_is_reported() {
        let reported = Name::new("made-up").unwrap().left_to_do();
        assert!(reported.contains("made_up::case()") && reported.contains("--case made-up"), "{reported}");
    }
}
