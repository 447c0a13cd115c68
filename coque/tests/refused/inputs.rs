//! What no run can be made of is refused before it costs anything: exit code 2, the key or file named, nothing written.

#![cfg(unix)]
#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use coque::{Scene, SceneError};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("inputs").join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

fn coque(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_coque")).args(arguments).current_dir(root()).output().unwrap()
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// Refused with code 2; gives the words.
fn refused(arguments: &[&str]) -> String {
    let output = coque(arguments);
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {}", said(&output));
    said(&output)
}

#[test]
fn pipes_devices_and_folders_are_refused_by_name() {
    let place = folder("endless");
    for name in ["scene.toml", "surface.obj", "surface.vtu"] {
        assert!(Command::new("mkfifo").arg(place.join(name)).status().unwrap().success());
    }
    let at = |name: &str| place.join(name).to_string_lossy().into_owned();
    for command in ["run", "check"] {
        assert!(refused(&[command, &at("scene.toml")]).contains("it is a pipe or a device"));
        assert!(refused(&[command, "/dev/zero"]).contains("/dev/zero: it is a pipe or a device"));
        assert!(refused(&[command, "scenes"]).contains("it is a folder"));
    }
    for name in ["surface.obj", "surface.vtu"] {
        assert!(refused(&["mesh", &at(name)]).contains("it is a pipe or a device"));
    }
    fs::create_dir_all(place.join("run/fields")).unwrap();
    for name in ["run/curve.csv", "run/fields/shell.pvd", "run/checkpoint.bin"] {
        assert!(Command::new("mkfifo").arg(place.join(name)).status().unwrap().success());
    }
    assert!(refused(&["plot", &at("run"), "--curve", "a,b"]).contains("it is a pipe or a device"));
    assert!(refused(&["plot", &at("run")]).contains("it is a pipe or a device"));
    assert!(refused(&["resume", &at("run")]).contains("it is a pipe or a device"));
    let sweep = ["sweep", &at("scene.toml"), "--over", "a=1"];
    assert!(refused(&sweep).contains("it is a pipe or a device"));
}

#[test]
fn more_particles_than_there_is_memory_for_are_refused_with_both_numbers() {
    let out = folder("memory");
    let run = |kilobytes: usize, more: &[&str]| {
        let line = format!("ulimit -v {kilobytes}; exec \"$0\" \"$@\"");
        let out = out.join("run");
        Command::new("bash")
            .args(["-c", &line, env!("CARGO_BIN_EXE_coque"), "run", "scenes/ring.toml"])
            .args(more)
            .arg("--out")
            .arg(&out)
            .current_dir(root())
            // An arena more, which the allocator makes when threads meet, reserves 64 MB of the address space.
            .env("MALLOC_ARENA_MAX", "1")
            .output()
            .unwrap()
    };
    for more in [
        &["--set", "geometry.plate.particles=[3333, 2999]"][..],
        &["--set", "geometry.plate.particles=[601, 601]", "--set", "analysis.static.levels=1"],
        &["--set", "geometry.plate.particles=[401, 401]", "--set", "formulation.nodal.order=3"],
    ] {
        let output = run(1_000_000, more);
        assert_eq!(output.status.code(), Some(2), "{more:?}: {}", said(&output));
        let said = said(&output);
        assert!(
            said.contains("particles, which need about") && said.contains("of memory that are free"),
            "{said}"
        );
    }
    assert!(!out.join("run").exists());
    // More than half: warned of, and run.
    let levels = "analysis.explicit={ transient = { duration = 1e-3, record_every = 1e-3 } }";
    let reported = run(220_000, &["--set", "geometry.plate.particles=[141, 301]", "--set", levels]);
    assert_eq!(reported.status.code(), Some(0), "{}", said(&reported));
    assert!(said(&reported).contains("warning: the run needs about"), "{}", said(&reported));
}

#[test]
fn what_the_scene_asks_for_in_vain_is_bad_input() {
    let out = folder("vain").join("run");
    let out = out.to_string_lossy();
    let hinge = "supports[2]={ on = \"u0v0\", hinged = {} }";
    let run = |replaced: &[&str]| {
        let mut arguments = vec!["run", "scenes/patch-test.toml", "--out", &out, "--set", hinge];
        replaced.iter().for_each(|replaced| arguments.extend(["--set", replaced]));
        refused(&arguments)
    };
    let said = run(&["analysis.explicit={ transient = { duration = 1e30, record_every = 1e29 } }"]);
    assert!(said.contains("duration") && said.contains("1e10 stable steps"), "{said}");
    let said = run(&["analysis.explicit={ transient = { duration = 1.0, record_every = 1e-30 } }"]);
    assert!(said.contains("record_every"), "{said}");
    for analysis in [
        "analysis.linear={}",
        "analysis.static={ levels = 2 }",
        "analysis.arc-length={ radius = 0.1, until = 1.0 }",
        "analysis.modal={ modes = 2 }",
        "analysis.buckling={ modes = 2 }",
        "analysis.explicit={ transient = { duration = 1.0, record_every = 0.1 } }",
        "analysis.explicit={ quasi-static = { levels = 2, period = 1.0 } }",
    ] {
        let said = run(&[analysis, "supports=[{ on = \"all\", clamped = {} }]"]);
        assert!(said.contains("`supports` gives no freedom of any particle"), "{analysis}: {said}");
    }
}

/// The reader of TOML would take the items of a list for the keys of a table in their order.
#[test]
fn lists_are_not_taken_for_tables() {
    let text = fs::read_to_string(root().join("scenes/ring.toml")).unwrap();
    for (path, list) in [
        ("units", "[\"m\", \"N\", \"s\"]"),
        ("geometry.plate", "[[10.0, 1.0], [50, 5]]"),
        ("material.elastic", "[1200.0, 0.0, 1.0]"),
        ("section.homogeneous", "[1.0]"),
        ("supports[0]", "[\"u0\"]"),
        ("supports[0].clamped", "[]"),
        ("loads[0].couple", "[1.0, \"edge\"]"),
        ("loads", "[[\"u1\"]]"),
        ("analysis.explicit.quasi-static", "[[1.0], 2.0]"),
        ("analysis.linear", "[]"),
        ("output.plot", "[\"level\", \"level\"]"),
        ("formulation.nodal", "[1]"),
        ("curve[0]", "[\"a\", \"displacement\", \"u1\", [0.0, 0.0, 1.0]]"),
        ("sets", "{ tip = [[0.0, 0.0, 0.0]] }"),
    ] {
        let pair = [(path.to_string(), list.to_string())];
        match Scene::with_overrides(&text, "ring.toml", &pair) {
            Err(SceneError::Type(fault)) => {
                assert_eq!((&fault.value[..], &fault.bound[..]), ("a list", "a table"), "{path}");
            }
            other => panic!("{path} = {list}: {other:?}"),
        }
    }
}

#[test]
fn a_title_steers_no_terminal() {
    let out = folder("title").join("run");
    let title = "title=\"ring\\u001b]0;owned\\u0007\\u001b[2J\\r\\u009b31m\\u202e\"";
    let arguments = ["--set", title, "--set", "section.homogeneous.thickness=1.0"];
    let path = out.to_string_lossy();
    let steers = |c: char| (c.is_control() && c != '\n' && c != '\t') || c == '\u{202e}';
    let run = coque(&[&["run", "scenes/patch-test.toml", "--out", &path][..], &arguments].concat());
    let check = coque(&[&["check", "scenes/patch-test.toml"][..], &arguments].concat());
    let broken = ["--set", "formulation.nodal.kernel=\"a\\u001b[2J\""];
    let refused = coque(&[&["check", "scenes/patch-test.toml"][..], &broken].concat());
    // Bytes that TOML refuses are shown where they stand.
    let raw = out.with_extension("toml");
    fs::write(&raw, "title = \"a\u{1b}[2Jb\u{202e}\"\n").unwrap();
    let shown = coque(&["check", &raw.to_string_lossy()]);
    for (output, code) in [(run, 0), (check, 0), (refused, 2), (shown, 2)] {
        assert_eq!(output.status.code(), Some(code), "{}", said(&output));
        let text = said(&output) + &String::from_utf8_lossy(&output.stdout);
        assert!(!text.contains(steers), "{text:?}");
    }
    let summary = fs::read_to_string(out.join("summary.json")).unwrap();
    let summary: serde_json::Value = serde_json::from_str(&summary).unwrap();
    assert!(summary["title"].as_str().unwrap().starts_with("ring\u{1b}]0;"), "the title itself is kept");
}
