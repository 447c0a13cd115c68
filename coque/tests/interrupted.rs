//! The command under Ctrl-C and under kill -9: results so far, and the same curve to the byte once it has gone on.

#![cfg(unix)]
#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::thread::sleep;
use std::time::Duration;

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("interrupted").join(name);
    let _ = fs::remove_dir_all(&folder);
    folder
}

fn coque(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_coque"));
    command
        .args(arguments)
        .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join(".."))
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    command
}

/// A ring that takes about a second, with a checkpoint every few milliseconds.
fn ring<'a>(out: &'a str, more: &[&'a str]) -> Vec<&'a str> {
    let mut arguments = vec!["run", "scenes/ring.toml", "--out", out];
    for replaced in ["geometry.plate.particles=[33, 5]", "output.checkpoint_every=0.005"].iter().chain(more) {
        arguments.extend(["--set", replaced]);
    }
    arguments
}

fn finished(output: &Output) {
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
}

/// Waits until a run under way has written its first checkpoint.
fn begun(run: &mut Child, out: &Path) {
    for _ in 0..3000 {
        if out.join("checkpoint.bin").exists() {
            return;
        }
        assert!(run.try_wait().unwrap().is_none(), "the run ended without a checkpoint");
        sleep(Duration::from_millis(20));
    }
    panic!("no checkpoint within a minute");
}

fn signal(run: &Child, name: &str) {
    let sent = Command::new("kill").args([name, &run.id().to_string()]).status().unwrap();
    assert!(sent.success());
}

#[test]
fn interrupt_ends_in_good_order() {
    let out = folder("ctrl-c");
    let path = out.to_string_lossy();
    // Too long to end by itself.
    let mut run = coque(&ring(&path, &["analysis.explicit.quasi-static.levels=1000"])).spawn().unwrap();
    begun(&mut run, &out);
    signal(&run, "-INT");
    let output = run.wait_with_output().unwrap();
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(130), "{said}");
    assert!(said.contains("interrupted at time "), "{said}");
    assert!(said.contains(&format!("go on with: coque resume {path}")), "{said}");
    let curve = fs::read_to_string(out.join("curve.csv")).unwrap();
    let mut lines = curve.lines();
    let columns = lines.next().unwrap().split(',').count();
    assert!(curve.ends_with('\n') && curve.starts_with("time [s],level [-]"));
    let rows: Vec<&str> = lines.collect();
    assert!(!rows.is_empty());
    for row in rows {
        let numbers: Vec<f64> = row.split(',').map(|x| x.parse().unwrap()).collect();
        assert_eq!(numbers.len(), columns);
    }
    let summary = fs::read_to_string(out.join("summary.json")).unwrap();
    let summary: serde_json::Value = serde_json::from_str(&summary).unwrap();
    assert!(summary["ended"].as_str().unwrap().starts_with("interrupted at time "));
    assert!(summary["steps"].as_u64().unwrap() > 0);
}

#[test]
fn killed_at_any_moment_it_ends_in_the_same_bytes() {
    let (whole, out) = (folder("whole"), folder("killed"));
    let (whole_path, path) = (whole.to_string_lossy(), out.to_string_lossy());
    finished(&coque(&ring(&whole_path, &[])).output().unwrap());
    let mut run = coque(&ring(&path, &[])).spawn().unwrap();
    begun(&mut run, &out);
    let mut killed = 0;
    // Moments without a pattern, the same on every run.
    for milliseconds in [3, 41, 17, 88, 29, 7, 61] {
        sleep(Duration::from_millis(milliseconds));
        if run.try_wait().unwrap().is_some() {
            break;
        }
        signal(&run, "-KILL");
        run.wait().unwrap();
        killed += 1;
        run = coque(&["resume", &path]).spawn().unwrap();
        // The old checkpoint is there until the run has come further: give it a moment to start.
        sleep(Duration::from_millis(40));
    }
    assert!(killed >= 1);
    finished(&run.wait_with_output().unwrap());
    let curve = |folder: &Path| fs::read(folder.join("curve.csv")).unwrap();
    assert_eq!(curve(&whole), curve(&out));
    assert!(!out.join("checkpoint.bin").exists());

    let again = coque(&["resume", &path]).output().unwrap();
    assert_eq!(again.status.code(), Some(2));
    let said = String::from_utf8_lossy(&again.stderr);
    assert!(said.contains("has ended already (done); to run it anew: coque run "), "{said}");
}

#[test]
fn a_resumed_scene_keeps_what_the_command_line_replaced() {
    let out = folder("replaced");
    let path = out.to_string_lossy();
    let mut run =
        coque(&ring(&path, &["title=\"turned = round\"", "analysis.static.levels=150"])).spawn().unwrap();
    begun(&mut run, &out);
    signal(&run, "-INT");
    let code = run.wait().unwrap().code();
    assert_eq!(code, Some(130));
    let resumed = coque(&["resume", &path, "--threads", "2"]).output().unwrap();
    finished(&resumed);
    assert!(String::from_utf8_lossy(&resumed.stderr).starts_with("turned = round: 165 particles"));
    let summary = fs::read_to_string(out.join("summary.json")).unwrap();
    let summary: serde_json::Value = serde_json::from_str(&summary).unwrap();
    assert_eq!(summary["replaced"][0], "geometry.plate.particles=[33, 5]");
    assert_eq!((&summary["analysis"], &summary["threads"]), (&"static".into(), &2.into()));
}

#[test]
fn checkpoints_where_none_can_be_kept_are_refused() {
    let refused = coque(&ring("out/never", &["analysis.arc-length.until=1.0"])).output().unwrap();
    assert_eq!(refused.status.code(), Some(2));
    let said = String::from_utf8_lossy(&refused.stderr);
    assert!(said.contains("an arc-length analysis, which cannot go on from its middle"), "{said}");
}
