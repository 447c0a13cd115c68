//! The command under Ctrl-C, SIGTERM, SIGHUP and kill -9: results so far, and the same curve to the byte once it has gone on.

#![cfg(unix)]
#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::fs;
use std::io::{BufRead, BufReader, Read};
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
    ["-INT", "-TERM", "-HUP", "-XCPU"].into_iter().for_each(ended_by);
}

fn ended_by(name: &str) {
    let out = folder(&format!("ended{name}"));
    let path = out.to_string_lossy();
    // Too long to end by itself.
    let mut run = coque(&ring(&path, &["analysis.explicit.quasi-static.levels=1000"])).spawn().unwrap();
    begun(&mut run, &out);
    signal(&run, name);
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

/// What `nohup` starts goes on when its terminal has gone.
#[test]
fn a_hangup_that_is_ignored_ends_nothing() {
    let out = folder("nohup");
    let path = out.to_string_lossy();
    let mut started = Command::new("sh");
    started.args(["-c", "trap '' HUP; exec \"$0\" \"$@\"", env!("CARGO_BIN_EXE_coque")]);
    let mut run = started
        .args(ring(&path, &["analysis.explicit.quasi-static.levels=2"]))
        .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join(".."))
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    begun(&mut run, &out);
    signal(&run, "-HUP");
    finished(&run.wait_with_output().unwrap());
}

/// While a large model is built there is nothing to keep.
#[cfg(target_os = "linux")]
#[test]
fn interrupt_before_the_run_begins_ends_at_once() {
    for name in ["-INT", "-TERM"] {
        let out = folder("building");
        let path = out.to_string_lossy();
        let large = ["geometry.plate.particles=[401, 401]", "formulation.nodal.order=2"];
        let mut run = coque(&ring(&path, &large)).spawn().unwrap();
        // From here on signals are caught: bit n − 1 is that of signal n.
        let status = format!("/proc/{}/status", run.id());
        let caught = || {
            let status = fs::read_to_string(&status).unwrap_or_default();
            let mask = status.lines().find_map(|line| line.strip_prefix("SigCgt:").map(str::trim));
            let mask = mask.and_then(|mask| u64::from_str_radix(mask, 16).ok()).unwrap_or(0);
            mask & (1 << 1) != 0 && mask & (1 << 14) != 0
        };
        while !caught() {
            assert!(run.try_wait().unwrap().is_none());
            sleep(Duration::from_millis(1));
        }
        sleep(Duration::from_millis(20));
        signal(&run, name);
        let output = run.wait_with_output().unwrap();
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(130), "{said}");
        assert!(said.contains("interrupted before the run began"), "{said}");
        assert!(!out.exists());
    }
}

#[test]
fn killed_without_a_checkpoint_it_leaves_the_rows_so_far() {
    let out = folder("rows");
    let hinge = "supports[2]={ on = \"u0v0\", hinged = {} }";
    let run = ["run", "scenes/patch-test.toml", "--out", &out.to_string_lossy(), "--set", hinge, "--set"];
    let transient = |duration: &str| {
        format!("analysis.explicit={{ transient = {{ duration = {duration}, record_every = 2e-4 }} }}")
    };
    finished(&coque(&[&run[..], &[&transient("0.02")]].concat()).output().unwrap());
    let curve = out.join("curve.csv");
    let whole = fs::read_to_string(&curve).unwrap();
    assert_eq!(whole.lines().count(), 102);
    let mut long = coque(&[&run[..], &[&transient("1e3")]].concat()).spawn().unwrap();
    // The old curve is gone before the first new row comes; every reading is a curve, and a row under way: the system
    // may show the part of a write that lies on an earlier page of the file.
    let mut rows = 0;
    while rows < 60 || rows == 101 {
        if let Some(written) =
            fs::read_to_string(&curve).ok().and_then(|text| Some(text[..=text.rfind('\n')?].to_owned()))
        {
            let read: coque::Curve = written.parse().unwrap();
            rows = read.rows.len();
        }
        assert!(long.try_wait().unwrap().is_none());
    }
    long.kill().unwrap();
    long.wait().unwrap();
    let left = fs::read_to_string(&curve).unwrap();
    let read: coque::Curve = left.parse().unwrap();
    assert!(left.ends_with('\n') && read.rows.len() >= rows);
    let shorter = whole.len().min(left.len());
    assert_eq!(left[..shorter], whole[..shorter], "not the rows of the same run");
}

/// A gate in water for a twentieth of a second, with a checkpoint every few milliseconds of the clock.
fn gate(out: &str) -> Vec<&str> {
    let mut arguments = vec!["run", "scenes/gate.toml", "--out", out];
    for replaced in ["analysis.explicit.transient.duration=0.05", "output.checkpoint_every=0.005"] {
        arguments.extend(["--set", replaced]);
    }
    arguments
}

#[test]
fn killed_at_any_moment_it_ends_in_the_same_bytes() {
    killed_again_and_again("ring", |out| ring(out, &[]), &["curve.csv"]);
}

#[test]
fn killed_at_any_moment_a_coupled_run_ends_in_the_same_bytes() {
    killed_again_and_again(
        "gate",
        gate,
        &["curve.csv", "fields/water-0001.vtu", "fields/gate-solid-0001.vtu"],
    );
}

/// Kills and resumes a run until it is through; files of it are those of a run that went on.
fn killed_again_and_again(name: &str, arguments: fn(&str) -> Vec<&str>, files: &[&str]) {
    let (whole, out) = (folder(&format!("{name}-whole")), folder(&format!("{name}-killed")));
    let (whole_path, path) = (whole.to_string_lossy(), out.to_string_lossy());
    finished(&coque(&arguments(&whole_path)).output().unwrap());
    let mut run = coque(&arguments(&path)).spawn().unwrap();
    begun(&mut run, &out);
    let mut killed = 0;
    // The checkpoint is removed after all else is written: a run that is killed later than that was through.
    let mut through = false;
    // Moments without a pattern, the same on every run.
    for milliseconds in [3, 41, 17, 88, 29, 7, 61] {
        sleep(Duration::from_millis(milliseconds));
        if run.try_wait().unwrap().is_some() {
            break;
        }
        signal(&run, "-KILL");
        run.wait().unwrap();
        killed += 1;
        let (so_far, all) =
            (fs::read(out.join("curve.csv")).unwrap(), fs::read(whole.join("curve.csv")).unwrap());
        assert!(all.starts_with(&so_far) && so_far.ends_with(b"\n"), "not the curve so far");
        through = !out.join("checkpoint.bin").exists();
        if through {
            break;
        }
        run = coque(&["resume", &path]).spawn().unwrap();
        // The old checkpoint is there until the run has come further: give it a moment to start.
        sleep(Duration::from_millis(40));
    }
    assert!(killed >= 1);
    if !through {
        finished(&run.wait_with_output().unwrap());
    }
    for file in files {
        let [whole, killed] = [&whole, &out].map(|folder| fs::read(folder.join(file)).unwrap());
        assert!(whole == killed, "{file} is another one");
    }
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

#[test]
fn a_run_whose_sharpening_is_interrupted_is_kept_with_its_bars() {
    let roof = |name: &str, error: &str| {
        let out = folder(name);
        let set = ["--set", "geometry.cylinder.particles=[61, 61]", "--set", error];
        let path = out.to_string_lossy().into_owned();
        let arguments = ["run", "scenes/scordelis-lo.toml", "--out", &path].into_iter().chain(set);
        (coque(&arguments.collect::<Vec<_>>()), out)
    };
    let (mut whole, kept) = roof("barred", "error={}");
    finished(&whole.output().unwrap());
    let (mut sharpened, out) = roof("sharpened", "error={ sharpen = true }");
    let mut run = sharpened.spawn().unwrap();
    let mut said = BufReader::new(run.stderr.take().unwrap());
    let mut words = String::new();
    while !words.contains("for the errors: 3 of 3") {
        assert!(said.read_line(&mut words).unwrap() > 0, "{words}");
    }
    signal(&run, "-INT");
    said.read_to_string(&mut words).unwrap();
    // The run itself came to its end.
    assert_eq!(run.wait().unwrap().code(), Some(0), "{words}");
    assert!(words.contains("a run on another lattice was interrupted"), "{words}");
    let curve = |out: &Path| fs::read_to_string(out.join("curve.csv")).unwrap();
    assert!(curve(&out).contains("w_edge ±"));
    assert_eq!(curve(&out), curve(&kept));
}
