//! Fields out: what a frame holds, and in which order frames come.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::fs;
use std::path::Path;

use crate::common::fields::{EVERYTHING, HINGE, Read, folder, listed, names, run, scene};
use coque::{Ended, FieldError, FieldFiles, FieldRequest, FieldSink, Frame, Scene, State};
use sph_core::{Cell, Cloud, Vec3};

/// Uniform tension F on a sheet b wide: every cell carries N = F/b along x, the faces σ = F/(bt), whatever its frame.
#[test]
fn a_frame_of_the_patch_test_reads_back() {
    let folder = folder("patch");
    let scene = scene("patch-test.toml", &[]);
    let outcome = run(&scene, &mut FieldFiles::create(&folder, FieldFiles::LONE, &EVERYTHING).unwrap());
    assert_eq!((outcome.ended, outcome.summary.record.frames), (Ended::Done, 2));
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
        // The strain of 1e-5 is what small strain leaves out; bending of the flat sheet is zero.
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
    let shell = sph_shell::Shell::builder(sph_shell::Parts {
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
    .build()
    .unwrap();
    let units = coque::Units {
        length: coque::Length::Metre,
        force: coque::Force::Newton,
        time: coque::Time::Second,
        by_depth: false,
    };
    let shown = FieldRequest {
        state: State::Balance,
        units,
        stresses: false,
        indicator: false,
        contact: false,
        of_stresses: coque::StressFields::default(),
        driven: None,
        forces: None,
    };
    let (case, envelope) = (None, None);
    let frame = Frame { body: &shell, shown, along: 0.0, level: 0.0, time: 0.0, case, envelope };
    FieldFiles::create(&folder, FieldFiles::LONE, &EVERYTHING).unwrap().frame(&frame).unwrap();
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
        self.0.push((frame.shown.state, frame.along, frame.level));
        Ok(())
    }
}

#[test]
fn frames_come_at_levels_records_points_and_modes() {
    let noted = |name: &str, replaced: &[(&str, &str)]| {
        let mut sink = Noted::default();
        let outcome = run(&scene(name, replaced), &mut sink);
        assert_eq!(outcome.summary.record.frames as usize, sink.0.len());
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
    let outcome = run(
        &scene,
        &mut FieldFiles::create(&folder, FieldFiles::LONE, &scene.output.fields.unwrap()).unwrap(),
    );
    assert!(outcome.summary.body.left_out.iter().any(|line| line.contains("stresses of modes")));
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
    let outcome = run(&scene, &mut FieldFiles::create(&folder, FieldFiles::LONE, &EVERYTHING).unwrap());
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
    let outcome = run(&scene, &mut FieldFiles::create(&folder, FieldFiles::LONE, &EVERYTHING).unwrap());
    let loads = outcome.curve.column("P").unwrap();
    for ((_, path), load) in listed(&folder.join("shell.pvd")).iter().zip(loads) {
        let read = Read::new(path);
        // The crown is particle zero, a quarter of the panel is modelled.
        assert!((-4.0 * read.get("reaction")[2] - load).abs() < 1e-9 * load.abs().max(1.0));
    }
}

#[test]
fn no_frame_at_all_is_refused() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes/patch-test.toml");
    let text = fs::read_to_string(path).unwrap() + "\n[output.fields]\nevery = 0\n";
    let error = Scene::parse(&text, "patch-test.toml").unwrap_err();
    assert_eq!(error.to_string(), "`output.fields.every` is 0; it must be 1 or more");
}
