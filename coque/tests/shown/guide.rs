//! The guide, followed to the letter: its commands are run, its output and its pictures are those that come out.
//!
//! What a page holds, from top to bottom: `sh` blocks are run in the folder `out/guide` of a copy; the `text` block after
//! one is what it prints, times and speeds apart, lines left out where an ellipsis stands, numbers to six digits (the
//! linear solver's last ones differ between processors); a `toml` block is saved under the
//! name given in the line before it; a picture is compared with the file of its name that the commands made.
//!
//! After a change that is meant, COQUE_GUIDE=refresh writes pictures and output anew; then read the difference.

#![cfg(unix)] // blocks are run by a shell
#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

const LEFT_OUT: &str = "…";

fn kept() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/guide")
}

/// A page with what is to be done, in order.
struct Page {
    name: String,
    text: String,
    steps: Vec<Step>,
}

enum Step {
    /// Commands, and what they print if the page shows it: a range of its text.
    Run { commands: String, printed: Option<std::ops::Range<usize>> },
    /// A file to be saved.
    Save { name: String, text: String },
    /// A picture.
    Look { name: String },
}

fn read(name: &str) -> Page {
    let text = fs::read_to_string(kept().join(name)).unwrap().replace("\r\n", "\n");
    let mut steps = Vec::new();
    let (mut at, mut before) = (0, "");
    let mut block: Option<(&str, usize)> = None;
    for line in text.split_inclusive('\n') {
        let next = at + line.len();
        match (block, line.trim_end().strip_prefix("```")) {
            (None, Some(kind)) => block = Some((kind, next)),
            (Some((kind, from)), Some(_)) => {
                let inner = &text[from..at];
                match (kind, steps.last_mut()) {
                    ("sh", _) => steps.push(Step::Run { commands: inner.into(), printed: None }),
                    ("toml", _) => {
                        let saved = before.split('`').nth(1);
                        let name = saved.unwrap_or_else(|| panic!("{name}: no name before a scene")).into();
                        steps.push(Step::Save { name, text: inner.into() });
                    }
                    ("text", Some(Step::Run { printed, .. })) => *printed = Some(from..at),
                    _ => panic!("{name}: a block `{kind}` without commands before it"),
                }
                block = None;
            }
            (None, None) => {
                if let Some((_, rest)) = line.split_once("![").and_then(|(_, rest)| rest.split_once("](")) {
                    steps.push(Step::Look { name: rest.split(')').next().unwrap().into() });
                }
                if !line.trim().is_empty() {
                    before = line;
                }
            }
            (Some(_), None) => {}
        }
        at = next;
    }
    Page { name: name.into(), text, steps }
}

/// Follows a page in an empty copy; what differs is reported at the end, or written into the page.
fn follow(name: &str) {
    let page = read(name);
    let refresh = std::env::var("COQUE_GUIDE").is_ok_and(|value| value == "refresh");
    let root = Path::new(env!("CARGO_TARGET_TMPDIR")).join("guide").join(name);
    if root.exists() {
        fs::remove_dir_all(&root).unwrap();
    }
    let (copy, here) = (root.join("docs/guide"), root.join("out/guide"));
    fs::create_dir_all(&copy).unwrap();
    fs::create_dir_all(&here).unwrap();
    for file in fs::read_dir(kept()).unwrap().map(|entry| entry.unwrap().path()) {
        fs::copy(&file, copy.join(file.file_name().unwrap())).unwrap();
    }
    let (mut wrong, mut renewed, mut written) = (String::new(), String::new(), 0);
    for step in &page.steps {
        match step {
            Step::Save { name, text } => fs::write(here.join(name), text).unwrap(),
            Step::Run { commands, printed } => {
                let (found, succeeded) = run(commands, &here);
                let Some(range) = printed else {
                    assert!(succeeded, "{}: failed:\n{commands}\n{found}", page.name);
                    continue;
                };
                let expected = &page.text[range.clone()];
                if same(expected, &found) {
                    continue;
                }
                wrong += &format!("after\n{commands}\nthe page shows\n{expected}\nbut it is\n{found}\n");
                if !expected.contains(LEFT_OUT) {
                    renewed += &page.text[written..range.start];
                    renewed.extend(found.lines().map(|line| format!("{}\n", line.trim_end())));
                    written = range.end;
                }
            }
            Step::Look { name } => {
                let made = fs::read(here.join(name)).unwrap();
                if refresh {
                    fs::write(kept().join(name), &made).unwrap();
                } else if fs::read(kept().join(name)).is_ok_and(|kept| alike(&kept, &made)) {
                    continue;
                }
                wrong += &format!("the picture {name} is another one\n");
            }
        }
    }
    if refresh {
        renewed += &page.text[written..];
        fs::write(kept().join(&page.name), renewed).unwrap();
        eprintln!("{wrong}");
        return;
    }
    assert!(
        wrong.is_empty(),
        "docs/guide/{}: {wrong}\nif this is meant: COQUE_GUIDE=refresh cargo test -p coque --test shown guide",
        page.name
    );
}

/// Both streams of a block of commands in the order printed, and whether the last one succeeded.
fn run(commands: &str, here: &Path) -> (String, bool) {
    let program = Path::new(env!("CARGO_BIN_EXE_coque")).parent().unwrap();
    let path = format!("{}:{}", program.display(), std::env::var("PATH").unwrap_or_default());
    // What the reader installs is the program under test.
    let lines: Vec<&str> = commands.lines().filter(|line| !line.starts_with("cargo install")).collect();
    let output = Command::new("sh")
        .args(["-c", &format!("exec 2>&1\n{}", lines.join("\n"))])
        .env("PATH", path)
        .current_dir(here)
        .output()
        .unwrap();
    (String::from_utf8(output.stdout).unwrap(), output.status.success())
}

/// Whether a page shows what was printed; an ellipsis stands for any number of lines.
fn same(expected: &str, found: &str) -> bool {
    let lines = |text: &str| text.lines().map(timeless).collect::<Vec<_>>();
    let (expected, found) = (lines(expected), lines(found));
    let (mut at, mut skipping) = (0, false);
    for line in expected {
        if line == LEFT_OUT {
            skipping = true;
            continue;
        }
        let rest = &found[at..];
        let step = if skipping { rest.iter().position(|other| equal(other, &line)) } else { Some(0) };
        match step {
            Some(step) if rest.get(step).is_some_and(|other| equal(other, &line)) => at += step + 1,
            _ => return false,
        }
        skipping = false;
    }
    skipping || at == found.len()
}

/// Whether two lines are the same words, and numbers to six digits.
fn equal(a: &str, b: &str) -> bool {
    let words = |line: &str| line.split([' ', ',']).map(str::to_string).collect::<Vec<_>>();
    let (a, b) = (words(a), words(b));
    let near = |a: &str, b: &str| match (a.parse::<f64>(), b.parse::<f64>()) {
        (Ok(a), Ok(b)) => (a - b).abs() <= 1e-6 * a.abs().max(b.abs()),
        _ => a == b,
    };
    a.len() == b.len() && a.iter().zip(&b).all(|(a, b)| near(a, b))
}

/// Whether two pictures are the same, but for a few cells whose tenths of a pixel or colours were rounded the other way.
fn alike(kept: &[u8], made: &[u8]) -> bool {
    let lines =
        |picture: &[u8]| String::from_utf8_lossy(picture).lines().map(String::from).collect::<Vec<_>>();
    let (kept, made) = (lines(kept), lines(made));
    let differ = kept.iter().zip(&made).filter(|(a, b)| a != b).count();
    kept.len() == made.len() && differ <= kept.len() / 50
}

/// A line without what the clock says: seconds, speeds, and what `coque check` makes of them.
fn timeless(line: &str) -> String {
    if line.contains("timed just now") || line.trim_start().starts_with("wall time") {
        return line.split_whitespace().take(1).collect();
    }
    let words: Vec<&str> = line.split(' ').collect();
    let of_clock = |i: usize| {
        let next = words.get(i + 1).map(|word| word.trim_end_matches([';', ',']));
        words[i].parse::<f64>().is_ok() && matches!(next, Some("s" | "particle-steps/s"))
    };
    let kept = words.iter().enumerate().map(|(i, word)| if of_clock(i) { "#" } else { word });
    kept.collect::<Vec<_>>().join(" ").trim_end().to_string()
}

#[test]
fn the_first_page_ends_in_its_pictures() {
    follow("README.md");
}

#[test]
fn the_strip_ends_in_its_pictures() {
    follow("1-strip.md");
}

#[test]
fn the_panel_ends_in_its_pictures() {
    follow("2-panel.md");
}

#[test]
fn the_pipe_ends_in_its_pictures() {
    follow("3-mesh.md");
}

#[test]
fn the_dam_ends_in_its_pictures() {
    follow("4-fluid.md");
}

#[test]
fn the_shell_and_the_solid_end_in_their_picture() {
    follow("5-shell-and-solid.md");
}

#[test]
fn only_times_may_differ() {
    let printed = "3 steps in 0.18 s, 5.10e5 particle-steps/s; results in out/a\n";
    assert!(same("3 steps in 9.00 s, 1.00e6 particle-steps/s; results in out/a\n", printed));
    assert!(!same("4 steps in 9.00 s, 1.00e6 particle-steps/s; results in out/a\n", printed));
    assert!(same("a\n…\nd\n", "a\nb\nc\nd\n") && same("a\n…\n", "a\nb\n"));
    assert!(same("1.0000000,2 x\n", "1.0000001,2 x\n") && !same("1.0,2 x\n", "1.1,2 x\n"));
    assert!(!same("a\n…\nd\n", "a\nb\nc\n") && !same("a\n", "a\nb\n") && !same("a\nb\n", "a\n"));
}
