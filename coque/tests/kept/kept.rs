//! Results are kept: whatever becomes of the terminal, of the room on the disk, and of a second run in the same folder.

#![cfg(unix)]
#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::fs;
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("kept").join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(folder.parent().unwrap()).unwrap();
    folder
}

/// A support that a run in real time can have in the place of a motion.
const HINGE: [&str; 2] = ["--set", "supports[2]={ on = \"u0v0\", hinged = {} }"];

/// A run of a few hundredths of a second, with a picture of its curve.
fn patch(out: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_coque"));
    command
        .args([
            "run",
            "scenes/patch-test.toml",
            "--set",
            "output.plot={ x = \"level\", y = \"U_end\" }",
            "--out",
        ])
        .arg(out)
        .current_dir(root())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    command
}

fn code(output: &Output) -> i32 {
    output.status.code().unwrap_or(-1)
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap());
    let mut names: Vec<String> =
        entries.map(|entry| entry.file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

const WHOLE: [&str; 4] = ["curve.csv", "curve.svg", "scene.toml", "summary.json"];

#[test]
fn a_terminal_that_has_gone_ends_no_run() {
    let whole = folder("terminal");
    let done = patch(&whole).output().unwrap();
    assert_eq!(code(&done), 0, "{}", said(&done));
    let curve = fs::read(whole.join("curve.csv")).unwrap();
    // Closed; full; a pipe whose reader has gone before a word was said.
    for (number, end) in ["2>&-", "2>/dev/full >/dev/full", "2>&1 | true"].iter().enumerate() {
        let out = folder(&format!("terminal-{number}"));
        let reported = out.with_extension("code");
        let line = format!(
            "{{ sleep 0.05; \"$0\" run scenes/patch-test.toml \
             --set 'output.plot={{ x = \"level\", y = \"U_end\" }}' --out \"$1\"; echo $? > \"$2\"; }} {end}"
        );
        let shell = ["sh", "-c", &line, env!("CARGO_BIN_EXE_coque")];
        Command::new("env").args(shell).args([&out, &reported]).current_dir(root()).status().unwrap();
        // The last part of a pipe does not wait for the first.
        let mut waited = 0;
        while !reported.exists() || fs::read_to_string(&reported).unwrap().is_empty() {
            std::thread::sleep(std::time::Duration::from_millis(10));
            waited += 1;
            assert!(waited < 6000, "{end}: no end within a minute");
        }
        assert_eq!(fs::read_to_string(&reported).unwrap().trim(), "0", "{end}");
        assert_eq!(fs::read(out.join("curve.csv")).unwrap(), curve, "{end}");
        assert_eq!(names(&out), WHOLE, "{end}");
        fs::remove_file(&reported).unwrap();
    }
    // A refusal that cannot be printed is one still; so is a list that is not printed.
    for line in ["\"$0\" run no-such-scene.toml 2>/dev/full", "\"$0\" list 2>/dev/full >/dev/full"] {
        let refused = Command::new("sh").args(["-c", line, env!("CARGO_BIN_EXE_coque")]).output().unwrap();
        assert_eq!(code(&refused), 2, "{line}");
    }
}

/// A run under a bound on the length of its files, in kilobytes: what has no room is refused as on a full disk.
fn bounded(kilobytes: usize, arguments: &[&str], out: &Path) -> Output {
    let line = format!("ulimit -f {kilobytes}; exec \"$0\" \"$@\" --out \"$OUT\"");
    Command::new("bash")
        .args(["-c", &line, env!("CARGO_BIN_EXE_coque")])
        .args(arguments)
        .env("OUT", out)
        .current_dir(root())
        .output()
        .unwrap()
}

#[test]
fn a_disk_that_fills_up_costs_neither_the_curve_so_far_nor_whole_files() {
    let out = folder("full");
    let transient = "analysis.explicit={ transient = { duration = 0.02, record_every = 1e-4 } }";
    let run = ["run", "scenes/patch-test.toml", HINGE[0], HINGE[1], "--set", transient];
    let reference = folder("full-reference");
    let done = bounded(1000, &run, &reference);
    assert_eq!(code(&done), 0, "{}", said(&done));
    let whole = fs::read_to_string(reference.join("curve.csv")).unwrap();
    assert!(whole.len() > 8 * 1024, "{} bytes are too few for this test", whole.len());

    let stopped = bounded(8, &run, &out);
    assert_eq!(code(&stopped), 2, "{}", said(&stopped));
    assert!(said(&stopped).contains("curve so far cannot be written"), "{}", said(&stopped));
    assert!(said(&stopped).contains("cannot write"), "{}", said(&stopped));
    let kept = fs::read_to_string(out.join("curve.csv")).unwrap();
    // Whole rows, as many as there was room for.
    assert!(whole.starts_with(&kept) && kept.ends_with('\n') && kept.len() > 7 * 1024, "{}", kept.len());
    // The summary did find room.
    assert_eq!(names(&out), ["curve.csv", "scene.toml", "summary.json"]);

    // Checkpoints that find no room leave nothing behind, and cost nothing.
    let out = folder("full-checkpoint");
    let checkpoint = ["--set", "output.checkpoint_every=1e-9", "--set", "geometry.plate.particles=[41, 41]"];
    let warned = bounded(40, &[&run[..2], &checkpoint].concat(), &out);
    assert_eq!(code(&warned), 0, "{}", said(&warned));
    assert!(said(&warned).contains("checkpoint.bin"), "{}", said(&warned));
    assert!(names(&out).iter().all(|name| WHOLE.contains(&name.as_str())), "{:?}", names(&out));
}

#[test]
fn results_of_before_stand_until_there_is_room_for_others() {
    let out = folder("stand");
    assert_eq!(code(&patch(&out).output().unwrap()), 0);
    let before: Vec<Vec<u8>> = WHOLE.iter().map(|name| fs::read(out.join(name)).unwrap()).collect();
    let refused = bounded(0, &["run", "scenes/patch-test.toml"], &out);
    assert_eq!(code(&refused), 2, "{}", said(&refused));
    assert_eq!(names(&out), WHOLE);
    let after: Vec<Vec<u8>> = WHOLE.iter().map(|name| fs::read(out.join(name)).unwrap()).collect();
    assert!(before == after);

    // Pictures as well: into a device that takes nothing, and beside a file of before.
    let shape =
        bounded(0, &["plot", &out.to_string_lossy(), "--curve", "level,U_end"], &out.join("curve.svg"));
    assert_eq!(code(&shape), 2, "{}", said(&shape));
    assert_eq!(names(&out), WHOLE);
    assert_eq!(fs::read(out.join("curve.svg")).unwrap(), before[1]);
}

#[test]
fn of_two_runs_into_one_folder_one_is_refused_and_the_other_is_whole() {
    let alone = folder("alone");
    assert_eq!(code(&patch(&alone).output().unwrap()), 0);
    let curve = fs::read(alone.join("curve.csv")).unwrap();
    let mut refused = 0;
    for race in 0..8 {
        let out = folder("race");
        let runs: Vec<_> = (0..3).map(|_| patch(&out).spawn().unwrap()).collect();
        let ends: Vec<Output> = runs.into_iter().map(|run| run.wait_with_output().unwrap()).collect();
        for end in ends.iter().filter(|end| code(end) != 0) {
            assert_eq!(code(end), 2, "{}", said(end));
            assert!(said(end).contains("is in use by "), "{}", said(end));
            refused += 1;
        }
        assert!(ends.iter().any(|end| code(end) == 0), "race {race}: {}", said(&ends[0]));
        assert_eq!(fs::read(out.join("curve.csv")).unwrap(), curve);
        assert_eq!(names(&out), WHOLE);
    }
    assert!(refused > 0, "the runs were never under way at once");
}

#[test]
fn the_run_that_holds_a_folder_is_named_and_a_killed_one_holds_none() {
    let out = folder("held");
    let long = ["--set", "analysis.explicit={ transient = { duration = 1e3, record_every = 1.0 } }"];
    let mut holder = patch(&out).args(HINGE).args(long).spawn().unwrap();
    let lock = out.join("coque.lock");
    while !out.join("curve.csv").exists() {
        assert!(holder.try_wait().unwrap().is_none());
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    let who = format!("is in use by process {} on ", holder.id());
    let path = out.to_string_lossy();
    let second = patch(&out).output().unwrap();
    assert_eq!(code(&second), 2);
    assert!(said(&second).contains(&who) && said(&second).contains("--out"), "{}", said(&second));
    let resumed = Command::new(env!("CARGO_BIN_EXE_coque"))
        .args(["resume", &path])
        .current_dir(root())
        .output()
        .unwrap();
    assert_eq!(code(&resumed), 2);
    assert!(said(&resumed).contains(&who), "{}", said(&resumed));
    holder.kill().unwrap();
    holder.wait().unwrap();
    assert!(lock.exists() && !out.join("summary.json").exists());
    assert_eq!(code(&patch(&out).output().unwrap()), 0);
    assert_eq!(names(&out), WHOLE);
}

#[test]
fn nothing_of_an_earlier_run_is_taken_for_this_one_and_foreign_files_stay() {
    let out = folder("cleared");
    let fields = ["--set", "output.fields={ extruded = true }"];
    assert_eq!(code(&patch(&out).args(fields).output().unwrap()), 0);
    fs::write(out.join("notes.txt"), "mine").unwrap();
    fs::write(out.join("fields/shell-view.pvsm"), "mine").unwrap();
    for part in ["curve.csv.part", "checkpoint.bin.part", "fields/shell.pvd.part"] {
        fs::write(out.join(part), "half").unwrap();
    }
    // Killed at once: nothing but the scene, and rows of the run itself.
    let long = ["--set", "analysis.explicit={ transient = { duration = 1e3, record_every = 1e3 } }"];
    let mut run = patch(&out).args(HINGE).args(long).spawn().unwrap();
    while fs::read_to_string(out.join("scene.toml")).is_ok_and(|text| !text.contains("1e3")) {
        assert!(run.try_wait().unwrap().is_none());
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    run.kill().unwrap();
    run.wait().unwrap();
    let left: Vec<String> =
        names(&out).into_iter().filter(|name| name != "curve.csv" && name != "curve.csv.part").collect();
    assert_eq!(left, ["coque.lock", "fields", "notes.txt", "scene.toml"]);
    assert_eq!(names(&out.join("fields")), ["shell-view.pvsm"]);
    if let Ok(curve) = fs::read_to_string(out.join("curve.csv")) {
        assert!(curve.lines().count() <= 2, "{curve}");
    }
}

#[test]
fn links_lead_nowhere_out_of_the_folder() {
    for name in
        ["curve.csv", "curve.svg", "summary.json", "scene.toml", "fields", "coque.lock", "curve.csv.part"]
    {
        let (out, outside) = (folder("linked"), folder("outside"));
        fs::create_dir_all(&out).unwrap();
        fs::create_dir_all(&outside).unwrap();
        fs::write(outside.join("file"), "mine").unwrap();
        let target = if name == "fields" { outside.clone() } else { outside.join("file") };
        symlink(&target, out.join(name)).unwrap();
        let refused = patch(&out).args(["--set", "output.fields={}"]).output().unwrap();
        assert_eq!(code(&refused), 2, "{name}: {}", said(&refused));
        assert!(said(&refused).contains(name) && said(&refused).contains("link"), "{}", said(&refused));
        assert_eq!(fs::read_to_string(outside.join("file")).unwrap(), "mine");
        assert_eq!(names(&outside), ["file"]);
        assert!(out.join(name).is_symlink());
    }
    // The folder itself may be one, and a sweep's numbered folders may not.
    let (out, outside) = (folder("linked"), folder("outside"));
    fs::create_dir_all(&outside).unwrap();
    symlink(&outside, &out).unwrap();
    assert_eq!(code(&patch(&out).output().unwrap()), 0);
    fs::remove_file(&out).unwrap();
    fs::create_dir_all(&out).unwrap();
    symlink(&outside, out.join("001")).unwrap();
    let sweep = ["sweep", "scenes/patch-test.toml", "--over", "material.elastic.young=1e5,2e5", "--out"];
    let sweep = |out: &Path| {
        Command::new(env!("CARGO_BIN_EXE_coque")).args(sweep).arg(out).current_dir(root()).output().unwrap()
    };
    let refused = sweep(&out);
    assert_eq!(code(&refused), 2, "{}", said(&refused));
    assert!(said(&refused).contains("001 is a link"), "{}", said(&refused));
    assert_eq!(names(&outside), WHOLE);
    // What an earlier sweep had more of is taken out.
    fs::remove_file(out.join("001")).unwrap();
    fs::create_dir_all(out.join("007")).unwrap();
    fs::write(out.join("007/curve.csv"), "old").unwrap();
    fs::create_dir_all(out.join("008")).unwrap();
    fs::write(out.join("008/notes.txt"), "mine").unwrap();
    assert_eq!(code(&sweep(&out)), 0);
    assert_eq!(names(&out), ["001", "002", "008", "sweep.csv"]);
    assert_eq!(names(&out.join("001")), ["curve.csv"]);
}
