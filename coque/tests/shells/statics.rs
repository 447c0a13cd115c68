//! Analyses without time: against the explicit run, published and closed-form answers, and their refusals.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::f64::consts::{PI, TAU};
use std::fs;
use std::path::Path;
use std::process::Command;

use crate::common::{column, ran, run, scene, scenes};
use coque::{Ended, Failure, LevelSummary, Outcome, Rendering, Scene, render};

/// Every level tells its factorisations and solves; together they are those of the path. A factor is kept while it serves.
#[test]
fn levels_tell_what_they_took() {
    let outcome = run(
        "ring.toml",
        &[("analysis", "{ static = { levels = 4 } }"), ("geometry.plate.particles", "[25, 5]")],
    );
    let record = &outcome.summary.record;
    let all = |of: fn(&LevelSummary) -> Option<u64>| {
        record.levels.iter().map(|level| of(level).unwrap()).sum::<u64>()
    };
    let (factors, solves) = (all(|level| level.factorisations), all(|level| level.solves));
    println!("{factors} factorisations, {solves} solves, {} iterations", record.newton_iterations);
    assert_eq!(record.levels.len(), 4);
    assert!(factors > 4 && (factors, solves) == (record.factorisations, record.solves));
    assert!(solves >= record.newton_iterations);
}

fn strip(rest: &str) -> Outcome {
    ran(Scene::parse(&format!("{STRIP}{rest}"), "strip.toml"))
}

/// A cantilever strip without Poisson's ratio: a beam.
const STRIP: &str = r#"
title = "Strip"
units = { length = "m", force = "N", time = "s" }
geometry.plate = { lengths = [10.0, 1.0], particles = [41, 5] }
material.elastic = { young = 12e6, poisson = 0.0, density = 10.0 }
section.homogeneous.thickness = 0.1
"#;
const CLAMPED: &str = "supports = [{ on = \"u0\", clamped = {} }]\n";
const LENGTH: f64 = 10.0;
/// E b h³ / 12 \[N m²\].
const EI: f64 = 1000.0;
/// ρ b h \[kg/m\].
const RHO_A: f64 = 1.0;

/// Distance of the ring's tip from where the exact arc ends, in units of L = 10.
fn tip_error(outcome: &Outcome, row: usize) -> f64 {
    let theta = TAU * outcome.curve.rows[row][0];
    let exact = [10.0 - 10.0 / theta * libm::sin(theta), 10.0 / theta * (1.0 - libm::cos(theta))];
    let found = [column(outcome, "minus_U_tip")[row], column(outcome, "W_tip")[row]];
    libm::hypot(found[0] - exact[0], found[1] - exact[1]) / 10.0
}

#[test]
fn the_ring_closes_without_time() {
    let outcome = run("ring.toml", &[("analysis.static.levels", "4")]);
    assert_eq!(outcome.ended, Ended::Done);
    // The errors of the explicit run on the same particles, to the digits of its table.
    for (row, explicit) in [(1, 3.8e-5), (2, 11.4e-5), (3, 11.6e-5), (4, 0.2e-5)] {
        assert!((tip_error(&outcome, row) - explicit).abs() < 1e-5, "{row}: {}", tip_error(&outcome, row));
    }
    assert!((column(&outcome, "rotation_tip")[4] / TAU - 1.0).abs() < 1e-5);
    assert_eq!(column(&outcome, "level"), [0.0, 0.25, 0.5, 0.75, 1.0]);
    assert_eq!(outcome.shapes.len(), 5);
    assert_eq!(outcome.summary.analysis, "static");
    let iterations: f64 = column(&outcome, "iterations").iter().sum();
    assert_eq!(outcome.summary.record.newton_iterations, iterations as u64);
    assert_eq!(outcome.summary.particle_steps_per_second, 0.0);
}

#[test]
fn time_changes_no_equilibrium() {
    let coarse = ("geometry.plate.particles", "[25, 3]");
    let explicit = run("ring.toml", &[coarse, ("analysis.explicit.quasi-static.levels", "2")]);
    let found = run("ring.toml", &[coarse, ("analysis.static.levels", "2")]);
    for name in ["minus_U_tip", "W_tip"] {
        let (slow, direct) = (column(&explicit, name), column(&found, name));
        assert!((slow.last().unwrap() - direct.last().unwrap()).abs() < 1e-3 * LENGTH, "{name}");
    }
}

#[test]
fn a_relaxation_takes_a_tenth_of_the_evaluations_of_a_march() {
    let coarse = ("geometry.plate.particles", "[25, 3]");
    let relaxed = |threads: usize| {
        let scene = scene("ring.toml", &[coarse, ("analysis.relaxation.levels", "8")]).unwrap();
        scene.build(threads).unwrap().run(&mut coque::Silent)
    };
    let (one, two) = (relaxed(1), relaxed(2));
    assert_eq!(one.curve.rows, two.curve.rows, "bits change with the threads");
    let evaluations = |outcome: &Outcome| -> u64 {
        outcome.summary.record.levels.iter().filter_map(|level| level.evaluations).sum()
    };
    let marched = run("ring.toml", &[coarse]);
    let (few, many) = (evaluations(&one), evaluations(&marched));
    println!("{few} evaluations against {many}");
    assert!(10 * few < many && one.summary.record.steps == few, "{few} against {many}");
    let exact = run("ring.toml", &[coarse, ("analysis.static.levels", "8")]);
    for name in ["minus_U_tip", "W_tip"] {
        let off = |outcome: &Outcome| -> f64 {
            let pairs = column(outcome, name).into_iter().zip(column(&exact, name));
            pairs.fold(0.0, |most, (found, exact)| most.max((found - exact).abs() / LENGTH))
        };
        println!("{name}: {:.1e} of L off, marched {:.1e}", off(&one), off(&marched));
        assert!(off(&one) < off(&marched).max(1e-6), "{name}");
    }
}

#[test]
fn the_crown_of_the_panel_is_pushed_to_its_levels() {
    // 2, 6 and 11 mm of 30; the loads of the explicit ramp and hold \[N\].
    let levels = ("analysis.static.levels", "[0.06666666666666667, 0.2, 0.36666666666666664]");
    let outcome = run("panel.toml", &[levels]);
    assert_eq!(outcome.ended, Ended::Done);
    assert_eq!(outcome.curve.columns[0].title(), "level [-]");
    for ((w, p), (wanted, load)) in column(&outcome, "w_crown").iter().zip(column(&outcome, "P")).zip([
        (0.0, 0.0),
        (2.0, 707.9),
        (6.0, 1721.9),
        (11.0, 2222.2),
    ]) {
        assert!((w - wanted).abs() < 1e-9, "{w}");
        assert!((p - load).abs() <= 2e-3 * load, "{w}: {p}");
    }
    // At 11 mm the force has just passed its maximum.
    assert_eq!(column(&outcome, "negative_pivots"), [0.0, 0.0, 0.0, 1.0]);
    assert_eq!(outcome.summary.record.critical[0].kind, "limit point");
}

#[test]
fn the_arc_passes_the_limit_point_of_the_panel() {
    let stop = ("analysis.arc-length", "{ stop = { column = \"w_crown\", above = 20.0 }, steps = 200 }");
    let outcome = run("panel.toml", &[stop, ("geometry.cylinder.particles", "[15, 15]")]);
    assert_eq!(outcome.ended, Ended::Done, "{}", outcome.summary.ended);
    assert_eq!(outcome.curve.columns[0].title(), "level [N]");
    let limit = &outcome.summary.record.critical[0];
    assert_eq!(limit.kind, "limit point");
    // A quarter of the force on the whole panel.
    assert!((4.0 * limit.level / 2222.0 - 1.0).abs() < 5e-3, "{limit:?}");
    let (level, reaction) = (column(&outcome, "level"), column(&outcome, "P"));
    // The reaction at the crown is the force that drives it.
    assert!(level.iter().zip(&reaction).all(|(l, p)| (4.0 * l - p).abs() < 1e-5 * 2222.0));
    let top = level.iter().copied().fold(0.0, f64::max);
    assert!(top <= limit.level * (1.0 + 1e-9) && *level.last().unwrap() < 0.9 * top);
    assert!(*column(&outcome, "w_crown").last().unwrap() > 20.0);
    assert_eq!(outcome.shapes.len(), outcome.curve.rows.len());
}

#[test]
fn a_load_path_ends_exactly_at_its_level() {
    let outcome = run(
        "ring.toml",
        &[("geometry.plate.particles", "[25, 3]"), ("analysis.arc-length", "{ until = 0.3 }")],
    );
    assert_eq!(outcome.ended, Ended::Done, "{}", outcome.summary.ended);
    assert!((column(&outcome, "level").last().unwrap() - 0.3).abs() < 1e-12);
}

#[test]
fn a_path_out_of_steps_says_so() {
    let path = ("analysis.arc-length", "{ until = 1.0, steps = 3 }");
    let outcome = run("ring.toml", &[("geometry.plate.particles", "[25, 3]"), path]);
    assert!(matches!(outcome.ended, Ended::Diverged(Failure::Steps { steps: 3, .. })));
    assert_eq!(outcome.curve.rows.len(), 4);
}

#[test]
fn a_level_that_is_not_reached_keeps_the_curve() {
    let push = "loads = [{ on = \"u1\", force = { total = [0.0, 0.0, 1.0] } }]\n";
    // One iteration is enough where the answer is linear: steps so short that the bend of the path leaves nothing, and too many.
    let outcome =
        strip(&format!("{CLAMPED}{push}analysis.static = {{ levels = [1e-12, 1.0], iterations = 1 }}"));
    let ended = &outcome.summary.ended;
    assert!(matches!(outcome.ended, Ended::Diverged(Failure::Steps { .. })), "{ended}");
    assert_eq!(column(&outcome, "level"), [0.0, 1e-12]);
    for word in ["1000 steps", "at level 0.000000000001", "arc-length", "`iterations`"] {
        assert!(ended.contains(word), "{ended}");
    }
}

#[test]
fn a_cantilever_vibrates() {
    let outcome = strip(&format!("{CLAMPED}analysis.modal.modes = 3"));
    assert_eq!(outcome.ended, Ended::Done, "{}", outcome.summary.ended);
    assert_eq!(outcome.curve.columns[1].title(), "circular_frequency [1/s]");
    let omega = column(&outcome, "circular_frequency");
    // (βL)² of the first two bending modes; between them the plate may twist or sway.
    let exact = |beta2: f64| beta2 * (EI / RHO_A).sqrt() / (LENGTH * LENGTH);
    assert!((omega[0] / exact(3.516) - 1.0).abs() < 0.02, "{omega:?} {}", exact(3.516));
    assert!(omega.windows(2).all(|pair| pair[0] <= pair[1]));
    assert!((column(&outcome, "frequency")[0] * TAU - omega[0]).abs() < 1e-9 * omega[0]);
    // A tenth of the diagonal.
    let tip = outcome.shapes[0].positions.iter().map(|x| x.z.abs()).fold(0.0, f64::max);
    assert!((tip / (0.1 * 101f64.sqrt()) - 1.0).abs() < 1e-6, "{tip}");
}

#[test]
fn a_free_strip_has_six_modes_without_frequency() {
    let outcome = strip("analysis.modal.modes = 7");
    assert_eq!(outcome.ended, Ended::Done, "{}", outcome.summary.ended);
    let omega = column(&outcome, "circular_frequency");
    let bending = 22.373 * (EI / RHO_A).sqrt() / (LENGTH * LENGTH);
    assert!(omega[..6].iter().all(|&w| w < 1e-2 * bending), "{omega:?} {bending}");
    assert!((omega[6] / bending - 1.0).abs() < 0.02, "{omega:?} {bending}");
}

#[test]
fn a_column_buckles() {
    let push = "loads = [{ on = \"u1\", force = { total = [-1.0, 0.0, 0.0] } }]\n";
    let outcome = strip(&format!("{CLAMPED}{push}analysis.buckling.modes = 2"));
    assert_eq!(outcome.ended, Ended::Done, "{}", outcome.summary.ended);
    let level = column(&outcome, "level");
    let exact = PI * PI * EI / (4.0 * LENGTH * LENGTH);
    assert!((level[0] / exact - 1.0).abs() < 0.02, "{level:?} {exact}");
    // The second mode has three quarter waves.
    assert!((level[1] / (9.0 * exact) - 1.0).abs() < 0.02, "{level:?} {exact}");
    assert_eq!(outcome.shapes.len(), 2);
}

#[test]
fn a_mechanism_is_named() {
    // Held against rigid motion by the corners' directors alone, the pushed strip still turns like a door.
    let held = "supports = [{ on = \"u0\", hinged = {} }]\n";
    let push = "loads = [{ on = \"u1\", force = { total = [0.0, 0.0, 1.0] } }]\n";
    let refused = Scene::parse(&format!("{STRIP}{held}{push}analysis.static.levels = 1"), "strip.toml")
        .and_then(|scene| scene.build(1));
    assert!(refused.unwrap_err().to_string().contains("rotation about the line"));
}

/// Name, file, overrides.
type Case<'a> = (&'a str, &'a str, &'a [(&'a str, &'a str)]);

#[test]
fn what_does_not_go_without_time_is_refused() {
    let levels = ("analysis.static.levels", "4");
    let path = ("analysis.arc-length.until", "1.0");
    let cases: [Case; 17] = [
        ("no levels", "ring.toml", &[("analysis.static.levels", "[]")]),
        ("levels backwards", "ring.toml", &[("analysis.static.levels", "[1.0, 0.5]")]),
        ("unknown key", "ring.toml", &[levels, ("analysis.static.period", "1.0")]),
        ("missing levels", "ring.toml", &[("analysis", "{ static = {} }")]),
        ("loose tolerance", "ring.toml", &[levels, ("analysis.static.tolerance", "1.0")]),
        ("no iterations", "ring.toml", &[levels, ("analysis.static.iterations", "0")]),
        ("no end", "ring.toml", &[("analysis.arc-length.steps", "10")]),
        (
            "two ends",
            "ring.toml",
            &[path, ("analysis.arc-length.stop", "{ column = \"level\", above = 1.0 }")],
        ),
        (
            "unknown column",
            "ring.toml",
            &[("analysis.arc-length.stop", "{ column = \"W_tipp\", above = 1.0 }")],
        ),
        ("no radius", "ring.toml", &[path, ("analysis.arc-length.radius", "0.0")]),
        ("no steps", "ring.toml", &[path, ("analysis.arc-length.steps", "0")]),
        ("no modes", "ring.toml", &[("analysis.modal.modes", "0")]),
        ("no tangent", "ring.toml", &[levels, ("formulation", "{ strong-form = {} }")]),
        ("nothing drives", "ring.toml", &[levels, ("loads", "[]")]),
        ("course in time", "ring.toml", &[levels, ("loads[0].amplitude", "{ ramp = 1.0 }")]),
        ("motion of zero", "panel.toml", &[levels, ("supports[3].moved.by", "0.0")]),
        ("held motion", "panel.toml", &[levels, ("supports[3].moved.direction", "[1.0, 0.0, -1.0]")]),
    ];
    let mut all = String::new();
    for (name, file, replaced) in cases {
        let message = match scene(file, replaced).and_then(|scene| scene.build(1)) {
            Ok(_) => "not refused".into(),
            Err(error) => render(&error, Rendering { width: 100, colour: false }),
        };
        all.push_str(&format!("━━━ {name} ━━━\n{}\n", message.trim_end()));
    }
    assert!(!all.contains("not refused"), "{all}");
    insta::assert_snapshot!(all);
}

#[test]
fn the_command_runs_a_scene_without_time() {
    let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join("statics");
    let out = out.to_string_lossy();
    let coque = |more: &[&str]| {
        let all = [
            &["run", "scenes/panel.toml", "--out", &out, "--set", "geometry.cylinder.particles=[9, 9]"],
            more,
        ];
        Command::new(env!("CARGO_BIN_EXE_coque"))
            .args(all.concat())
            .current_dir(scenes().join(".."))
            .output()
            .unwrap()
    };
    let done = coque(&["--set", "analysis.static.levels=[0.1, 0.4]"]);
    assert_eq!(done.status.code(), Some(0), "{}", String::from_utf8_lossy(&done.stderr));
    let curve = fs::read_to_string(Path::new(&*out).join("curve.csv")).unwrap();
    assert!(curve.starts_with("level [-],internal [N mm],iterations [-],negative_pivots [-],w_crown [mm]"));
    // The scene's plot of probes is left out among modes.
    let modes = coque(&["--set", "analysis.modal.modes=2"]);
    assert_eq!(modes.status.code(), Some(0), "{}", String::from_utf8_lossy(&modes.stderr));
    let early = coque(&["--set", "analysis.arc-length={ until = 1e6, steps = 2 }"]);
    assert_eq!(early.status.code(), Some(3));
    assert!(String::from_utf8_lossy(&early.stderr).contains("allow more `steps`"));
}

#[test]
fn a_run_that_cannot_converge_tells_where_and_keeps_its_rows() {
    let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join("absurd");
    let _ = fs::remove_dir_all(&out);
    // A millionth of an absurd force is found, all of it is not within two iterations a step.
    let replaced = [
        "geometry.plate.particles=[11, 3]",
        "loads[0].force.total=[0, 0, 4e6]",
        "analysis.static.levels=[1e-12, 1]",
        "analysis.static.iterations=2",
    ];
    let mut command = Command::new(env!("CARGO_BIN_EXE_coque"));
    command.args(["run", "scenes/cantilever-end-shear.toml", "--out", &out.to_string_lossy()]);
    for pair in replaced {
        command.args(["--set", pair]);
    }
    let failed = command.current_dir(scenes().join("..")).output().unwrap();
    assert_eq!(failed.status.code(), Some(3));
    let message = String::from_utf8_lossy(&failed.stderr).into_owned();
    for part in [
        "the last at level 0.000000000001",
        "step 1, load level",
        "residual ",
        "above the bound",
        "after 2 iterations",
    ] {
        assert!(message.contains(part), "{part} is missing: {message}");
    }
    let curve = fs::read_to_string(out.join("curve.csv")).unwrap();
    let rows: Vec<&str> = curve.lines().collect();
    assert_eq!(rows.len(), 3, "{curve}");
    assert!(rows[2].starts_with("1e-12,"), "{curve}");
}

#[test]
fn rolled_strips_are_stable_whatever_their_rows() {
    // Narrow lattices leave the loaded end few neighbours: without the swirl of directors and the thick shell's share of
    // the control it gives way (docs/zero-energy-control.md).
    for particles in ["[25, 3]", "[49, 3]", "[99, 3]", "[50, 5]"] {
        let levels = ("analysis.static.levels", "8");
        let outcome = run("ring.toml", &[levels, ("geometry.plate.particles", particles)]);
        assert_eq!(outcome.ended, Ended::Done, "{particles}: {}", outcome.summary.ended);
        assert_eq!(column(&outcome, "negative_pivots").last(), Some(&0.0), "{particles}");
        assert!(
            outcome.summary.record.critical.is_empty(),
            "{particles}: {:?}",
            outcome.summary.record.critical
        );
    }
}
