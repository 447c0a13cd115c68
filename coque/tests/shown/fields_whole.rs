//! Fields out: only whole files are ever listed, however a run ends; what the command says of it.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::common::fields::{EVERYTHING, HINGE, Read, folder, listed, names, run, scene};
use coque::scene::Fields;
use coque::{Ended, Failure, FieldError, FieldFiles, FieldSink, Frame, RunOptions, Silent};

/// Looks at the folder after each frame, and cannot go on after some.
struct Looking {
    files: FieldFiles,
    folder: PathBuf,
    taken: usize,
    most: usize,
}

impl FieldSink for Looking {
    fn frame(&mut self, frame: &Frame<'_>) -> Result<(), FieldError> {
        if self.taken == self.most {
            // In the place of the next frame stands what no file can replace.
            fs::create_dir_all(self.folder.join(format!("shell-{:04}.vtu", self.taken))).unwrap();
        }
        self.files.frame(frame)?;
        self.taken += 1;
        check_whole(&self.folder, self.taken);
        Ok(())
    }
}

/// Whatever was killed: so many frames are listed, all of them whole, and nothing else lies about.
fn check_whole(folder: &Path, frames: usize) {
    let list = listed(&folder.join("shell.pvd"));
    assert_eq!(list.len(), frames);
    for (_, path) in &list {
        Read::new(path);
    }
    let files = names(folder).into_iter().filter(|name| folder.join(name).is_file());
    assert_eq!(files.count(), frames + 1);
}

#[test]
fn a_run_that_ends_early_leaves_whole_frames_and_a_list_of_them() {
    let replaced = [("geometry.cylinder.particles", "[7, 7]"), ("analysis.static.levels", "6")];
    let scene = scene("panel.toml", &replaced);
    for most in [1, 3] {
        let folder = folder("early");
        let wanted = Fields { extruded: false, ..EVERYTHING };
        let files = FieldFiles::create(&folder, FieldFiles::LONE, &wanted).unwrap();
        let mut sink = Looking { files, folder: folder.clone(), taken: 0, most };
        let outcome = run(&scene, &mut sink);
        let Ended::Diverged(Failure::Fields(error)) = &outcome.ended else { panic!("{:?}", outcome.ended) };
        assert!(error.path.ends_with(&format!("shell-{most:04}.vtu")), "{error}");
        assert_eq!(outcome.summary.record.frames as usize, most);
        // The curve holds the frame's own row as well: it was found before it was written.
        assert_eq!(outcome.curve.rows.len(), most + 1);
        check_whole(&folder, most);
        drop(sink);
        check_whole(&folder, most);
    }
}

/// The program itself, killed while it writes: at most the frame under way is half, and that under another name.
#[test]
fn a_killed_program_leaves_whole_frames_and_a_list_of_them() {
    let out = folder("killed");
    for frames in [1, 4, 9] {
        let mut child = Command::new(env!("CARGO_BIN_EXE_coque"))
            .args(["run", "scenes/patch-test.toml", "--set", &format!("{}={}", HINGE.0, HINGE.1)])
            .args(["--set", "analysis.explicit={ transient = { duration = 1e4, record_every = 1e-3 } }"])
            .args(["--set", "output.fields={ stresses = true }", "--out"])
            .arg(&out)
            .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join(".."))
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        let list = out.join("fields/shell.pvd");
        while !list.exists() || listed(&list).len() < frames {
            assert!(child.try_wait().unwrap().is_none(), "the run ended before it could be killed");
            std::thread::yield_now();
        }
        child.kill().unwrap();
        child.wait().unwrap();
        let listed = listed(&list);
        assert!(listed.len() >= frames);
        for (_, path) in &listed {
            Read::new(path);
        }
        let whole = names(&out.join("fields")).into_iter().filter(|name| name.ends_with(".vtu")).count();
        // The list follows its frame.
        assert!(
            whole == listed.len() || whole == listed.len() + 1,
            "{whole} frames, {} listed",
            listed.len()
        );
        fs::remove_dir_all(&out).unwrap();
    }
}

/// Two threads write sheet and body at once, one thread one after the other.
#[test]
fn any_number_of_threads_writes_the_same_files() {
    let replaced = [("geometry.cylinder.particles", "[7, 7]"), ("analysis.static.levels", "2")];
    let scene = scene("panel.toml", &replaced);
    let written = [1, 2].map(|threads| {
        let folder = folder(&format!("threads-{threads}"));
        let mut files = FieldFiles::create(&folder, FieldFiles::LONE, &EVERYTHING).unwrap();
        let options =
            RunOptions { progress: &mut Silent, checkpoints: None, fields: Some(&mut files), from: None };
        assert_eq!(scene.build(threads).unwrap().run_with(options).unwrap().ended, Ended::Done);
        names(&folder).into_iter().map(|name| fs::read(folder.join(name)).unwrap()).collect::<Vec<_>>()
    });
    assert_eq!(written[0].len(), 2 * (3 + 1));
    assert!(written[0] == written[1]);
}

#[test]
fn a_second_run_leaves_nothing_of_the_first() {
    let folder = folder("again");
    let scene = scene("patch-test.toml", &[HINGE, ("analysis.static.levels", "5")]);
    run(&scene, &mut FieldFiles::create(&folder, FieldFiles::LONE, &EVERYTHING).unwrap());
    fs::write(folder.join("shell-0001.vtu.part"), "half").unwrap();
    fs::write(folder.join("shell-notes.vtu"), "mine").unwrap();
    let wanted = Fields { every: 5, ..Fields::MOTION };
    let mut files = FieldFiles::create(&folder, FieldFiles::LONE, &wanted).unwrap();
    assert_eq!(names(&folder), ["shell-notes.vtu"]);
    run(&self::scene("patch-test.toml", &[HINGE, ("analysis.static.levels", "1")]), &mut files);
    assert_eq!(names(&folder), ["shell-0000.vtu", "shell-0001.vtu", "shell-notes.vtu", "shell.pvd"]);
}

#[test]
fn the_command_writes_fields_and_says_when_it_cannot() {
    let out = folder("command");
    let coque = |arguments: &[&str]| {
        Command::new(env!("CARGO_BIN_EXE_coque"))
            .args(["run", "scenes/patch-test.toml", "--set", "analysis.static.levels=2"])
            .args(["--set", &format!("{}={}", HINGE.0, HINGE.1), "--out"])
            .arg(&out)
            .args(arguments)
            .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join(".."))
            .output()
            .unwrap()
    };
    let done = coque(&[]);
    assert_eq!(done.status.code(), Some(0));
    assert!(!out.join("fields").exists(), "a scene without fields writes none");
    let fields = ["--set", "output.fields={ extruded = true }"];
    assert_eq!(coque(&fields).status.code(), Some(0));
    assert_eq!(listed(&out.join("fields/shell.pvd")).len(), 3);
    assert_eq!(listed(&out.join("fields/solid.pvd")).len(), 3);

    fs::remove_dir_all(&out).unwrap();
    fs::create_dir_all(out.join("fields/shell-0001.vtu")).unwrap();
    let stopped = coque(&fields);
    let message = String::from_utf8_lossy(&stopped.stderr).into_owned();
    assert_eq!(stopped.status.code(), Some(2), "{message}");
    assert!(message.contains("shell-0001.vtu") && message.contains("the curve so far is in"), "{message}");
    assert_eq!(fs::read_to_string(out.join("curve.csv")).unwrap().lines().count(), 3);
    let summary = fs::read_to_string(out.join("summary.json")).unwrap();
    assert_eq!(serde_json::from_str::<serde_json::Value>(&summary).unwrap()["frames"], 1);
}

#[test]
fn the_command_draws_a_frame_without_a_viewer() {
    let out = folder("plot");
    let coque = |arguments: &[&str]| {
        Command::new(env!("CARGO_BIN_EXE_coque"))
            .args(arguments)
            .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join(".."))
            .output()
            .unwrap()
    };
    let place = out.to_string_lossy().into_owned();
    let nothing = coque(&["plot", &place]);
    assert_eq!(nothing.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&nothing.stderr).contains("run the scene again with [output.fields]"));

    let scene = ["run", "scenes/panel.toml", "--set", "analysis.static.levels=2", "--set"];
    let run = [&scene[..], &["output.fields={ stresses = true }", "--out", &place]].concat();
    assert_eq!(coque(&run).status.code(), Some(0));
    assert_eq!(coque(&["plot", &place]).status.code(), Some(0));
    let svg = fs::read_to_string(out.join("shape.svg")).unwrap();
    let document = roxmltree::Document::parse(&svg).unwrap();
    let cells = document.descendants().find(|node| node.attribute("class") == Some("cells")).unwrap();
    assert_eq!(cells.children().filter(|node| node.is_element()).count(), 400);
    assert!(svg.contains(">[N/mm²]<"));
    assert!(svg.contains(">von_mises_top<") && svg.contains("quarter model<") && svg.contains(">level 1<"));

    let picture = out.join("first.svg");
    let more = ["--frame", "0", "--field", "displacement.z", "--view", "-30,20", "--out"];
    assert_eq!(
        coque(&[&["plot", &place][..], &more, &[&picture.to_string_lossy()]].concat()).status.code(),
        Some(0)
    );
    assert!(fs::read_to_string(&picture).unwrap().contains(">level 0<"));
    assert_eq!(coque(&["plot", &place, "--curve", "w_crown,w_edge"]).status.code(), Some(0));
    assert!(fs::read_to_string(out.join("curve.svg")).unwrap().contains("w_edge [mm]"));
    let refusals = [
        (["--frame", "3"], "it lists 3, from 0 on"),
        (["--field", "von_mises"], "did you mean"),
        (["--mirror", "x,w"], "write some of x, y and z"),
        (["--scale", "many"], "write a number from 0 on"),
        (["--curve", "w_crown,W"], "the curve has no column `W`"),
    ];
    for (wrong, said) in refusals {
        let refused = coque(&[&["plot", &place][..], &wrong].concat());
        let message = String::from_utf8_lossy(&refused.stderr).into_owned();
        assert_eq!(refused.status.code(), Some(2));
        assert!(message.contains(said), "{message}");
    }
}
