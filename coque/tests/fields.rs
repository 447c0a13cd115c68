//! Fields out: what a frame holds, in which order frames come, and that only whole files are ever listed.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use coque::scene::Fields;
use coque::{
    Ended, Failure, FieldError, FieldFiles, FieldSink, Frame, Outcome, RunOptions, Scene, Silent, State,
};
use sph_core::{Cell, Cloud, Vec3};

const EVERYTHING: Fields = Fields { every: 1, extruded: true, stresses: true };

fn scene(name: &str, replaced: &[(&str, &str)]) -> Scene {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes").join(name);
    let pairs: Vec<_> = replaced.iter().map(|(path, value)| (path.to_string(), value.to_string())).collect();
    Scene::with_overrides(&fs::read_to_string(path).unwrap(), name, &pairs).unwrap()
}

/// Holds the sheet of the patch test without time, where a motion of nought would drive it.
const HINGE: (&str, &str) = ("supports[2]", "{ on = \"u0v0\", hinged = {} }");

/// An empty folder of a test's own.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("fields").join(name);
    if folder.exists() {
        fs::remove_dir_all(&folder).unwrap();
    }
    folder
}

fn run(scene: &Scene, sink: &mut dyn FieldSink) -> Outcome {
    let options = RunOptions { progress: &mut Silent, checkpoints: None, fields: Some(sink), from: None };
    scene.build(1).unwrap().run_with(options).unwrap()
}

/// A file read back: numbers by name, and where the array stood.
struct Read {
    arrays: BTreeMap<String, (String, Vec<f64>)>,
}

impl Read {
    fn new(path: &Path) -> Self {
        let text = fs::read_to_string(path).unwrap();
        let document = roxmltree::Document::parse(&text).unwrap();
        let root = document.root_element();
        assert_eq!(root.attribute("version"), Some("1.0"));
        assert_eq!(root.attribute("header_type"), Some("UInt64"));
        assert_eq!(root.attribute("byte_order"), Some("LittleEndian"));
        let mut arrays = BTreeMap::new();
        for node in document.descendants().filter(|node| node.has_tag_name("DataArray")) {
            let bytes = STANDARD.decode(node.text().unwrap().trim()).unwrap();
            let (length, data) = bytes.split_at(8);
            assert_eq!(u64::from_le_bytes(length.try_into().unwrap()) as usize, data.len());
            let numbers: Vec<f64> = match node.attribute("type").unwrap() {
                "Float64" => {
                    data.chunks_exact(8).map(|b| f64::from_le_bytes(b.try_into().unwrap())).collect()
                }
                "Float32" => data
                    .chunks_exact(4)
                    .map(|b| f64::from(f32::from_le_bytes(b.try_into().unwrap())))
                    .collect(),
                "Int32" => data
                    .chunks_exact(4)
                    .map(|b| f64::from(i32::from_le_bytes(b.try_into().unwrap())))
                    .collect(),
                "UInt8" => data.iter().map(|&b| f64::from(b)).collect(),
                other => panic!("{other}"),
            };
            let place = node.parent_element().unwrap().tag_name().name().to_string();
            arrays.insert(node.attribute("Name").unwrap().to_string(), (place, numbers));
        }
        let piece = document.descendants().find(|node| node.has_tag_name("Piece")).unwrap();
        let count = |name: &str| piece.attribute(name).unwrap().parse::<usize>().unwrap();
        let read = Self { arrays };
        assert_eq!(read.get("Points").len(), 3 * count("NumberOfPoints"));
        assert_eq!(read.get("offsets").len(), count("NumberOfCells"));
        assert_eq!(read.get("types").len(), count("NumberOfCells"));
        assert_eq!(read.get("offsets").last().copied(), Some(read.get("connectivity").len() as f64));
        read
    }

    fn get(&self, name: &str) -> &[f64] {
        &self.arrays[name].1
    }

    fn place(&self, name: &str) -> Option<&str> {
        self.arrays.get(name).map(|(place, _)| place.as_str())
    }

    /// Corners of a cell, as points.
    fn corners(&self, cell: usize) -> Vec<Vec3> {
        let offset = |c: usize| self.get("offsets")[c] as usize;
        let first = if cell == 0 { 0 } else { offset(cell - 1) };
        let points = self.get("Points");
        let at = |i: f64| Vec3::from_column_slice(&points[3 * i as usize..3 * i as usize + 3]);
        self.get("connectivity")[first..offset(cell)].iter().map(|&i| at(i)).collect()
    }
}

/// Files and values of a `.pvd`.
fn listed(list: &Path) -> Vec<(f64, PathBuf)> {
    let text = fs::read_to_string(list).unwrap();
    let document = roxmltree::Document::parse(&text).unwrap();
    assert_eq!(document.root_element().attribute("type"), Some("Collection"));
    let sets = document.descendants().filter(|node| node.has_tag_name("DataSet"));
    sets.map(|set| {
        let file = list.parent().unwrap().join(set.attribute("file").unwrap());
        (set.attribute("timestep").unwrap().parse().unwrap(), file)
    })
    .collect()
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let mut names: Vec<_> = entries.map(|e| e.unwrap().file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

/// Uniform tension F on a sheet b wide: every cell carries N = F/b along x, the faces σ = F/(bt), whatever its frame.
#[test]
fn a_frame_of_the_patch_test_reads_back() {
    let folder = folder("patch");
    let scene = scene("patch-test.toml", &[]);
    let outcome = run(&scene, &mut FieldFiles::create(&folder, &EVERYTHING).unwrap());
    assert_eq!((outcome.ended, outcome.summary.frames), (Ended::Done, 2));
    let frames = listed(&folder.join("shell.pvd"));
    assert_eq!(frames.iter().map(|frame| frame.0).collect::<Vec<_>>(), [0.0, 1.0]);
    let read = Read::new(&frames[1].1);
    assert_eq!((read.get("TimeValue"), read.get("level")), (&[1.0][..], &[1.0][..]));
    // Positions to the last bit.
    let positions: Vec<u64> =
        outcome.shapes[1].positions.iter().flat_map(|x| [x.x, x.y, x.z]).map(f64::to_bits).collect();
    assert_eq!(read.get("Points").iter().map(|x| x.to_bits()).collect::<Vec<_>>(), positions);
    let first = Read::new(&frames[0].1);
    assert!(first.get("displacement").iter().all(|&u| u == 0.0));
    for (i, u) in read.get("displacement").iter().enumerate() {
        assert_eq!(*u, read.get("Points")[i] - first.get("Points")[i]);
    }
    // The mean of the end, as in the curve: the particles of the last column of the lattice.
    let end: Vec<usize> = (0..45).filter(|a| (first.get("Points")[3 * a] - 2.0).abs() < 1e-12).collect();
    let mean = end.iter().map(|a| read.get("displacement")[3 * a]).sum::<f64>() / end.len() as f64;
    assert_eq!(end.len(), 5);
    assert!((mean / outcome.curve.column("U_end").unwrap()[1] - 1.0).abs() < 1e-12);
    // Velocities have died, reactions add up to the load and stand on the held edges only.
    assert!(read.get("velocity").iter().all(|v| v.abs() < 1e-6));
    let reaction: f64 = (0..45).map(|a| read.get("reaction")[3 * a]).sum();
    // What has not settled: tolerance 1e-14 of the energy is 1e-7 of the load.
    assert!((reaction / -1e-3 - 1.0).abs() < 1e-5, "{reaction}");
    assert!((0..45).all(|a| {
        let x = &first.get("Points")[3 * a..3 * a + 2];
        x[0] == 0.0 || x[1] == 0.0 || read.get("reaction")[3 * a..3 * a + 3] == [0.0; 3]
    }));
    assert!(read.get("thickness").iter().all(|&t| t == 0.1));
    assert_eq!(read.place("membrane_force"), Some("CellData"));
    for name in ["von_mises_top", "von_mises_bottom"] {
        // The strain of 1e-5 is what small strain leaves out; bending of the flat sheet is nought.
        assert!(read.get(name).iter().all(|s| (s / 1e-2 - 1.0).abs() < 5e-5), "{name}: {:?}", read.get(name));
    }
    for cell in 0..32 {
        let t1 = &read.get("t1")[3 * cell..3 * cell + 3];
        let (cos, sin) = (t1[0], t1[1]);
        let found = &read.get("membrane_force")[3 * cell..3 * cell + 3];
        for (n, expected) in found.iter().zip([cos * cos, sin * sin, -cos * sin]) {
            assert!((n - 1e-3 * expected).abs() < 5e-8, "{found:?}");
        }
    }
}

/// A folded sheet of a quadrangle and two triangles, thick: its body has volume area × thickness, all cells upright.
#[test]
fn the_extruded_shell_has_the_volume_of_the_shell() {
    let (t, folder) = (0.2, folder("solid"));
    let positions = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [2.0, 0.0], [2.0, 1.0]];
    let positions = positions.map(|[x, y]| Vec3::new(x, y, 0.0)).to_vec();
    let cells = vec![Cell::quadrangle([0, 1, 2, 3]), Cell::triangle([1, 4, 2]), Cell::triangle([4, 5, 2])];
    let material = shell_kinematics::Isotropic::new(10.0, 0.3).unwrap();
    let shell = sph_shell::Shell::new(sph_shell::Parts {
        cloud: Cloud::from_cells(positions, None, cells).unwrap(),
        section: Box::new(shell_kinematics::IsotropicSection::new(material, t).unwrap()),
        strain: &shell_kinematics::StretchCorrected,
        material_axis: None,
        density: 1.0,
        formulation: sph_shell::Formulation::StressPoint(sph_shell::Reach::Cell),
        supports: Vec::new(),
        loads: Vec::new(),
        threads: 1,
    })
    .unwrap();
    let frame = Frame {
        shell: &shell,
        state: State::Balance,
        along: 0.0,
        level: 0.0,
        driven: None,
        homogeneous: true,
        units: coque::Units {
            length: coque::Length::Metre,
            force: coque::Force::Newton,
            time: coque::Time::Second,
        },
    };
    FieldFiles::create(&folder, &EVERYTHING).unwrap().frame(&frame).unwrap();
    let flat = Read::new(&folder.join("shell-0000.vtu"));
    assert_eq!(flat.get("types"), [9.0, 5.0, 5.0]);
    assert_eq!(flat.get("offsets"), [4.0, 7.0, 10.0]);
    let solid = Read::new(&folder.join("solid-0000.vtu"));
    assert_eq!(solid.get("types"), [12.0, 13.0, 13.0]);
    let volumes: Vec<f64> = (0..3)
        .map(|cell| {
            let x = solid.corners(cell);
            let n = x.len() / 2;
            let area = (1..n - 1).map(|i| 0.5 * (x[i] - x[0]).cross(&(x[i + 1] - x[0]))).sum::<Vec3>();
            area.dot(&(x[n] - x[0]))
        })
        .collect();
    for (found, area) in volumes.iter().zip([1.0, 0.5, 0.5]) {
        assert!((found - area * t).abs() < 1e-15, "{volumes:?}");
    }
}

/// Notes what it is offered.
#[derive(Default)]
struct Noted(Vec<(State, f64, f64)>);

impl FieldSink for Noted {
    fn frame(&mut self, frame: &Frame<'_>) -> Result<(), FieldError> {
        self.0.push((frame.state, frame.along, frame.level));
        Ok(())
    }
}

#[test]
fn frames_come_at_levels_records_points_and_modes() {
    let noted = |name: &str, replaced: &[(&str, &str)]| {
        let mut sink = Noted::default();
        let outcome = run(&scene(name, replaced), &mut sink);
        assert_eq!(outcome.summary.frames as usize, sink.0.len());
        (sink.0, outcome)
    };
    let every = ("output.fields", "{ every = 2 }");
    let coarse = ("geometry.cylinder.particles", "[7, 7]");
    let (frames, _) = noted("panel.toml", &[coarse, ("analysis.static.levels", "4"), every]);
    assert_eq!(frames, [0.0, 0.5, 1.0].map(|level| (State::Balance, level, level)));

    let path = "{ radius = 0.02, stop = { column = \"w_crown\", above = 8.0 } }";
    let (frames, outcome) = noted("panel.toml", &[coarse, ("analysis.arc-length", path)]);
    let levels = outcome.curve.column("level").unwrap();
    assert!(levels.len() > 4);
    let points: Vec<_> =
        levels.iter().enumerate().map(|(i, &level)| (State::Balance, i as f64, level)).collect();
    assert_eq!(frames, points);

    let run = "{ transient = { duration = 0.05, record_every = 0.01 } }";
    let (frames, outcome) = noted("patch-test.toml", &[HINGE, ("analysis.explicit", run), every]);
    let times = outcome.curve.column("time").unwrap();
    assert_eq!(frames, [0, 2, 4].map(|i| (State::Moving, times[i], 1.0)));

    let (frames, outcome) = noted("panel.toml", &[coarse, ("analysis.modal.modes", "3")]);
    let frequencies = outcome.curve.column("frequency").unwrap();
    let modes: Vec<_> = (0..3).map(|i| (State::Mode, i as f64 + 1.0, frequencies[i])).collect();
    assert_eq!(frames, modes);
}

#[test]
fn a_mode_shows_its_shape_and_claims_no_stress() {
    let folder = folder("modes");
    let replaced = [
        ("geometry.cylinder.particles", "[7, 7]"),
        ("analysis.modal.modes", "2"),
        ("output.fields", "{ stresses = true }"),
    ];
    let scene = scene("panel.toml", &replaced);
    let outcome = run(&scene, &mut FieldFiles::create(&folder, &scene.output.fields.unwrap()).unwrap());
    assert!(outcome.summary.left_out.iter().any(|line| line.contains("stresses of modes")));
    for (frame, shape) in listed(&folder.join("shell.pvd")).iter().zip(&outcome.shapes) {
        let read = Read::new(&frame.1);
        for (x, expected) in
            read.get("Points").iter().zip(shape.positions.iter().flat_map(|x| [x.x, x.y, x.z]))
        {
            // Positions of size 2540: the shape is scaled before or after it is added.
            assert!((x - expected).abs() < 1e-11);
        }
        for name in ["velocity", "reaction", "t1", "moment", "von_mises_top"] {
            assert_eq!(read.place(name), None, "{name}");
        }
    }
    assert_eq!(names(&folder), ["shell-0000.vtu", "shell-0001.vtu", "shell.pvd"]);
}

#[test]
fn nodal_stresses_stand_at_the_particles() {
    let folder = folder("nodal");
    let replaced = [HINGE, ("formulation", "{ nodal = {} }"), ("analysis.static.levels", "1")];
    let scene = scene("patch-test.toml", &replaced);
    let outcome = run(&scene, &mut FieldFiles::create(&folder, &EVERYTHING).unwrap());
    assert_eq!(outcome.ended, Ended::Done);
    let read = Read::new(&folder.join("shell-0001.vtu"));
    assert_eq!(read.place("moment"), Some("PointData"));
    assert!(read.get("von_mises_top").iter().all(|s| (s / 1e-2 - 1.0).abs() < 5e-5));
    let solid = Read::new(&folder.join("solid-0001.vtu"));
    assert_eq!((solid.place("von_mises_top"), solid.get("von_mises_top").len()), (Some("PointData"), 90));
}

/// The reaction of the motion that drives a path is that of the curve.
#[test]
fn reactions_are_those_of_the_curve() {
    let folder = folder("reactions");
    let replaced = [("geometry.cylinder.particles", "[7, 7]"), ("analysis.static.levels", "3")];
    let scene = scene("panel.toml", &replaced);
    let outcome = run(&scene, &mut FieldFiles::create(&folder, &EVERYTHING).unwrap());
    let loads = outcome.curve.column("P").unwrap();
    for ((_, path), load) in listed(&folder.join("shell.pvd")).iter().zip(loads) {
        let read = Read::new(path);
        // The crown is particle nought, a quarter of the panel is modelled.
        assert!((-4.0 * read.get("reaction")[2] - load).abs() < 1e-9 * load.abs().max(1.0));
    }
}

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
        let files = FieldFiles::create(&folder, &wanted).unwrap();
        let mut sink = Looking { files, folder: folder.clone(), taken: 0, most };
        let outcome = run(&scene, &mut sink);
        let Ended::Diverged(Failure::Fields(error)) = &outcome.ended else { panic!("{:?}", outcome.ended) };
        assert!(error.path.ends_with(&format!("shell-{most:04}.vtu")), "{error}");
        assert_eq!(outcome.summary.frames as usize, most);
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

#[test]
fn a_second_run_leaves_nothing_of_the_first() {
    let folder = folder("again");
    let scene = scene("patch-test.toml", &[HINGE, ("analysis.static.levels", "5")]);
    run(&scene, &mut FieldFiles::create(&folder, &EVERYTHING).unwrap());
    fs::write(folder.join("shell-0001.vtu.part"), "half").unwrap();
    fs::write(folder.join("shell-notes.vtu"), "mine").unwrap();
    let wanted = Fields { every: 5, extruded: false, stresses: false };
    let mut files = FieldFiles::create(&folder, &wanted).unwrap();
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
    assert!(svg.contains(">von_mises_top<") && svg.contains(">plot, frame 2 at 1<"));

    let picture = out.join("first.svg");
    let more = ["--frame", "0", "--field", "displacement.z", "--view", "-30,20", "--out"];
    assert_eq!(
        coque(&[&["plot", &place][..], &more, &[&picture.to_string_lossy()]].concat()).status.code(),
        Some(0)
    );
    assert!(fs::read_to_string(&picture).unwrap().contains("frame 0 at 0"));
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

#[test]
fn no_frame_at_all_is_refused() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes/patch-test.toml");
    let text = fs::read_to_string(path).unwrap() + "\n[output.fields]\nevery = 0\n";
    let error = Scene::parse(&text, "patch-test.toml").unwrap_err();
    assert_eq!(error.to_string(), "`output.fields.every` is 0; it must be 1 or more");
}
