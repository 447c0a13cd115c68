//! `cargo xtask deb`: the program as a package of Debian, with its manual page and what completes its words.

use crate::cargo;
use std::fs;
use std::path::Path;
use std::process::Command;

/// What the program prints of itself, and the file that it goes into.
const PRINTED: [(&[&str], &str); 4] = [
    (&["man"], "coque.1"),
    (&["completion", "bash"], "coque.bash"),
    (&["completion", "zsh"], "_coque"),
    (&["completion", "fish"], "coque.fish"),
];

/// Build for distribution, let the program print its page and completions, pack all of it.
pub fn run() -> Result<(), String> {
    if !cargo::has("deb") {
        return Err("cargo-deb is not installed; install it with: cargo install cargo-deb".into());
    }
    let build =
        cargo::words(&["build", "--profile", "dist", "--package", "coque", "--bin", "coque", "--locked"]);
    succeed(&build)?;
    let target = cargo::target()?;
    let folder = target.join("deb");
    printed(&target.join("dist/coque"), &folder)?;
    let folder = folder.display().to_string();
    let pack =
        ["deb", "--package", "coque", "--profile", "dist", "--no-build", "--locked", "--output", &folder];
    succeed(&cargo::words(&pack))
}

fn succeed(words: &[String]) -> Result<(), String> {
    let failed = || format!("{} failed; its message stands above", cargo::spelled(words));
    cargo::succeeds(words)?.then_some(()).ok_or_else(failed)
}

/// Fills the folder with what the program prints.
fn printed(program: &Path, folder: &Path) -> Result<(), String> {
    fs::create_dir_all(folder).map_err(|error| format!("cannot make {}: {error}", folder.display()))?;
    for (words, file) in PRINTED {
        let output = Command::new(program).args(words).output();
        let output = output.map_err(|error| format!("cannot start {}: {error}", program.display()))?;
        if !output.status.success() {
            return Err(format!("coque {} ended with {}", words.join(" "), output.status));
        }
        let file = folder.join(file);
        fs::write(&file, output.stdout)
            .map_err(|error| format!("cannot write {}: {error}", file.display()))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_package_holds_what_the_program_prints() {
        let manifest = fs::read_to_string(cargo::root().join("coque/Cargo.toml")).unwrap_or_default();
        for (_, file) in PRINTED {
            assert!(manifest.contains(&format!("\"../target/deb/{file}\"")), "{file} is no asset");
        }
        let folder = std::env::temp_dir().join("xtask-deb");
        assert!(printed(Path::new("no-such-program"), &folder).is_err());
    }
}
