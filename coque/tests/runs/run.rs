//! Runs: exact answers of the small scenes, turned frames, threads, divergence, and the command itself.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use crate::common::{column, last, ran, run, scene, scenes};
use coque::{Ended, Scene, Silent};

#[test]
fn patch_test_strains_uniformly() {
    let outcome = run("patch-test.toml", &[]);
    assert_eq!(outcome.ended, Ended::Done);
    assert!(outcome.summary.record.levels.iter().all(|level| level.settled));
    // Exact for small strain; the strain of 1e-5 itself is the relative size of what that leaves out.
    assert!((last(&outcome, "U_end") / 2e-5 - 1.0).abs() < 5e-5);
    assert!((last(&outcome, "V_side") / -3e-6 - 1.0).abs() < 5e-5);
    let levels: Vec<f64> = outcome.shapes.iter().map(|shape| shape.level).collect();
    assert_eq!(levels, [0.0, 1.0]);
    assert_eq!(outcome.shapes[1].positions.len(), 45);
}

#[test]
fn a_turned_scene_answers_the_same() {
    let turn = ("orientation", "{ axis = [1.0, -2.0, 0.5], degrees = 73.0 }");
    let (straight, turned) = (run("patch-test.toml", &[]), run("patch-test.toml", &[turn]));
    for column in ["U_end", "V_side", "internal"] {
        // Rounding of positions of size 1 against displacements of 1e-6.
        assert!((last(&turned, column) / last(&straight, column) - 1.0).abs() < 1e-7, "{column}");
    }
}

#[test]
fn threads_change_no_bit() {
    // Large enough to be split between threads; short enough to be quick.
    let replaced = [
        ("geometry.plate.particles", "[49, 33]"),
        ("analysis.explicit", "{ transient = { duration = 0.05, record_every = 0.01 } }"),
        ("supports[2]", "{ on = \"u0v0\", hinged = {} }"),
    ];
    let (one, three) = (
        run("patch-test.toml", &replaced),
        scene("patch-test.toml", &replaced).unwrap().build(3).unwrap().run(&mut Silent),
    );
    assert_eq!(one.curve.rows.len(), 6);
    assert_eq!(one.curve, three.curve);
}

#[test]
fn a_motion_follows_its_course_in_time() {
    let replaced = [
        ("analysis.explicit", "{ transient = { duration = 0.003, record_every = 0.001 } }"),
        ("supports[3].amplitude", "{ ramp = 0.003 }"),
        ("geometry.cylinder.particles", "[11, 11]"),
    ];
    let crown = column(&run("panel.toml", &replaced), "w_crown");
    for (reached, wanted) in crown.iter().zip([0.0, 10.0, 20.0, 30.0]) {
        assert!((reached - wanted).abs() < 1e-9, "{crown:?}");
    }
}

#[test]
fn the_ring_closes() {
    // A coarse ring: at the full circle the chords of its cells close, whatever their number.
    let replaced = [("geometry.plate.particles", "[25, 3]"), ("analysis.explicit.quasi-static.levels", "4")];
    let outcome = run("ring.toml", &replaced);
    assert!((last(&outcome, "minus_U_tip") - 10.0).abs() < 0.005, "{}", last(&outcome, "minus_U_tip"));
    assert!(last(&outcome, "W_tip").abs() < 0.005);
    // The tip has turned once; the rotation is counted on past π.
    assert!((last(&outcome, "rotation_tip") / std::f64::consts::TAU - 1.0).abs() < 1e-4);
}

#[test]
fn a_couple_about_the_moving_edge_bends_the_same() {
    let coarse = ("geometry.plate.particles", "[25, 3]");
    let levels = ("analysis.explicit.quasi-static.levels", "[0.5]");
    // The edge runs along +y, the fixed axis of the scene along −y.
    let edge = ("loads[0].couple", "{ moment = -62.83185307179586, axis = \"edge\" }");
    let (fixed, moving) = (run("ring.toml", &[coarse, levels]), run("ring.toml", &[coarse, levels, edge]));
    assert!((last(&fixed, "W_tip") - last(&moving, "W_tip")).abs() < 1e-3);
}

#[test]
fn a_scene_with_everything_keeps_its_energy_balance() {
    let outcome = ran(Scene::parse(EVERYTHING, "test.toml"));
    assert_eq!(outcome.ended, Ended::Done);
    assert_eq!(outcome.curve.rows.len(), 101);
    let energies = outcome.summary.record.energies;
    // Central differences keep the balance to second order of the step; 1e-4 is far above, a lost load far below.
    assert!(energies.balance_error.abs() < 1e-4 * energies.external.abs(), "{energies:?}");
}

/// Sphere, disorder, regions, diaphragm, every kind of load with a course in time.
const EVERYTHING: &str = r#"
title = "Part of a sphere"
units = { length = "-", force = "-", time = "-" }
orientation = { axis = [1.0, 2.0, 3.0], degrees = 40.0 }
geometry.sphere = { radius = 10.0, polar = [18.0, 90.0], azimuth = [0.0, 90.0], particles = [13, 13], disorder = { fraction = 0.2, seed = 3 } }
material.elastic = { young = 1e4, poisson = 0.3, density = 1.0 }
section.homogeneous = { thickness = 0.2, gauss_points = 2 }
sets.low = { box = { min = [0.0, 0.0, -0.01], max = [20.0, 20.0, 0.01] } }
sets.top = { nearest = [0.0, 0.0, 10.0] }
supports = [{ on = "low", diaphragm = { axis = [0.0, 0.0, 1.0] } }]
loads = [
    { on = "all", pressure = { value = 0.1, follower = true }, amplitude = { table = [[0.0, 0.0], [1.0, 1.0]] } },
    { on = "all", gravity = { acceleration = [0.0, 0.0, -1.0] }, amplitude = { sine = { period = 2.0 } } },
    { on = "top", force = { total = [0.0, 0.0, -0.1] }, amplitude = { ramp = 0.5 } },
    { on = "u0", couple = { moment = 0.1, axis = "edge" }, amplitude = { smooth = 1.0 } },
]
analysis.explicit.transient = { duration = 2.0, record_every = 0.02, damping = 0.1 }
curve = [
    { name = "w", of = "position", on = "top", direction = [0.0, 0.0, 1.0] },
    { name = "R", of = "reaction", on = "low", direction = [1.0, 0.0, 0.0] },
    { name = "d", of = "director", on = "top", direction = [0.0, 0.0, 1.0] },
]
"#;

#[test]
fn divergence_keeps_the_curve() {
    let outcome = run("patch-test.toml", &[("loads[0].force.total[0]", "1e9")]);
    assert!(matches!(outcome.ended, Ended::Diverged(_)));
    assert!(!outcome.curve.rows.is_empty());
    assert!(outcome.summary.ended.contains("particle"), "{}", outcome.summary.ended);
}

fn coque(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_coque"))
        .args(arguments)
        .current_dir(scenes().join(".."))
        .output()
        .unwrap()
}

#[test]
fn the_command_writes_results_and_tells_by_its_exit_code() {
    let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join("patch-test");
    let out = out.to_string_lossy();
    let plot = "output.plot={ x = \"time\", y = \"U_end\" }";
    let done = coque(&["run", "scenes/patch-test.toml", "--out", &out, "--set", plot]);
    assert_eq!(done.status.code(), Some(0), "{}", String::from_utf8_lossy(&done.stderr));
    let curve = fs::read_to_string(Path::new(&*out).join("curve.csv")).unwrap();
    assert!(curve.starts_with(
        "time [s],level [-],kinetic [N m],internal [N m],external [N m],dissipated [N m],U_end [m]"
    ));
    assert!(fs::read_to_string(Path::new(&*out).join("curve.svg")).unwrap().starts_with("<svg"));
    let summary = fs::read_to_string(Path::new(&*out).join("summary.json")).unwrap();
    let summary: serde_json::Value = serde_json::from_str(&summary).unwrap();
    assert_eq!(summary["particles"], 45);
    assert_eq!(summary["ended"], "done");

    let bad = coque(&["run", "scenes/patch-test.toml", "--out", &out, "--set", "material.elastic.yuong=1"]);
    assert_eq!(bad.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&bad.stderr).contains("did you mean `young`?"));

    let missing = coque(&["run", "scenes/no-such-scene.toml"]);
    assert_eq!(missing.status.code(), Some(2));

    let diverged =
        coque(&["run", "scenes/patch-test.toml", "--out", &out, "--set", "loads[0].force.total[0]=1e9"]);
    assert_eq!(diverged.status.code(), Some(3));
    assert!(String::from_utf8_lossy(&diverged.stderr).contains("particle"));
}
