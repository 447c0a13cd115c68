//! The command under `mpirun`: the files of one process to the byte, and how it ends when one of the processes cannot go on.

#![cfg(target_os = "linux")]
#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// A plate of four chunks, let go under its load.
const PLATE: [&str; 2] = [
    "geometry.plate.particles=[41, 41]",
    "analysis={ explicit = { transient = { duration = 0.02, record_every = 0.002 } } }",
];
/// The same for as long as it is left alone.
const LONG: [&str; 3] = [
    PLATE[0],
    "analysis={ explicit = { transient = { duration = 20.0, record_every = 0.002 } } }",
    "output.checkpoint_every=0.005",
];
/// A plate that takes a second or two.
const SECONDS: [&str; 3] = [
    PLATE[0],
    "analysis={ explicit = { transient = { duration = 0.4, record_every = 0.002 } } }",
    "output.checkpoint_every=0.005",
];

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("mpirun").join(name);
    let _ = fs::remove_dir_all(&folder);
    folder
}

/// A program with the present folder and the environment of its tests.
fn program(name: &str) -> Command {
    let mut command = Command::new(name);
    command
        .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join(".."))
        .env("OMPI_MCA_rmaps_base_oversubscribe", "1")
        .env("OMPI_MCA_mpi_yield_when_idle", "1")
        .env("OMPI_ALLOW_RUN_AS_ROOT", "1")
        .env("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1")
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    command
}

/// `coque run` of the plate with values replaced.
fn run(out: &Path, replaced: &[&str]) -> Vec<String> {
    run_of("scenes/plate.toml", out, replaced)
}

/// The same of any scene.
fn run_of(scene: &str, out: &Path, replaced: &[&str]) -> Vec<String> {
    let start = ["run", scene, "--out", &out.to_string_lossy()].map(str::to_owned);
    start
        .into_iter()
        .chain(replaced.iter().flat_map(|value| ["--set".to_owned(), value.to_string()]))
        .collect()
}

fn resume(out: &Path) -> Vec<String> {
    vec!["resume".into(), out.to_string_lossy().into_owned()]
}

/// The command by so many processes; zero starts it without a launcher.
fn coque(processes: usize, arguments: &[String]) -> Command {
    let path = env!("CARGO_BIN_EXE_coque-mpi");
    let mut command = program(if processes == 0 { path } else { "mpirun" });
    if processes > 0 {
        command.args(["-n", &processes.to_string(), path]);
    }
    command.args(arguments);
    command
}

/// How it ended and what it said; it has three minutes, on however loaded a machine.
fn ended(mut child: Child, what: &str) -> (ExitStatus, String) {
    let begun = Instant::now();
    let status = loop {
        if let Some(status) = child.try_wait().unwrap() {
            break status;
        }
        if begun.elapsed() > Duration::from_secs(180) {
            let _ = child.kill();
            panic!("{what}: still there after three minutes");
        }
        sleep(Duration::from_millis(5));
    };
    let mut said = String::new();
    child.stdout.take().unwrap().read_to_string(&mut said).unwrap();
    child.stderr.take().unwrap().read_to_string(&mut said).unwrap();
    (status, said)
}

fn done(processes: usize, arguments: &[String]) {
    let (status, said) = ended(coque(processes, arguments).spawn().unwrap(), "a run");
    assert_eq!(status.code(), Some(0), "{processes} processes: {said}");
}

/// Waits until a run under way has written a checkpoint.
fn begun(run: &mut Child, out: &Path) {
    for _ in 0..18_000 {
        if out.join("checkpoint.bin").exists() {
            return;
        }
        assert!(run.try_wait().unwrap().is_none(), "the run ended without a checkpoint");
        sleep(Duration::from_millis(10));
    }
    panic!("no checkpoint within three minutes");
}

/// Files under a folder with their bytes, but for those that hold wall times.
fn files(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).unwrap().map(Result::unwrap) {
        let (path, name) = (entry.path(), entry.file_name().to_string_lossy().into_owned());
        if path.is_dir() {
            found.extend(files(&path).into_iter().map(|(inner, bytes)| (format!("{name}/{inner}"), bytes)));
        } else if name != "summary.json" && name != "scene.toml" {
            found.push((name, fs::read(&path).unwrap()));
        }
    }
    found.sort();
    found
}

/// The summary without wall times and what tells how many ran it, each with a plan of its own.
fn summary(folder: &Path) -> serde_json::Value {
    let text = fs::read_to_string(folder.join("summary.json")).unwrap();
    let mut summary: serde_json::Value = serde_json::from_str(&text).unwrap();
    for varies in ["wall_seconds", "particle_steps_per_second", "bytes_per_particle", "threads", "ranks"] {
        summary.as_object_mut().unwrap().remove(varies);
    }
    summary
}

/// Shells by any number of processes, bonds that break and a fluid by three.
#[test]
fn the_folder_is_that_of_one_process() {
    let glass = [
        "bodies.glass.solid.geometry.block.spacing=2e-3",
        "analysis.explicit.transient.record_every=5e-6",
        "output.fields={ every = 2 }",
    ];
    let water = ["analysis.explicit.transient.duration=0.05", "output.fields={ every = 2 }"];
    for (scene, replaced, numbers) in [
        (
            "plate",
            &[PLATE[0], PLATE[1], "output.fields={ stresses = true }"][..],
            &[(1, "1"), (2, "2"), (3, "1"), (4, "1"), (7, "1")][..],
        ),
        ("crack-branching", &glass, &[(3, "1")]),
        ("dam-break", &water, &[(3, "1")]),
    ] {
        let file = format!("scenes/{scene}.toml");
        let alone = folder(&format!("{scene}-alone"));
        done(0, &run_of(&file, &alone, replaced));
        let expected = files(&alone);
        assert!(expected.len() > 5, "{:?}", expected.iter().map(|(name, _)| name).collect::<Vec<_>>());
        for &(processes, threads) in numbers {
            let out = folder(&format!("{scene}-{processes}"));
            let mut arguments = run_of(&file, &out, replaced);
            arguments.extend(["--threads".into(), threads.into()]);
            done(processes, &arguments);
            let found = files(&out);
            assert_eq!(found.len(), expected.len());
            for ((name, bytes), (other, expected)) in found.iter().zip(&expected) {
                assert_eq!(name, other);
                assert!(bytes == expected, "{name} of {processes} processes");
            }
            assert_eq!(summary(&out), summary(&alone), "{scene}, {processes} processes");
        }
    }
}

/// Killed at some moment, each time another process of three; gone on with by two, by three, alone: the curve of a run that nothing stopped.
#[test]
fn killed_it_goes_on_with_another_number_of_processes() {
    let whole = folder("whole");
    done(0, &run(&whole, &SECONDS));
    let out = folder("killed");
    let mut arguments = run(&out, &SECONDS);
    for (turn, processes) in [3, 2, 3, 4].into_iter().enumerate() {
        let mut child = coque(processes, &arguments).spawn().unwrap();
        begun(&mut child, &out);
        sleep(Duration::from_millis(100 + 90 * turn as u64));
        let killed = killed(&child, turn % processes);
        let (status, said) = ended(child, "a process was killed");
        if !killed || status.success() {
            println!("turn {turn}: over before it was killed");
            break;
        }
        println!("turn {turn}: {status}");
        assert!(!said.contains("panicked"), "{said}");
        arguments = resume(&out);
    }
    if out.join("checkpoint.bin").exists() {
        done(0, &resume(&out));
    }
    assert!(files(&out) == files(&whole), "files differ");
    assert_eq!(summary(&out), summary(&whole));
}

/// The number that the system gives to one of the processes of a launcher; none if there is none any more.
fn process(launcher: &Child, number: usize) -> Option<String> {
    let of_thread =
        |thread: fs::DirEntry| fs::read_to_string(thread.path().join("children")).unwrap_or_default();
    let threads = fs::read_dir(format!("/proc/{}/task", launcher.id())).ok()?.filter_map(Result::ok);
    let children = threads.map(of_thread).collect::<String>();
    children.split_whitespace().nth(number).map(str::to_owned)
}

/// Kills one of the processes of a launcher; false if there is none any more.
fn killed(launcher: &Child, number: usize) -> bool {
    process(launcher, number)
        .is_some_and(|id| Command::new("kill").args(["-9", &id]).status().unwrap().success())
}

/// Asked of one of them, the first or another. (A launcher that is asked waits for a second, then kills.)
#[test]
fn ended_by_a_signal_the_results_so_far_are_kept() {
    for (name, number) in [("-INT", 0), ("-TERM", 2)] {
        let out = folder(&format!("ended{name}"));
        let mut child = coque(3, &run(&out, &LONG)).spawn().unwrap();
        begun(&mut child, &out);
        let id = process(&child, number).unwrap();
        assert!(Command::new("kill").args([name, &id]).status().unwrap().success());
        let (status, said) = ended(child, name);
        assert!(!status.success(), "{said}");
        let summary =
            fs::read_to_string(out.join("summary.json")).unwrap_or_else(|_| panic!("{name}: {said}"));
        assert!(summary.contains("interrupted at time "), "{summary}");
        assert!(out.join("checkpoint.bin").exists());
    }
}

/// What befalls one of them is said once, with its number, and ends all.
#[test]
fn who_cannot_begin_ends_all() {
    let path = env!("CARGO_BIN_EXE_coque-mpi");
    let out = folder("none");
    let other = folder("other");
    fs::create_dir_all(&other).unwrap();
    fs::copy(Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes/ring.toml"), other.join("plate.toml"))
        .unwrap();
    let [out, other] = [out, other.join("plate.toml")].map(|path| path.to_string_lossy().into_owned());
    for (second, said) in [
        ("scenes/missing.toml", "rank 1: cannot read scenes/missing.toml"),
        (&other, "the processes do not have the same scene"),
    ] {
        let mut command = program("mpirun");
        command.args(["-n", "1", path, "run", "scenes/plate.toml", "--out", &out]);
        command.args(["--set", PLATE[0], "--set", PLATE[1]]);
        command.args([":", "-n", "1", path, "run", second, "--out", &out]);
        if second == other {
            command.args(["--set", PLATE[0], "--set", PLATE[1]]);
        }
        let (status, all) = ended(command.spawn().unwrap(), said);
        assert_eq!(status.code(), Some(2), "{all}");
        assert_eq!(all.matches(said).count(), 1, "{all}");
        assert!(!Path::new(&out).join("curve.csv").exists());
    }
    let (status, all) =
        ended(coque(3, &["run".into(), "scenes/scordelis-lo.toml".into()]).spawn().unwrap(), "statics");
    assert_eq!(status.code(), Some(2), "{all}");
    assert_eq!(
        all.matches("[analysis.linear] runs in one process, but 3 were started together").count(),
        1,
        "{all}"
    );
}

/// A scene that reads a mesh of its own folder, and another one in another folder.
#[test]
fn those_who_read_other_meshes_are_refused() {
    let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes/meshes");
    let (out, path) = (folder("meshes-out"), env!("CARGO_BIN_EXE_coque-mpi"));
    let folders = ["one", "two"].map(|name| folder(&format!("meshes-{name}")));
    let mesh = fs::read_to_string(scenes.join("roof.msh")).unwrap();
    let moved = mesh.replace("\n5 0 101.6 2540\n", "\n5 0 101.7 2540\n");
    assert_ne!(mesh, moved);
    for (folder, mesh) in folders.iter().zip([mesh, moved]) {
        fs::create_dir_all(folder).unwrap();
        fs::copy(scenes.join("roof.toml"), folder.join("roof.toml")).unwrap();
        fs::write(folder.join("roof.msh"), mesh).unwrap();
    }
    fs::create_dir_all(&out).unwrap();
    fs::write(out.join("curve.csv"), "what was found before").unwrap();
    let mut command = program("mpirun");
    for (number, folder) in folders.iter().enumerate() {
        command.args(if number == 0 { &[][..] } else { &[":"] }).args(["-n", "1", path, "run"]);
        command.arg(folder.join("roof.toml")).arg("--out").arg(&out);
        command.args(["--set", "analysis={ explicit = { quasi-static = { levels = [0.1] } } }"]);
    }
    let (status, said) = ended(command.spawn().unwrap(), "other meshes");
    assert_eq!(status.code(), Some(2), "{said}");
    assert_eq!(said.matches("the processes do not have the same mesh").count(), 1, "{said}");
    assert_eq!(fs::read_to_string(out.join("curve.csv")).unwrap(), "what was found before");
}

/// A launcher says three, and the library knows of none but this one.
#[test]
fn the_launcher_of_another_library_is_refused() {
    let mut command = coque(0, &run(&folder("other-launcher"), &PLATE));
    command.env("OMPI_COMM_WORLD_SIZE", "3").env("OMPI_COMM_WORLD_RANK", "0");
    let (status, said) = ended(command.spawn().unwrap(), "another launcher");
    assert_eq!(status.code(), Some(2), "{said}");
    assert!(said.contains("the launcher started 3 processes (OMPI_COMM_WORLD_SIZE)"), "{said}");
    assert!(said.contains("finds 1"), "{said}");
}

/// The first process cannot write its frames any more: all end, with the words of one process alone.
#[test]
fn frames_that_cannot_be_written_end_all() {
    for processes in [0, 3] {
        let out = folder(&format!("full-{processes}"));
        let fields = out.join("fields");
        let arguments = run(&out, &[LONG[0], LONG[1], "output.fields={ stresses = true }"]);
        let mut child = coque(processes, &arguments).spawn().unwrap();
        for _ in 0..18_000 {
            if fields.join("shell-0003.vtu").exists() {
                break;
            }
            assert!(child.try_wait().unwrap().is_none(), "it ended before its third frame");
            sleep(Duration::from_millis(10));
        }
        // Its folder goes, and a file stands in the way of another.
        fs::rename(&fields, out.join("away")).unwrap();
        fs::write(&fields, "").unwrap();
        let (status, said) = ended(child, "frames");
        assert_eq!(status.code(), Some(2), "{said}");
        assert_eq!(said.matches("fields").count(), 1, "{said}");
        println!("{said}");
        assert!(fs::read_to_string(out.join("summary.json")).unwrap().contains("fields"), "{said}");
    }
}
