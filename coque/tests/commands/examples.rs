//! The examples: each compares a number with a closed form and says by its exit code whether it holds.
//!
//! `cargo test` and `cargo nextest run` build the examples with the tests, unless a target is named to build:
//! before `cargo test -p coque --test commands examples` alone comes `cargo build -p coque --examples`.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// The ladder: examples whose names begin with their number. The others are tools.
fn ladder() -> Vec<(String, PathBuf)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let mut files: Vec<PathBuf> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    let named =
        files.into_iter().map(|file| (file.file_stem().unwrap().to_string_lossy().into_owned(), file));
    named.filter(|(name, _)| name.starts_with(|c: char| c.is_ascii_digit())).collect()
}

/// The compiled example, no older than its source: `deps/examples-…` of the same profile lies beside `examples/`.
fn compiled(name: &str, source: &Path) -> PathBuf {
    let test = std::env::current_exe().unwrap();
    let profile = test.parent().unwrap().parent().unwrap();
    let program = profile.join("examples").join(name).with_extension(std::env::consts::EXE_EXTENSION);
    let time = |file: &Path| fs::metadata(file).and_then(|data| data.modified()).ok();
    assert!(
        time(&program).is_some_and(|built| built >= time(source).unwrap()),
        "{} is missing or older than its source; build it first: cargo build -p coque --examples",
        program.display()
    );
    program
}

#[test]
fn every_example_holds() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("examples");
    fs::create_dir_all(&folder).unwrap();
    let picture = folder.join("out/3_roll_up/shapes.svg");
    let _ = fs::remove_file(&picture);
    let start = |(name, source): (String, PathBuf)| {
        let mut command = Command::new(compiled(&name, &source));
        command.current_dir(&folder).stdout(Stdio::piped()).stderr(Stdio::piped());
        (name, command.spawn().unwrap())
    };
    let running: Vec<_> = ladder().into_iter().map(start).collect();
    for (name, child) in running {
        let output = child.wait_with_output().unwrap();
        let [said, complaint] = [&output.stdout, &output.stderr].map(|bytes| String::from_utf8_lossy(bytes));
        assert!(output.status.success(), "{name}: {}\n{said}{complaint}", output.status);
        // A heading and at least one row: what a reader came for.
        assert!(said.lines().count() > 1, "{name} prints no table:\n{said}");
    }
    assert!(fs::read_to_string(picture).unwrap().starts_with("<svg"));
}

#[test]
fn the_ladder_is_the_one_that_is_reported() {
    let names: Vec<String> = ladder().into_iter().map(|(name, _)| name).collect();
    let readme =
        fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/README.md")).unwrap();
    let reported: Vec<&str> = readme
        .lines()
        .filter_map(|line| line.strip_prefix("| [`")?.split_once("`]("))
        .map(|(name, rest)| {
            assert!(rest.starts_with(&format!("{name}.rs) |")), "{name} is linked to {rest}");
            name
        })
        .collect();
    assert_eq!(names, reported, "examples on disk, and in the table of their README");
    let text = |name: &str| {
        fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("examples/{name}.rs"))).unwrap()
    };
    for (number, name) in (1..).zip(&names) {
        assert!(name.starts_with(&format!("{number}_")), "{name} is number {number}");
        let command = format!("`cargo run --release -p coque --example {name}`");
        assert!(text(name).contains(&command), "{name} does not say how it is run: {command}");
    }
    // Each names its neighbours, so that a reader finds the way from any of them.
    for pair in names.windows(2) {
        assert!(
            text(&pair[0]).contains(&format!("next: `{}`", pair[1])),
            "{} does not name its next",
            pair[0]
        );
        assert!(text(&pair[1]).contains(&format!("before: `{}`", pair[0])), "{} not the one before", pair[1]);
    }
}
